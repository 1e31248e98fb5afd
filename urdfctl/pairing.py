"""Which controllers' files belong to a robot, and what they say: those named beside it, and those its plugins name."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from urdfctl.model.build_controllers import Loaded, controllers_of, form_of
from urdfctl.model.controllers import Controllers, FileReference
from urdfctl.model.robot import Robot
from urdfctl.source.files import FileProblem, Files
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText
from urdfctl.source.yaml import YamlFile, read_yaml

_NOT_TOLD = (ProblemKind.FILE_NOT_FOUND, ProblemKind.OUTSIDE_WORKSPACE)
"""A file that a plugin names and that is not there is a fact of the robot; rules tell it."""


class Read(NamedTuple):
    """The files that were read, those that the robot names, and what was wrong with any of them."""

    files: tuple[Loaded, ...]
    references: tuple[FileReference, ...]
    problems: tuple[Problem, ...]

    @property
    def form(self) -> int | None:
        """The generation of ROS that the files are written for; None where they do not tell it, or disagree."""
        forms = {form for loaded in self.files if (form := form_of(loaded.yaml)) is not None}
        return forms.pop() if len(forms) == 1 else None

    def model(self, ros: int | None, started: Sequence[str] | None) -> Controllers:
        """What the files say to a generation of ROS."""
        return controllers_of(self.files, ros, started, self.references)


def read_controllers(paths: Iterable[str], robot: Robot | None, files: Files) -> Read:
    """Read the files of some paths, and those that the robot's ros2_control plugins name in `<parameters>`."""
    read: dict[str, YamlFile] = {}
    problems: list[Problem] = []
    references = []
    for text, at in _named_by(robot):
        reference, problem = _read_reference(text, at, files, read)
        references.append(reference)
        problems += [problem] if problem else []
    for path in map(os.path.abspath, paths):
        try:
            source = files.read(path)
        except FileProblem as error:
            problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        else:
            read.setdefault(source.path, read_yaml(source))
    problems += [problem for file in read.values() for problem in file.problems]
    return Read(tuple(map(Loaded, read.values())), tuple(references), tuple(problems))


def _named_by(robot: Robot | None) -> Iterator[tuple[str, Place]]:
    for plugin in robot.plugins if robot else ():
        if "ros2_control" in (plugin.filename or ""):
            for tag in plugin.tag.named("parameters"):
                if tag.text:
                    yield tag.text, tag.at.content


def _read_reference(
    text: str, at: Place, files: Files, read: dict[str, YamlFile]
) -> tuple[FileReference, Problem | None]:
    """What a plugin names: only an absolute path is the same file wherever the simulator runs."""
    if not os.path.isabs(text) or "$" in text:
        return FileReference(text, at, None, exists=None), None
    try:
        source = files.read(text)
    except FileProblem as error:
        exists = False if error.kind is ProblemKind.FILE_NOT_FOUND else None
        told = error.kind not in _NOT_TOLD
        return FileReference(text, at, text, exists), error.at(at) if told else None
    if source.path not in read:
        read[source.path] = read_yaml(source)
    return FileReference(text, at, source.path, exists=True), None
