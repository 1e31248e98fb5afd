"""Commands of Ignition in launch files in Python, word by word: they are commands of gz."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step

_SINCE = "jazzy"
_AUTHORITY = "gz-sim tutorials/migration_from_ignition.md: ign gazebo became gz sim; jazzy has no program ign"
_PROGRAM = "ign"
_VERBS = {"gazebo": "sim", **{verb: verb for verb in ("topic", "service", "model", "sdf", "param", "msg", "log")}}
"""The commands of `ign`, with those of `gz`."""


def _commands(packages: MigratedPackages) -> Iterator[Proposal]:
    for path in packages.files(".py"):
        source = packages.read(path)
        is_moved = _PROGRAM.encode() in source.data and packages.may_change(path) and packages.crosses(_SINCE, path)
        for file in [PythonFile(source)] if is_moved else ():
            for call, scope in file.calls("ExecuteProcess"):
                given = keyword(call, "cmd")
                command = file.value_of(given.value, scope) if given else None
                words = command.elts if isinstance(command, ast.List) else []
                if (edits := tuple(_edits(file, words))) and given is not None:
                    entry = ReportEntry(
                        EntryKind.DONE, "the command is one of gz", file.at(words[0]), authority=_AUTHORITY
                    )
                    yield Proposal(edits, entries=(entry,))


def _edits(file: PythonFile, words: list[ast.expr]) -> Iterator[Edit]:
    """Yield the edits of a command line that begins with `ign` and one of its commands."""
    program, verb = words[:2] if len(words) > 1 else (None, None)
    name = program
    if isinstance(program, ast.Call):  # FindExecutable(name="ign")
        given = keyword(program, "name")
        name = given.value if given else None
    if name is None or verb is None or text_of(name) != _PROGRAM or text_of(verb) not in _VERBS:
        return
    for word, text in ((name, "gz"), (verb, _VERBS[text_of(verb)])):
        quote = file.text(word)[0]
        yield Edit(file.span(word), f"{quote}{text}{quote}")


IGNITION_COMMANDS = Step(
    name="ignition-commands",
    part=Part.LAUNCH,
    summary="Commands of Ignition",
    propose=_commands,
    rows=(Row("ExecuteProcess(cmd=['ign', 'gazebo', ...])", "['gz', 'sim', ...]", _SINCE, _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "launch/pit.launch.py": """
                from launch import LaunchDescription
                from launch.actions import ExecuteProcess


                def generate_launch_description():
                    world = ExecuteProcess(cmd=["ign", "gazebo", "-r", "pit.sdf"], output="screen")
                    return LaunchDescription([world])
            """,
        },
    ],
    after=[
        {
            "launch/pit.launch.py": """
                from launch import LaunchDescription
                from launch.actions import ExecuteProcess


                def generate_launch_description():
                    world = ExecuteProcess(cmd=["gz", "sim", "-r", "pit.sdf"], output="screen")
                    return LaunchDescription([world])
            """,
        },
    ],
)
