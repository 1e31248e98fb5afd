"""Collision meshes in COLLADA files: read for formulas, and for MuJoCo, which cannot read them itself."""

from __future__ import annotations

from pathlib import Path

import pytest
from collada_meshes import SHOWN, dae
from smoke_robots import Rover
from smoking import checked, codes, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.config.settings import Settings
from urdfctl.load.loader import Loader
from urdfctl.smoke.robot.collada import corners_of_collada
from urdfctl.smoke.run import SmokeRequest


def extent(text: str) -> list[tuple[float, float]]:
    """Return the least and the greatest x, y and z."""
    columns = zip(*corners_of_collada(text.encode()), strict=True)
    return [(round(min(values), 6), round(max(values), 6)) for values in columns]


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (SHOWN, [(-1, 1), (-1, 1), (-1, 1)]),
        (f"<translate>1 2 3</translate>{SHOWN}", [(0, 2), (1, 3), (2, 4)]),
        (f"<scale>1 2 3</scale>{SHOWN}", [(-1, 1), (-2, 2), (-3, 3)]),
        (f"<rotate>0 0 1 90</rotate><scale>1 2 3</scale>{SHOWN}", [(-2, 2), (-1, 1), (-3, 3)]),
        (f"<matrix>1 0 0 5 0 2 0 0 0 0 1 0 0 0 0 1</matrix>{SHOWN}", [(4, 6), (-2, 2), (-1, 1)]),
        (f"<translate>1 0 0</translate><node><scale>2 2 2</scale>{SHOWN}</node>", [(-1, 3), (-2, 2), (-2, 2)]),
        ("", []),
    ],
)
def test_the_nodes_of_the_scene_place_the_mesh(node: str, expected: list[tuple[float, float]]) -> None:
    assert extent(dae(node)) == expected


def test_the_unit_counts_and_the_up_axis_does_not() -> None:
    assert extent(dae(SHOWN, "0 0 0 10 0 0 0 20 0 0 0 30", meter="0.01")) == [(0, 0.1), (0, 0.2), (0, 0.3)]


def test_a_node_of_the_library_can_be_shown() -> None:
    library = f'<library_nodes><node id="part"><scale>2 2 2</scale>{SHOWN}</node></library_nodes>'
    assert extent(dae('<instance_node url="#part"/>', more=library)) == [(-2, 2), (-2, 2), (-2, 2)]


@pytest.mark.parametrize("text", ["", "<COLLADA>", dae(SHOWN, "0 0 x"), dae('<node><instance_node url="#n"/></node>')])
def test_what_cannot_be_read_has_no_corners(text: str) -> None:
    assert corners_of_collada(text.encode()) == []


def rover(folder: Path, height: float) -> str:
    """Return a rover whose front caster is a box of 10 cm width, and of some height, in a DAE file."""
    (folder / "caster.dae").write_text(dae(f"<scale>0.05 0.05 {height / 2}</scale>{SHOWN}"), encoding="utf-8")
    mesh = f'<mesh filename="file://{folder}/caster.dae"/>'
    return Rover().urdf().replace('<sphere radius="0.05"/>', mesh, 1)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_rover_stands_on_a_mesh_of_a_dae_file(tmp_path: Path, engine: str) -> None:
    target = target_of(tmp_path, {"robot.urdf": rover(tmp_path, 0.1), "controllers.yaml": Rover().yaml()})
    made = whole(target, engine, distro="jazzy", workspace=str(tmp_path))
    assert codes(made) == []
    assert verdicts(made)["base"] == "passed deactivate"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_mesh_of_a_dae_file_that_reaches_too_deep_lifts_the_wheels(tmp_path: Path, engine: str) -> None:
    target = target_of(tmp_path, {"robot.urdf": rover(tmp_path, 0.2), "controllers.yaml": Rover().yaml()})
    assert "UC940" in codes(whole(target, engine, distro="jazzy", workspace=str(tmp_path)))


def test_the_formulas_read_meshes_of_dae_files_too(tmp_path: Path) -> None:
    target = target_of(tmp_path, {"robot.urdf": rover(tmp_path, 0.2), "controllers.yaml": Rover().yaml()})
    loader = Loader(Settings(distro="jazzy", workspace=str(tmp_path)))
    assert "UC940" in codes(checked(loader, target, SmokeRequest()).result)
