"""What an editor asks about an open text, in this process and without the protocol."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from random import Random

from seeds import ARM, OTHER_TEXTS

from urdfctl.errors import UserError
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.workspace import EditorSettings, Workspace
from urdfctl.server.features.completion import items_at
from urdfctl.server.features.hover import hover
from urdfctl.server.features.navigation import NamesAround, check_renamable, definitions, references, renamed
from urdfctl.server.features.symbols import hints_in, symbols_in
from urdfctl.source.span import SourceText

_FOLDER = Path("edited")
_FILES = {
    "package.xml": OTHER_TEXTS["package.xml"],
    "arm.xacro": ARM.replace(b"xacro.load_yaml('joints.yaml')", b"dict(a=1)"),
    "controllers.yaml": OTHER_TEXTS["config/controllers.yaml"],
    "arm.launch": b"<launch><rosparam file='$(find arm)/controllers.yaml'/><param name='robot_description' "
    b"command='xacro $(find arm)/arm.xacro prefix:=a_'/></launch>\n",
}
NAMES = ["knee", "", "a b", "${prefix}x", "elbow", "<", "\0", "x" * 300]
_MOST_QUESTIONS = 3


def asked_in_an_editor(data: bytes, random: Random) -> None:
    """Open a text in the place of a file of a small package, lint it, and ask about places in it."""
    if not _FOLDER.exists():
        _FOLDER.mkdir()
        for name, content in _FILES.items():
            (_FOLDER / name).write_bytes(content)
    workspace = Workspace(str(_FOLDER), EditorSettings(distro=random.choice([None, "noetic", "jazzy"])))
    path = os.path.realpath(_FOLDER / random.choice([*_FILES][1:]))
    text = data.decode("utf-8", "replace").encode()
    workspace.changed(path, text)
    found = workspace.check().findings.get(path, ())
    for _ in range(_MOST_QUESTIONS):
        question = _question(workspace, path, SourceText(path, text), random)
        hover(question, found)
        items_at(question, workspace.attempts(path) if random.random() < 0.1 else None)
        symbols_in(question)
        hints_in(question)
        around = NamesAround(question)
        definitions(around)
        references(around, with_definition=True)
        with suppress(UserError):
            check_renamable(around)
        with suppress(UserError):
            renamed(around, random.choice(NAMES))


def _question(workspace: Workspace, path: str, source: SourceText, random: Random) -> Question:
    """A question about a random place, as the window asks it."""
    position = source.position(random.randrange(len(source.data) + 1))
    robots = workspace.robots_with(path)
    read = next((one for robot in robots for one in robot.sources.values() if one.data == source.data), None)
    packages = workspace.packages_for(path)
    return Question(
        robots, read or source, position.line, position.column, is_current=read is not None, packages=packages
    )
