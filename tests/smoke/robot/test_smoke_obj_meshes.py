"""pybullet is given copies of OBJ meshes: the files that a mesh names may be anywhere."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest
from smoking_engines import needs_pybullet

from urdfctl.smoke.engines.engine import EngineSetup, RobotRejected, open_engine
from urdfctl.smoke.engines.obj_meshes import with_own_meshes

CUBE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
FACES = "f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
SHAPE = '<collision><geometry><mesh filename="{}" scale="1 1 1"/></geometry></collision>'
INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'


def robot(path: Path | str) -> str:
    return f'<robot name="robot">\n<link name="a">{INERTIAL}{SHAPE.format(path)}</link>\n</robot>\n'


def test_a_copy_has_the_shape_and_names_no_other_file(tmp_path: Path) -> None:
    source = tmp_path / "a & b.OBJ"
    source.write_text(f"mtllib /home/x/.netrc\nmtllib ../m.mtl\n{CUBE}usemtl red\n{FACES}\r\nmap_Kd /home/x/.netrc\n")
    (tmp_path / "made").mkdir()
    text = with_own_meshes(robot(str(source).replace("&", "&amp;")), str(tmp_path / "made"))
    assert text == robot(tmp_path / "made" / "mesh0.obj")
    assert (tmp_path / "made" / "mesh0.obj").read_text() == f"{CUBE}g red\n{FACES}"


def test_meshes_of_other_kinds_stay_where_they_are(tmp_path: Path) -> None:
    assert with_own_meshes(robot("/x/a.stl"), str(tmp_path)) == robot("/x/a.stl")


def test_a_mesh_that_is_gone_is_a_reason_to_refuse_the_robot(tmp_path: Path) -> None:
    with pytest.raises(RobotRejected, match=r"'gone.obj' cannot be read: No such file or directory"):
        with_own_meshes(robot(tmp_path / "gone.obj"), str(tmp_path))


@needs_pybullet
@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes in its file system")
def test_pybullet_opens_no_file_that_a_mesh_names(tmp_path: Path) -> None:
    """What reads from a pipe waits until somebody opens it for writing; here somebody does, and learns of it."""
    pipe, opened = tmp_path / "m.mtl", []
    os.mkfifo(pipe)

    def write() -> None:
        with open(pipe, "w", encoding="utf-8"):
            opened.append(True)

    writer = threading.Thread(target=write, daemon=True)
    writer.start()
    (tmp_path / "a.obj").write_text(f"mtllib {pipe}\n{CUBE}usemtl red\n{FACES}")
    open_engine("pybullet", EngineSetup(robot(tmp_path / "a.obj"), "a", fixed=True, start={})).close()
    assert opened == []
    os.close(os.open(pipe, os.O_RDONLY | os.O_NONBLOCK))
