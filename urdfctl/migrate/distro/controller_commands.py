"""Commands of `ros2 control` in launch files in Python whose verbs and states have other names."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step

_AUTHORITY = "ros2_control ros2controlcli/verb/load_controller.py: choices of --set-state"
_VERB = "load_controller"
_PROGRAMS = "ros2_control controller_manager/setup.cfg: console_scripts spawner, unspawner"
_PROGRAM = re.compile(r"\bros2 run controller_manager (?:un)?spawner\.py\b")
_WORDS = (b"load_", b"spawner.py")
_OPTIONS = {"--set-state": "--set-state", "--set_state": "--set-state", "--state": "--set-state"}
_STATES = {"start": "active", "configure": "inactive", "configured": "inactive"}
_VERBS = {"load_start_controller": "active", "load_configure_controller": "inactive"}


def _commands(packages: MigratedPackages) -> Iterator[Proposal]:
    if packages.is_ros1:
        return
    for path in packages.files(".py"):
        source = packages.read(path)
        if not any(word in source.data for word in _WORDS) or not packages.may_change(path):
            continue
        file = PythonFile(source)
        yield from _programs(file)
        for call, scope in file.calls("ExecuteProcess"):
            given = keyword(call, "cmd")
            command = file.value_of(given.value, scope) if given else None
            words = command.elts if isinstance(command, ast.List) else []
            texts = [text_of(word) for word in words]
            new = dict(_changed(texts)) if texts[:2] == ["ros2", "control"] else {}
            if new:
                quote = file.text(words[2])[0]
                edits = tuple(Edit(file.span(words[at]), text.replace('"', quote)) for at, text in new.items())
                message = "the command names the state of a controller as ros2controlcli does"
                at = file.at(words[next(iter(new))])
                yield Proposal(edits, entries=(ReportEntry(EntryKind.DONE, message, at, authority=_AUTHORITY),))


def _programs(file: PythonFile) -> Iterator[Proposal]:
    """Programs in a command line that is one text."""
    for node in ast.walk(file.tree) if file.tree else ():
        found = re.search(_PROGRAM, text_of(node)) if isinstance(node, ast.Constant) else None
        if found is None or not isinstance(node, ast.Constant):
            continue
        span = file.span(node)
        if span.text.count(found[0]) == 1:
            at = span.start + len(span.text[: span.text.index(found[0])].encode())
            edit = Edit(span._replace(start=at, end=at + len(found[0].encode())), found[0].removesuffix(".py"))
            message = f"'{found[0]}' became '{edit.text}'"
            entry = ReportEntry(EntryKind.DONE, message, file.at(node), authority=_PROGRAMS)
            yield Proposal((edit,), entries=(entry,))


def _changed(texts: list[str]) -> Iterator[tuple[int, str]]:
    """Yield the words of a command that change, each with its place and its new expression."""
    verb = next(iter(texts[2:]), "")
    if verb in _VERBS:
        yield 2, f'"{_VERB}", "--set-state", "{_VERBS[verb]}"'
    elif verb == _VERB:
        for at, text in enumerate(texts[:-1]):
            if text in _OPTIONS and text != _OPTIONS[text]:
                yield at, f'"{_OPTIONS[text]}"'
            if text in _OPTIONS and texts[at + 1] in _STATES:
                yield at + 1, f'"{_STATES[texts[at + 1]]}"'


CONTROLLER_COMMANDS = Step(
    name="controller-commands",
    part=Part.LAUNCH,
    summary="Commands that load controllers",
    propose=_commands,
    rows=(
        Row("ros2 control load_controller --state STATE", "--set-state STATE", "humble", _AUTHORITY),
        Row("load_controller --set-state start, configure", "active, inactive", "humble", _AUTHORITY),
        Row("ros2 run controller_manager spawner.py", "ros2 run controller_manager spawner", "humble", _PROGRAMS),
        Row("load_start_controller, load_configure_controller", "load_controller --set-state", "humble", _AUTHORITY),
    ),
    before=[
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch.actions import ExecuteProcess


                def generate_launch_description():
                    arm = ExecuteProcess(cmd=["ros2", "control", "load_controller", "--set-state", "start", "arm"])
                    old = ExecuteProcess(cmd=["ros2", "control", "load_start_controller", "hand"])
                    leg = ExecuteProcess(cmd=["ros2 run controller_manager spawner.py leg"], shell=True)
                    return LaunchDescription([arm, old, leg])
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch.actions import ExecuteProcess


                def generate_launch_description():
                    arm = ExecuteProcess(cmd=["ros2", "control", "load_controller", "--set-state", "active", "arm"])
                    old = ExecuteProcess(cmd=["ros2", "control", "load_controller", "--set-state", "active", "hand"])
                    leg = ExecuteProcess(cmd=["ros2 run controller_manager spawner leg"], shell=True)
                    return LaunchDescription([arm, old, leg])
            """,
        },
    ],
)
