"""Which links can touch, with meshes as the surfaces that they are: two plates do not touch what is between them."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import pytest

from urdfctl.model.robot import Robot
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.engines import contacts, touching_links
from urdfctl.smoke.robot import triangles_of_collada
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

pytest.importorskip("mujoco")
pytest.importorskip("fcl")

HALF = (1.0, 1.0, 0.02)
SIDES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
COLLADA = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit meter="{meter}"/></asset>
  <library_geometries><geometry id="plates"><mesh>
    <source id="places"><float_array id="values" count="{count}">{values}</float_array>
      <technique_common><accessor source="#values" count="{count}" stride="3"/></technique_common></source>
    <vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
    {faces}
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node><instance_geometry url="#plates"/></node></visual_scene>
  </library_visual_scenes></COLLADA>"""
INPUT = '<input semantic="VERTEX" source="#corners" offset="0"/><input semantic="NORMAL" source="#none" offset="1"/>'

Corner = tuple[float, float, float]


def plates() -> tuple[list[Corner], list[tuple[int, ...]]]:
    """Return the corners and the sides of two plates, one above the other."""
    corners, sides = [], []
    for height in (-0.5, 0.5):
        sides += [tuple(corner + len(corners) for corner in side) for side in SIDES]
        signs = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        corners += [(x * HALF[0], y * HALF[1], height + z * HALF[2]) for x, y, z in signs]
    return corners, sides


def stl() -> bytes:
    """Return the plates as a binary STL."""
    corners, sides = plates()
    triangles = [three for a, b, c, d in sides for three in ((a, b, c), (a, c, d))]
    rows = [struct.pack("<12fH", 0, 0, 0, *(part for one in row for part in corners[one]), 0) for row in triangles]
    return b"\0" * 80 + struct.pack("<I", len(rows)) + b"".join(rows)


def as_triangles(meter: str = "1") -> str:
    """Return the plates as COLLADA, in triangles."""
    triangles = [one for a, b, c, d in plates()[1] for one in (a, b, c, a, c, d)]
    return document(f'<triangles count="24">{INPUT}<p>{indices(triangles)}</p></triangles>', meter)


def as_polylist() -> str:
    """Return the plates as COLLADA, in a list of sides with four corners."""
    listed = [one for side in plates()[1] for one in side]
    return document(f'<polylist count="12">{INPUT}<vcount>{"4 " * 12}</vcount><p>{indices(listed)}</p></polylist>')


def as_polygons() -> str:
    """Return the plates as COLLADA, each side by itself."""
    rows = "".join(f"<p>{indices(list(side))}</p>" for side in plates()[1])
    return document(f'<polygons count="12">{INPUT}{rows}</polygons>')


def indices(corners: list[int]) -> str:
    """Return a row of corners, each with the number of a normal."""
    return " ".join(f"{corner} 0" for corner in corners)


def document(faces: str, meter: str = "1") -> str:
    """Return a COLLADA file with these faces of the plates."""
    values = " ".join(str(part / float(meter)) for corner in plates()[0] for part in corner)
    return COLLADA.format(meter=meter, count=len(values.split()), values=values, faces=faces)


def robot(mesh: Path) -> str:
    """Return plates that stand still, and a ball on an arm which turns between them."""
    inertial = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    ball = '<collision><origin xyz="0 {y} 0"/><geometry><sphere radius="0.1"/></geometry></collision>'
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    return f"""<robot name="plates">
  <link name="plates">{inertial}<collision><geometry><mesh filename="{mesh}"/></geometry></collision></link>
  <link name="arm">{inertial}{ball.format(y=3)}</link>
  <link name="ball">{inertial}{ball.format(y=0.2)}</link>
  <joint name="turn" type="revolute"><parent link="plates"/><child link="arm"/><axis xyz="0 0 1"/>{limit}</joint>
  <joint name="roll" type="revolute"><parent link="arm"/><child link="ball"/><axis xyz="0 0 1"/>{limit}</joint>
</robot>"""


def parsed(text: str) -> Robot:
    """Return a robot."""
    root = parse(SourceText("robot.urdf", text.encode())).documentElement
    assert root is not None
    return robot_of(root)


def reasons_of(text: str) -> dict[tuple[str, str], str]:
    """Return why pairs of links of a robot need no test."""
    _, touching = touching_links(parsed(text), str, 50, 1)
    return {(one, other): reason for one, other, reason in touching.pairs}


def reasons(mesh: Path) -> dict[tuple[str, str], str]:
    """Return why pairs of links need no test."""
    return reasons_of(robot(mesh))


@pytest.mark.parametrize("made", [as_triangles, as_polylist, as_polygons])
def test_the_faces_of_a_collada_file_are_triangles_between_its_corners(made: Callable[[], str]) -> None:
    points, faces = triangles_of_collada(made().encode())
    assert points == plates()[0]
    assert len(faces) == 24
    assert {corner for face in faces for corner in face} == {*range(16)}


def test_the_unit_of_a_collada_file_counts_for_its_faces() -> None:
    points, faces = triangles_of_collada(as_triangles("0.001").encode())
    assert points[0] == pytest.approx(plates()[0][0])
    assert len(faces) == 24


@pytest.mark.parametrize(
    "faces", ["<triangles><p>0</p></triangles>", f"<triangles>{INPUT}<p>0 0 1 0 99 0</p></triangles>"]
)
def test_faces_that_cannot_be_read_are_no_faces(faces: str) -> None:
    assert triangles_of_collada(document(faces).encode())[1] == []


@pytest.mark.parametrize("name", ["plates.stl", "plates.dae"])
def test_what_moves_between_two_plates_never_touches_them(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(stl() if name.endswith("stl") else as_polylist().encode())
    assert reasons(path)["plates", "ball"] == "Never"


def test_as_convex_hulls_the_plates_are_a_block_that_touches_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "plates.stl").write_bytes(stl())
    monkeypatch.setattr(contacts, "tests_surfaces", lambda: False)
    assert reasons(tmp_path / "plates.stl")["plates", "ball"] == "Default"


SLIDING = """<robot name="table">
  <link name="table"><collision><origin xyz="0 0 -0.05"/><geometry><box size="9 9 0.1"/></geometry></collision></link>
  <link name="rail"><collision><origin xyz="0 0 1"/><geometry><sphere radius="0.01"/></geometry></collision></link>
  <link name="block"><collision><origin xyz="0 0 {height}"/><geometry>{block}</geometry></collision></link>
  <joint name="along" type="prismatic"><parent link="table"/><child link="rail"/><axis xyz="1 0 0"/>
    <limit lower="-0.7" upper="0.7" effort="1" velocity="1"/></joint>
  <joint name="across" type="prismatic"><parent link="rail"/><child link="block"/><axis xyz="0 1 0"/>
    <limit lower="-0.7" upper="0.7" effort="1" velocity="1"/></joint>
</robot>"""


@pytest.mark.parametrize(("height", "reasons"), [(0.52, {"Default", "Always"}), (0.521, {"Never"})])
@pytest.mark.parametrize("block", ['<mesh filename="{path}"/>', '<cylinder radius="0.1" length="1.04"/>'])
def test_faces_that_slide_on_each_other_touch(block: str, height: float, reasons: set[str], tmp_path: Path) -> None:
    (tmp_path / "plates.stl").write_bytes(stl())
    text = SLIDING.format(block=block.format(path=tmp_path / "plates.stl"), height=height)
    assert reasons_of(text).get(("table", "block")) in reasons


def test_links_whose_faces_meet_only_where_the_joints_are_at_0_are_tested() -> None:
    lifted = SLIDING.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 0 1"/>')
    text = lifted.format(block='<cylinder radius="0.1" length="1.04"/>', height=0.52 + 1e-9)
    _, touching = touching_links(parsed(text), str, 50, 1)
    assert ("table", "block") not in {pair[:2] for pair in touching.pairs}
    assert touching.starting == ()


FOLLOWING = """<robot name="slides">
  <link name="base"><collision><origin xyz="0.6 0 0"/><geometry><box size="0.1 1 1"/></geometry></collision></link>
  <link name="first"/><link name="second"/>
  <link name="turned"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
  <link name="block"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="turned"/><axis xyz="1 0 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  {joints}
</robot>"""
SLIDE = """<joint name="{child}_slide" type="prismatic"><parent link="{parent}"/><child link="{child}"/>
  <axis xyz="1 0 0"/><limit lower="0" upper="{upper}" effort="1" velocity="1"/>{mimic}</joint>"""


@pytest.mark.parametrize(("last", "reason"), [('<mimic joint="second_slide"/>', "Never"), ("", None)])
def test_what_follows_a_follower_is_tested_where_the_first_joint_takes_it(last: str, reason: str | None) -> None:
    slides = [
        SLIDE.format(parent="base", child="first", upper=0.2, mimic=""),
        SLIDE.format(parent="base", child="second", upper=1, mimic='<mimic joint="first_slide"/>'),
        SLIDE.format(parent="turned", child="block", upper=1, mimic=last),
    ]
    assert reasons_of(FOLLOWING.format(joints="".join(slides))).get(("base", "block")) == reason
