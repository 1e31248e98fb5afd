"""The facts that a ROS 2 launch file states, as they are collected while it is followed."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence

from urdfctl.model.controllers import FileReference
from urdfctl.model.launch import (
    UNCHANGED,
    Description,
    GivenParameters,
    LaunchedFile,
    Node,
    ParameterLoad,
    Rewriting,
    Spawn,
    Word,
)
from urdfctl.model.launch.parts import FILE_ENDINGS
from urdfctl.model.launch.ros2.texts import Content
from urdfctl.model.moveit import MoveItFiles
from urdfctl.source.opaque import UNKNOWN, if_known
from urdfctl.source.span import Place


class LaunchFacts:
    """The facts that are collected while a launch file is followed.

    locate: finds a path: where it lies in the sources, and whether it exists (None if that cannot be known).
    """

    def __init__(self, locate: Callable[[str], tuple[str, bool | None]]) -> None:
        self.locate = locate
        self.descriptions: list[Description] = []
        self.loads: list[ParameterLoad] = []
        self.spawns: list[Spawn] = []
        self.elsewhere: list[Spawn] = []
        self.nodes: list[Node] = []
        self.references: dict[tuple[str, int], LaunchedFile] = {}
        self.moveit: list[MoveItFiles] = []
        self.given: list[GivenParameters] = []
        self.altered = False
        """Whether an action changes the parameters or remappings of all following nodes."""

    def spawns_in_turn(self) -> tuple[Spawn, ...]:
        """Return the spawners in the order in which they start: each after those whose exit it waits for."""
        order = {name: index for index, spawn in enumerate(self.spawns) for name, _ in spawn.names}
        return tuple(sorted(self.spawns, key=lambda spawn: _turn(spawn, self.spawns, order)))

    def exists(self, path: str) -> bool:
        """Return whether a path certainly exists."""
        return bool(self.locate(path)[1])

    def reference(self, path: str, at: Place, use: str, *, sure: bool) -> FileReference:
        """Add a reference to a file, if its path is known, and return it."""
        known = if_known(path)
        located, exists = self.locate(known) if known else (None, None)
        if known and not os.path.isabs(known):  # depends on the folder that the launch is started in, e.g. its own
            beside = os.path.normpath(os.path.join(os.path.dirname(at.source.path), known))
            located, exists = self.locate(beside) if self.exists(beside) else (None, None)
        reference = FileReference(path, at, located, exists)
        if located is not None:
            key = located, at.start
            if key not in self.references or self.references[key].use == "argument":
                self.references[key] = LaunchedFile(reference, use, None, sure)
        return reference

    def named_file(self, word: Word, *, sure: bool) -> None:
        """Add a reference to the file that a text names, if it ends as files do and is a known, absolute path."""
        if word.text.endswith(FILE_ENDINGS) and os.path.isabs(word.text) and UNKNOWN not in word.text:
            self.reference(word.text, word.at, "argument", sure=sure)

    def load(
        self,
        file: Word,
        node: str,
        *,
        sure: bool,
        of: str | None,
        rewriting: Rewriting = UNCHANGED,
        held: bool = True,
    ) -> FileReference:
        """Add a parameter file of a controller manager or a spawner, and return the reference to it.

        of: the node's namespace; None if unknown.
        rewriting: how the launch file rewrites the file.
        held: False if the node runs only with other launch arguments, and nothing is loaded.
        """
        reference = self.reference(file.text, file.at, "parameters", sure=sure)
        if held:
            self.loads.append(ParameterLoad(reference, "", file.at, sure, node=node, of=of, rewriting=rewriting))
        return reference

    def described(self, content: Content, node: str, namespace: str | None, *, sure: bool) -> None:
        """Add a robot description that is passed to a node."""
        file = self.reference(content.path or UNKNOWN, content.at, "description", sure=sure)
        names = tuple(Word(name, at) for name, at in content.names)
        self.descriptions.append(
            Description(
                file=file,
                arguments=content.arguments,
                namespace=namespace,
                at=content.at,
                sure=sure,
                names=names,
                command=content.command,
                node=node,
                alternatives=content.alternatives,
                as_yaml=content.as_yaml,
                more=content.more,
                edited=content.edited,
                by_xacro=content.by_xacro,
            )
        )


def _turn(spawn: Spawn, spawns: Sequence[Spawn], order: Mapping[str, int], depth: int = 0) -> int:
    """The number of spawners in a row that must exit before this one starts."""
    if depth > len(spawns):
        return depth
    before = (spawns[order[name]] for name in spawn.after if name in order)
    return max((1 + _turn(earlier, spawns, order, depth + 1) for earlier in before if earlier is not spawn), default=0)
