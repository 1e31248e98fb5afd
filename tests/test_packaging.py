"""The wheel holds the package and what it reads, and nothing else."""

from __future__ import annotations

import json
import subprocess
import sys
from email.parser import Parser
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from zipfile import ZipFile

import pytest
from folder import CHECKOUT

from urdfctl import __version__

pytest.importorskip("hatchling", reason="needs hatchling, which builds the wheel")


@lru_cache(1)
def wheel() -> dict[str, bytes]:
    """The files of the wheel that this checkout makes."""
    with TemporaryDirectory() as folder:
        subprocess.run(
            [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", folder],
            cwd=CHECKOUT,
            capture_output=True,
            check=True,
        )
        [path] = Path(folder).glob("*.whl")
        assert path.name == f"urdfctl-{__version__}-py3-none-any.whl"
        with ZipFile(path) as archive:
            return {name: archive.read(name) for name in archive.namelist()}


def test_it_holds_every_module_of_the_package() -> None:
    modules = {path.relative_to(CHECKOUT).as_posix() for path in (CHECKOUT / "urdfctl").rglob("*.py")}
    assert modules <= set(wheel())


@pytest.mark.parametrize(
    "name",
    [
        "urdfctl/py.typed",
        "urdfctl/report/lint.schema.json",
        "urdfctl/rules/README.md",
        "urdfctl/catalog/data/ros2/controllers.json",
        "urdfctl/catalog/data/ros2/controllers/joint_trajectory_controller.yaml",
        "urdfctl/catalog/data/provenance.yaml",
        "urdfctl/catalog/schema.json",
        "urdfctl/rules/transmissions/transmission_joint_without_interface.py",
        "urdfctl/templates/README.md",
    ],
)
def test_it_holds_what_the_package_reads_and_tells(name: str) -> None:
    assert name in wheel()


def test_it_holds_nothing_but_the_package_and_its_metadata() -> None:
    assert {name.split("/")[0] for name in wheel()} == {"urdfctl", f"urdfctl-{__version__}.dist-info"}
    assert not [name for name in wheel() if "__pycache__" in name or name.endswith((".pyc", ".orig", ".rej"))]


def test_the_schema_in_it_is_json() -> None:
    assert json.loads(wheel()["urdfctl/report/lint.schema.json"])["title"]


def test_its_metadata_name_the_command_the_licence_and_little_to_install() -> None:
    folder = f"urdfctl-{__version__}.dist-info"
    assert b"urdfctl = urdfctl.__main__:main" in wheel()[f"{folder}/entry_points.txt"]
    assert f"{folder}/licenses/LICENSE" in wheel()
    metadata = Parser().parsestr(wheel()[f"{folder}/METADATA"].decode())
    needed = [line.split(";")[0] for line in metadata.get_all("Requires-Dist", []) if "extra ==" not in line]
    names = {line.split("<")[0].split(">")[0].split("=")[0].strip() for line in needed}
    assert names == {"xacro", "pyyaml", "typer", "rich", "jinja2", "tomli"}
