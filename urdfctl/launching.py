"""Reads a launch file with what it includes, within the limits of a run."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import NamedTuple

from urdfctl.model.build_launch import Sources, launch_of
from urdfctl.model.launch import Launch
from urdfctl.source.dom import Document
from urdfctl.source.files import FileProblem, Files
from urdfctl.source.packages import PackageNotFound, Packages
from urdfctl.source.problem import Problem, ReadError
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xml import parse


class Launched(NamedTuple):
    """What a launch file does, None where it is none that is understood; the files read for it, and what was wrong."""

    launch: Launch | None
    files: Files
    problems: tuple[Problem, ...]


def read_launch(
    path: str, arguments: Mapping[str, str], files: Files, packages: Packages, environ: Mapping[str, str]
) -> Launched:
    """The facts of a launch file that is started with some arguments."""
    problems: list[Problem] = []

    def tree(name: str) -> Document | None:
        try:
            return parse(files.read(name))
        except FileProblem as error:
            if name == path:
                problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        except ReadError as error:
            problems.append(error.problem)
        return None

    def locate(name: str) -> tuple[str, bool | None]:
        found = packages.source_of(name)
        return found, os.path.isfile(found) if files.may_read(found) else None

    def find(package: str) -> str | None:
        try:
            return packages.find(package)
        except PackageNotFound:
            return None

    launch = launch_of(path, arguments, Sources(tree, locate, find, environ))
    return Launched(launch, files, tuple(problems))
