"""Generate files into a package that exists: its own package.xml and CMakeLists.txt are never overwritten."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence

from urdfctl.errors import UserError
from urdfctl.generate.files.again import words_of_generated_file
from urdfctl.generate.options import File
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.output.links import check_output
from urdfctl.source.disk.files import named_bytes
from urdfctl.source.disk.gate import exists
from urdfctl.source.workspaces.packages import package_around

_OWN = ("package.xml", "CMakeLists.txt")
_DEPEND = re.compile(r"<(?:exec_|run_)?depend[^>]*>\s*([\w-]+)\s*</")
_INSTALLED = re.compile(r"install\s*\(\s*DIRECTORY\s+([^)]*)")


def around_package(files: Sequence[File], output: str) -> tuple[list[File], list[str]]:
    """Return the files to write to a folder, and what to add to the package.xml and CMakeLists.txt that it has."""
    kept, steps = [], []
    for file in files:
        path = os.path.join(output, file.name)
        check_output(path)
        if file.name not in _OWN or not exists(path) or words_of_generated_file(path):
            kept.append(file)
            continue
        own = named_bytes(path).decode("utf-8", "replace")
        step = _for_manifest(file.text, own) if file.name == _OWN[0] else _for_build(file.text, own)
        steps += [step] if step else []
    return kept, steps


def nested_in(output: str) -> str:
    """Return what is wrong with a new package in another one, and where it should be; empty if it is in none."""
    folder = os.path.abspath(output)
    around = package_around(os.path.dirname(folder))
    if around is None or package_around(folder) == folder:
        return ""
    beside = os.path.relpath(os.path.join(os.path.dirname(around), os.path.basename(folder)))
    return f"'{output}' is in the package '{os.path.basename(around)}', where colcon finds no packages: use -o {beside}"


def check_other_package(name: str, output: str, robot: RobotFacts) -> None:
    """UserError if a new package has the name of the robot's, which it includes: it would hide that one."""
    if robot.package != name or robot.file is None or robot.package_path is None:
        return
    own = os.path.abspath(robot.file).removesuffix(robot.package_path.replace("/", os.sep)).rstrip(os.sep)
    if os.path.realpath(own) != os.path.realpath(output):
        why = f"'{output}' would be a second package '{name}' beside the robot's own"
        raise UserError(f"{why}: write to another folder, or name it with --package")


def _for_manifest(text: str, own: str) -> str:
    there = {*_DEPEND.findall(own)}
    missing = [name for name in _DEPEND.findall(text) if name not in there]
    return (
        "add to package.xml: " + " ".join(f"<exec_depend>{name}</exec_depend>" for name in missing) if missing else ""
    )


def _for_build(text: str, own: str) -> str:
    there = {word for found in _INSTALLED.findall(own) for word in found.split()}
    wanted = [word for found in _INSTALLED.findall(text) for word in found.split()]
    folders = [word for word in wanted[: wanted.index("DESTINATION")] if not {word, f"{word}/"} & there]
    return f"install in CMakeLists.txt: {' '.join(folders)}" if folders else ""
