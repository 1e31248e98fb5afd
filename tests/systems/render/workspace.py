"""A workspace: its files, and what is right about it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from systems.possible import Idioms
from systems.system import System


@dataclass(frozen=True)
class ExpectedRobot:
    """A robot that is started, as the resolver has to give it back. Paths are those in the workspace.

    arguments: of the description, as far as they are no paths.
    parameters: the files of parameters that reach it.
    spawned: the names of controllers, with their namespace.
    extra: files of parameters that may be counted as its own, too.
    """

    description: str
    arguments: tuple[tuple[str, str], ...]
    namespace: str
    parameters: frozenset[str]
    spawned: frozenset[str]
    extra: frozenset[str] = frozenset()


@dataclass
class Workspace:
    """A system that is written.

    files: their texts, by paths.
    starts: the launch files that somebody starts.
    included: other launch files.
    foreign: the first parts of paths that belong to what is not started, and is no part of the system.
    is_distro_given: whether the user names the distro; otherwise a file may do it.
    distros: that may be found; none if nothing names any.
    is_fault_visible: whether what is wrong stands in a file as it is read.
    is_simulator_known: whether the launch files that start robots start the simulator, too.
    """

    system: System
    idioms: Idioms
    files: dict[str, str] = field(default_factory=dict)
    robots: list[ExpectedRobot] = field(default_factory=list)
    starts: list[str] = field(default_factory=list)
    included: list[str] = field(default_factory=list)
    foreign: list[str] = field(default_factory=list)
    is_distro_given: bool = True
    distros: frozenset[str] = frozenset()
    is_fault_visible: bool = True
    is_simulator_known: bool = True

    def write(self, folder: Path) -> None:
        """Write the files into a folder."""
        for name, text in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
