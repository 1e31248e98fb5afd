"""The arguments with which READMEs and scripts start launch files: people start them so, whatever the defaults are."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import chain, islice

from urdfctl.source.disk.files import first_bytes, folders_upwards
from urdfctl.source.disk.gate import names_in, walk
from urdfctl.source.disk.shown import remembered
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple

_FOLDERS = ("", "doc", "docs", "script", "scripts", "docker")
_STARTS = ("README", "Readme", "readme", "Makefile", "justfile", "Dockerfile", "docker-compose", "compose.")
_ENDINGS = (".md", ".rst", ".sh", ".bash")
_MOST_BYTES = 1 << 18
_MOST_FILES = 32
_MOST_FOLDERS = 256
_MOST_CHOICES = 16
"""Choices of arguments for one launch file."""
_WORD = r"(?:[\w./~+$(){}<>\[\],:=*%@^…-]|\"[^\"\n]*\"|'[^'\n]*')+"
_COMMAND = rf"\b(?:roslaunch|ros2[ \t]+launch)((?:(?:[ \t]|\\\r?\n)+{_WORD})+)"
_ARGUMENT = r"(?<!\S)([A-Za-z_]\w*):=(\"[^\"\n]*\"|'[^'\n]*'|\S+)"
_OF_DEMO = r'<arg\s+name="load_robot_description"\s+default="true"'
_ENDS_SENTENCE = ".,:)"
_PLACEHOLDER = r"(?i)[<>$^*|{}…]|\.\.\.|xxx|\byour|\[[^\]]*[a-z]|(?:true|false)/(?:true|false)"
"""What stands for a value that the reader has to choose."""
_KINDS = frozenset("ADDRESS DIR DIRECTORY FILE FOLDER ID IP NAME NUMBER PATH PORT TYPE VALUE".split())
"""What a value in capitals ends with that stands for one: `SENSOR_NAME`."""


class DocumentedStart(NamedTuple):
    """Arguments with which a text starts a launch file. place: `PATH:LINE`."""

    arguments: tuple[tuple[str, str], ...]
    place: str


class _Command(NamedTuple):
    """The start of a launch file.

    package: None if the launch file is named by its path.
    bare: whether it is started without any argument.
    """

    package: str | None
    name: str
    start: DocumentedStart
    bare: bool


class Documentation:
    """What the texts of a run say about starting launch files.

    texts: those in the folders that are searched; those in the folders around a launch file are read besides.
    """

    def __init__(self, texts: Iterable[str] = ()) -> None:
        self._texts = texts

    @cached_property
    def _elsewhere(self) -> list[_Command]:
        return [command for path in self._texts for command in _in_text(path)]

    def starts(self, path: str) -> tuple[DocumentedStart, ...]:
        """Return the arguments with which texts start a launch file, each choice once; those of the nearest text first.

        A value that stands for another one, such as `<ip>`, is left out.
        """
        found: dict[frozenset[tuple[str, str]], DocumentedStart] = {}
        for command in self._of(path):
            if command.start.arguments:
                found.setdefault(frozenset(command.start.arguments), command.start)
        return tuple(islice(found.values(), _MOST_CHOICES))

    def bare_start(self, path: str) -> str | None:
        """Return where a text starts a launch file without arguments, the nearest text first, or where the file itself
        says that people do; None if nothing does."""
        return next((command.start.place for command in self._of(path) if command.bare), None) or _own_start(path)

    def _of(self, path: str) -> Iterator[_Command]:
        """Yield the starts of a launch file; those of the nearest text first."""
        path = os.path.abspath(path)
        package = package_around(os.path.dirname(path))
        name = package and package_name(os.path.join(package, "package.xml"))
        for command in chain(*map(_commands, _folders_around(path)), self._elsewhere):
            is_named = command.name == os.path.basename(path) and command.package in (None, name)
            if is_named and (command.package or not _means_another(command, path)):
                yield command


def _means_another(command: _Command, path: str) -> bool:
    """Whether a command that names a launch file by its path means one beside the text, not one elsewhere."""
    folder = os.path.dirname(command.start.place.rpartition(":")[0])
    return not path.startswith(folder + os.sep) and command.name in _names_below(folder)


@remembered
def _names_below(folder: str) -> frozenset[str]:
    """The names of the files in a folder and below it."""
    return frozenset(name for _, _, names in islice(walk(folder), _MOST_FOLDERS) for name in names)


def _own_start(path: str) -> str | None:
    """Where MoveIt's demo for ROS 1 says that it loads the description unless another launch file does.

    moveit_setup_assistant templates/moveit_config_pkg_template/launch/demo.launch; demo_gazebo.launch includes it.
    """
    if os.path.basename(path) != "demo.launch":
        return None
    text = _start_of(path)
    found = re.search(_OF_DEMO, text)
    return _place(path, text, found) if found else None


def is_document(path: str) -> bool:
    """Return whether a file may say how launch files are started."""
    name = os.path.basename(path)
    return name.startswith(_STARTS) or name.endswith(_ENDINGS)


def _folders_around(path: str) -> Iterator[str]:
    top = workspace_of(path)
    for folder in folders_upwards(os.path.dirname(path)):
        yield folder
        if folder == top or not folder.startswith(top):
            return


@remembered
def _commands(folder: str) -> tuple[_Command, ...]:
    """The starts of launch files that the texts of a folder contain."""
    texts = [path for inner in _FOLDERS for path in _texts(os.path.join(folder, inner) if inner else folder)]
    return tuple(command for path in texts[:_MOST_FILES] for command in _in_text(path))


def _texts(folder: str) -> Iterator[str]:
    try:
        names = names_in(folder)
    except OSError:
        return
    yield from (os.path.join(folder, name) for name in names if is_document(name))


@remembered
def _in_text(path: str) -> tuple[_Command, ...]:
    text = _start_of(path)
    return tuple(_commands_in(text, path)) if "launch" in text else ()


def _start_of(path: str) -> str:
    """The text of a file, as far as it is read; empty if it cannot be."""
    try:
        return first_bytes(path, _MOST_BYTES).decode("utf-8", "replace")
    except OSError:
        return ""


def _commands_in(text: str, path: str) -> Iterator[_Command]:
    for match in re.finditer(_COMMAND, text):
        words = match[1]
        first, *rest = [word for word in words.replace("\\", " ").split() if not word.startswith("-")] or [""]
        is_path = ".launch" in first
        name = os.path.basename(first if is_path else rest[0] if rest else "")
        start = DocumentedStart(tuple(_arguments(words)), _place(path, text, match))
        yield _Command(None if is_path else first, name.rstrip(_ENDS_SENTENCE), start, ":=" not in words)


def _place(path: str, text: str, match: re.Match[str]) -> str:
    line = text.count("\n", 0, match.start()) + 1
    return f"{os.path.abspath(path)}:{line}"


def _arguments(words: str) -> Iterator[tuple[str, str]]:
    for name, written in re.findall(_ARGUMENT, words):
        value = written.rstrip(_ENDS_SENTENCE).strip("\"'")
        if not re.search(_PLACEHOLDER, value) and not _is_in_capitals(name, value):
            yield name, value


def _is_in_capitals(name: str, value: str) -> bool:
    """Whether a value in capitals stands for one: `MODEL` for a `model`, or a kind of value such as `ROBOT_IP`."""
    words = value.split("_")
    return value.isupper() and (name.upper() == value or (len(words) > 1 and words[-1] in _KINDS))
