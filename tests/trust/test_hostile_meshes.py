"""Meshes that strangers may put beside a robot: each is read or refused in little time, and reads nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from hostile.meshes import MESHES
from work import work

from urdfctl.smoke.robot.shapes import MOST_POINTS, corners_of
from urdfctl.view.meshes import NotAMesh, installed, packed, read_mesh

MOST_CALLS = 1_000_000
HIDDEN = "what nobody may read"


@pytest.mark.parametrize("name", MESHES)
def test_the_corners_of_a_hostile_mesh_are_few_and_cost_little_work(name: str, tmp_path: Path) -> None:
    kind, data = MESHES[name]
    path = tmp_path / f"part.{kind}"
    path.write_bytes(data)
    corners: list[object] = []
    assert work(lambda: corners.extend(corners_of(str(path)))) < MOST_CALLS
    assert len(corners) <= MOST_POINTS


@pytest.mark.skipif(not installed(), reason="the libraries that read meshes are not installed")
@pytest.mark.parametrize("name", MESHES)
def test_a_hostile_mesh_is_shown_or_refused_in_words(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kind, data = MESHES[name]
    (tmp_path / "secret").write_text(HIDDEN)
    (tmp_path / "secret.mtl").write_text(f"newmtl secret\n# {HIDDEN}\nKd 1 0 0\n")
    (tmp_path / "robot").mkdir()
    monkeypatch.chdir(tmp_path / "robot")
    said = ""

    def read() -> None:
        nonlocal said
        try:
            said = repr([packed(surface, 1.0) for surface in read_mesh(data, kind)])
        except NotAMesh as error:
            said = str(error)

    assert work(read) < 2 * MOST_CALLS
    assert said
    assert HIDDEN not in said
