"""Processes of launch files in Python that run `gazebo` itself: gz's launch file takes their place."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.starting import OPTIONS_WITH_VALUE
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of
from urdfctl.startup.records import NamedTuple

_PROGRAMS = {"gazebo": (), "gzserver": ("-s",), "gzclient": ("-g",)}
"""The programs of Gazebo Classic, with the options of gz that do the same."""
_PAUSED = ("-u", "--pause")


_INCLUDABLE = frozenset({"cmd", "output", "name", "condition", "emulate_tty", "shell"})
"""The settings of a process that gz's launch file decides itself, or that an include has too."""
_IMPORTS = (
    ("launch.actions", "IncludeLaunchDescription"),
    ("launch.launch_description_sources", "PythonLaunchDescriptionSource"),
    ("launch.substitutions", "PathJoinSubstitution"),
    ("launch_ros.substitutions", "FindPackageShare"),
)


class ClassicProcess(NamedTuple):
    """A process that runs Gazebo Classic: its call, the function around that, and its command line."""

    call: ast.Call
    scope: ast.AST
    command: ast.List

    def in_gz(self, file: PythonFile, names: Mapping[str, str]) -> tuple[Edit, Sequence[tuple[str, str]]]:
        """Return the edit that starts gz with the same world, and what it imports: by gz's launch file, which alone
        says where the plugins and meshes of packages are. What waits for the process needs one that does so."""
        options, words = _options(self.command)
        shown = [*map(file.text, words), *([] if words or "-g" in options else ['"empty.sdf"'])]
        flags = " ".join(options)
        if any(one.value is self.command for one in self.call.keywords) and self._is_includable():
            start = f"IncludeLaunchDescription(PythonLaunchDescriptionSource({_launch_file(names)}), launch_arguments="
            space = " " if flags and shown else ""
            value = f'["{flags}{space}", {", ".join(shown)}]' if shown else f'"{flags}"'
            value = f'"{flags}{space}empty.sdf"' if shown == ['"empty.sdf"'] else value
            condition = keyword(self.call, "condition")
            more = f", condition={file.text(condition.value)}" if condition else ""
            text = f'{start}{{"{names["argument"]}": {value}}}.items(){more})'
            return Edit(file.span(self.call), text), _IMPORTS
        value = ", ".join([f'"{names["argument"]}:={flags} "', *shown])
        text = f'["ros2", "launch", "{names["package"]}", "{names["launch"]}", [{value}]]'
        return Edit(file.span(self.command), text), ()

    def is_clear(self) -> bool:
        """Return whether at most one word of the command line is no option of Gazebo Classic: the world."""
        return len(_options(self.command)[1]) <= 1

    def _is_includable(self) -> bool:
        """Whether nothing waits for the process, and its settings are those of an include."""
        if not all(one.arg in _INCLUDABLE for one in self.call.keywords):
            return False
        names = {
            target.id
            for node in ast.walk(self.scope)
            if isinstance(node, ast.Assign) and node.value is self.call
            for target in node.targets
            if isinstance(target, ast.Name)
        }
        waited = (
            one.value
            for node in ast.walk(self.scope)
            if isinstance(node, ast.Call)
            for one in node.keywords
            if one.arg == "target_action"
        )
        return not any(one is self.call or (isinstance(one, ast.Name) and one.id in names) for one in waited)


def classic_processes(file: PythonFile) -> Iterator[ClassicProcess]:
    """Yield the processes that run Gazebo Classic."""
    for call, scope in file.calls("ExecuteProcess"):
        given = keyword(call, "cmd")
        command = file.value_of(given.value, scope) if given else None
        if isinstance(command, ast.List) and command.elts and text_of(command.elts[0]) in _PROGRAMS:
            yield ClassicProcess(call, scope, command)


def _launch_file(names: Mapping[str, str]) -> str:
    return f'PathJoinSubstitution([FindPackageShare("{names["package"]}"), "launch", "{names["launch"]}"])'


def _options(command: ast.List) -> tuple[list[str], list[ast.expr]]:
    """The options of gz for a command line, and its words that are no options."""
    program, *words = command.elts
    texts = [text_of(word) for word in words]
    options = list(_PROGRAMS[text_of(program)])
    options += ["-r"] if "-g" not in options and not {*_PAUSED} & {*texts} else []
    options += ["-v4"] if "--verbose" in texts else []
    return options, list(_kept(words))


def _kept(words: Sequence[ast.expr]) -> Iterator[ast.expr]:
    """Yield the words of a command line that are no options of Gazebo Classic, nor their values."""
    rest = iter(words)
    for word in rest:
        text = text_of(word)
        if text in OPTIONS_WITH_VALUE:
            next(rest, None)
        elif not text.startswith("-") and not text.isspace():
            yield word
