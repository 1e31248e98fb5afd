"""Wheel and sdist hold the package and what it reads, nothing else, and are the same bytes each time."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tarfile
from email.parser import Parser
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from zipfile import ZipFile

import pytest
from folder import CHECKOUT

from urdfctl import __version__

pytest.importorskip("hatchling", reason="needs hatchling, which builds the wheel")


def build(folder: str, target: str, source: Path = CHECKOUT) -> Path:
    """A wheel or an sdist of some sources, in a folder; no network is needed."""
    command = [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", folder]
    subprocess.run(command, cwd=source, capture_output=True, check=True)
    [path] = Path(folder).glob("*.whl" if target == "wheel" else "*.tar.gz")
    return path


@lru_cache(1)
def wheel() -> dict[str, bytes]:
    """The files of the wheel that this checkout makes."""
    with TemporaryDirectory() as folder:
        path = build(folder, "wheel")
        assert path.name == f"urdfctl-{__version__}-py3-none-any.whl"
        with ZipFile(path) as archive:
            return {name: archive.read(name) for name in archive.namelist()}


def tracked(*folders: str) -> set[str]:
    """The files of the checkout that git knows, below some folders."""
    if shutil.which("git") is None or not (CHECKOUT / ".git").exists():
        pytest.skip("this is no checkout of git, which knows what belongs to it")
    listed = subprocess.run(["git", "ls-files", "-z", *folders], cwd=CHECKOUT, capture_output=True, check=True)
    return {name for name in listed.stdout.decode().split("\0") if name and (CHECKOUT / name).is_file()}


def test_the_wheel_holds_exactly_the_packages_files_and_the_templates() -> None:
    templates = {f"urdfctl/{name}" for name in tracked("templates")}
    held = {name for name in wheel() if ".dist-info/" not in name}
    assert held - tracked("urdfctl") - templates == set(), "git add what is new, or delete it"
    assert (tracked("urdfctl") | templates) - held == set()


def test_the_sdist_holds_what_a_release_is_tested_with_and_makes_the_same_wheel(tmp_path: Path) -> None:
    top = f"urdfctl-{__version__}"
    path = build(str(tmp_path), "sdist")
    with tarfile.open(path) as archive:
        archive.extractall(tmp_path, filter="data")
    held = {found.relative_to(tmp_path / top).as_posix() for found in (tmp_path / top).rglob("*") if found.is_file()}
    expected = {name for name in tracked() if not name.startswith((".ci/", ".github/")) and name != ".gitignore"}
    assert held - {".gitignore", "PKG-INFO"} - expected == set(), "git add what is new, or delete it"
    assert expected - held == set()
    with ZipFile(build(str(tmp_path / "again"), "wheel", tmp_path / top)) as archive:
        assert {name: archive.read(name) for name in archive.namelist()} == wheel()


@pytest.mark.parametrize("target", ["wheel", "sdist"])
def test_two_builds_are_the_same_bytes(target: str, tmp_path: Path) -> None:
    builds = [build(str(tmp_path / name), target).read_bytes() for name in "ab"]
    assert builds[0] == builds[1]


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
