"""The controller manager and its spawners in launch files in Python."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from itertools import takewhile

from urdfctl.catalog.moves import MANAGER
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, called, keyword, text_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, installed_path, sections, sections_near
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you

AUTHORITY_OF_TOPIC = "ros2_control#1358, #1410: the robot description is read from the topic robot_description"
AUTHORITY_OF_FILE = "ros2_control#1694: parameters given to the controller manager alone do not reach its controllers"
AUTHORITY_OF_OPTIONS = "controller_manager spawner.py: the options of each distro"
AUTHORITY_OF_REMAPPING = "ros2_control#3016: remappings of the controller manager do not reach its controllers"
WITH_FILE = "spawn controllers that have parameters by a spawner with --param-file FILE"
_EVALUATED = (
    "launch replaces the substitutions of the controller file only for the controller manager (allow_substs): write a "
    "file without them, and give it to the spawner by --param-file"
)
_DESCRIPTION = "robot_description"
_OLD_TOPIC = "~/robot_description"


def _launch_python(packages: MigratedPackages) -> Iterator[Proposal]:
    known = [section for section in packages.found(sections) if section.type != MANAGER]
    for path in packages.files(".py"):
        source = packages.read(path)
        if b"controller_manager" in source.data and packages.may_change(path):
            yield from _LaunchFile(packages, PythonFile(source), known).proposals()


class _LaunchFile:
    """One launch file."""

    def __init__(self, packages: MigratedPackages, file: PythonFile, known: Sequence[FileSection]) -> None:
        self.packages, self.file = packages, file
        self.nodes = [
            (call, scope)
            for call, scope in file.calls("Node", "LifecycleNode")
            if text_of(getattr(keyword(call, "package"), "value", None)) == "controller_manager"
        ]
        self.known = sections_near(known, file.source, self._without_spawners())

    def _without_spawners(self) -> bytes:
        """The text of the file without the arguments of spawners: one of them names the file of its controllers."""
        text = self.file.source.data
        for call, _ in self.nodes:
            given = keyword(call, "arguments")
            span = self.file.span(given.value) if given else None
            text = text.replace(text[span.start : span.end], b" " * (span.end - span.start)) if span else text
        return text

    def proposals(self) -> Iterator[Proposal]:
        """Yield the changes up to jazzy, or if there are none left, those of lyrical: they change the same lists."""
        early = list(self._of_jazzy())
        yield from early
        if self._crosses("lyrical") and not any(proposal.edits for proposal in early):
            for call, _ in self.nodes:
                if _executable(call) == "ros2_control_node":
                    yield from self._remappings(call)

    def _of_jazzy(self) -> Iterator[Proposal]:
        for call, scope in self.nodes:
            executable = _executable(call)
            if executable == "ros2_control_node" and self._crosses("jazzy"):
                yield from self._description(call, scope)
                yield from self._topic(call)
            elif executable.startswith("spawner"):
                yield from self._options(call)
                if self._crosses("jazzy"):
                    yield from self._parameter_file(call, scope)

    def _crosses(self, since: str) -> bool:
        return self.packages.crosses(since, self.file.source.path)

    # -- the manager ---------------------------------------------------------------------------------------------------

    def _description(self, call: ast.Call, scope: ast.AST) -> Iterator[Proposal]:
        given = keyword(call, "parameters")
        if given is None or not isinstance(given.value, ast.List) or len(given.value.elts) <= 1:
            return
        for item in given.value.elts:
            if self._is_description(item, scope):
                what = f"'{_DESCRIPTION}' is no longer a parameter of the controller manager"
                entry = ReportEntry(EntryKind.DONE, what, self.file.at(item), authority=AUTHORITY_OF_TOPIC)
                yield Proposal((self.file.without(given.value.elts, item),), entries=(entry,))
                return

    def _is_description(self, item: ast.expr, scope: ast.AST) -> bool:
        value = self.file.value_of(item, scope)
        return isinstance(value, ast.Dict) and [text_of(key) for key in value.keys] == [_DESCRIPTION]

    def _topic(self, call: ast.Call) -> Iterator[Proposal]:
        """Remap the topic robot_description instead of ~/robot_description, or not at all."""
        given = keyword(call, "remappings")
        pairs = given.value.elts if given and isinstance(given.value, ast.List) else []
        for pair in pairs:
            if not isinstance(pair, ast.Tuple) or not pair.elts or text_of(pair.elts[0]) != _OLD_TOPIC or given is None:
                continue
            is_same = text_of(pair.elts[-1]) in (f"/{_DESCRIPTION}", _DESCRIPTION)
            what = f"the topic '{_OLD_TOPIC}' of the controller manager is now '{_DESCRIPTION}'"
            entry = ReportEntry(EntryKind.DONE, what, self.file.at(pair), authority=AUTHORITY_OF_TOPIC)
            if not is_same or keyword(call, "namespace"):
                span = self.file.span(pair.elts[0])
                edit = Edit(span, span.text.replace(_OLD_TOPIC, _DESCRIPTION))
            elif len(pairs) > 1:
                edit = self.file.without(pairs, pair)
            else:
                edit = self.file.without(call.keywords, given)
            yield Proposal((edit,), entries=(entry,))
            return

    def _remappings(self, call: ast.Call) -> Iterator[Proposal]:
        """Remap the topics of controllers where they are spawned."""
        given = keyword(call, "remappings")
        pairs = given.value.elts if given and isinstance(given.value, ast.List) else []
        for pair in pairs:
            texts = [text_of(one) for one in pair.elts] if isinstance(pair, ast.Tuple) else []
            controller = texts[0].lstrip("/").partition("/")[0] if texts and "/" in texts[0].lstrip("/") else ""
            if len(texts) != 2 or not all(texts) or controller in ("", "~") or given is None:  # noqa: PLR2004 (a pair)
                continue
            what = f"the topic '{texts[0]}' is remapped where its controller is spawned"
            entry = ReportEntry(EntryKind.DONE, what, self.file.at(pair), authority=AUTHORITY_OF_REMAPPING)
            arguments = self._arguments_of_spawner(controller)
            if arguments is None:
                text = f"remap '{texts[0]}' by --controller-ros-args of the spawner of '{controller}'"
                yield for_you(self.file.at(pair), text, authority=AUTHORITY_OF_REMAPPING)
                continue
            gone = self.file.without(call.keywords, given) if len(pairs) == 1 else self.file.without(pairs, pair)
            added = self.file.appended(arguments, ['"--controller-ros-args"', f'"-r {texts[0]}:={texts[1]}"'])
            yield Proposal((gone, added), entries=(entry,))
            return

    def _arguments_of_spawner(self, controller: str) -> ast.List | None:
        """The arguments of the spawner that starts a controller."""
        for call, _ in self.nodes:
            given = keyword(call, "arguments")
            if given and isinstance(given.value, ast.List) and controller in map(text_of, given.value.elts):
                return given.value
        return None

    # -- the spawners --------------------------------------------------------------------------------------------------

    def _options(self, call: ast.Call) -> Iterator[Proposal]:
        executable = keyword(call, "executable")
        if executable and text_of(executable.value) == "spawner.py" and self.packages.reaches("humble"):
            yield self._renamed(executable.value, "spawner.py", "spawner")
        for item in _arguments(call):
            if text_of(item) == "--stopped":
                yield self._renamed(item, "--stopped", "--inactive")

    def _renamed(self, item: ast.expr, old: str, new: str) -> Proposal:
        span = self.file.span(item)
        what = f"'{old}' of the spawner is now '{new}'"
        entry = ReportEntry(EntryKind.DONE, what, self.file.at(item), authority=AUTHORITY_OF_OPTIONS)
        return Proposal((Edit(span, span.text.replace(old, new)),), entries=(entry,))

    def _parameter_file(self, call: ast.Call, scope: ast.AST) -> Iterator[Proposal]:
        """Give the spawner the file of its controllers, unless none of them has parameters.

        It passes a file on to those controllers alone that are in it.
        """
        given = keyword(call, "arguments")
        texts = [text_of(item) for item in _arguments(call)]
        if given is None or not isinstance(given.value, ast.List) or {"--param-file", "-p"} & set(texts):
            return
        names = list(takewhile(lambda text: not text.startswith("-"), texts))
        files = {path for name in names for path in self.known.get(name, ())}
        if not any(not name or name in self.known for name in names):
            return
        given_file = self._file_of_manager(scope)
        if given_file is not None and self._is_evaluated(given_file, scope):
            yield for_you(self.file.at(call), _EVALUATED, authority=AUTHORITY_OF_FILE)
            return
        expression = self._path_in(given_file, scope) if given_file is not None else None
        imports: tuple[Edit, ...] = ()
        if expression is None and len(files) == 1:
            expression, imports = self._file_in_package(next(iter(files)))
        if expression is None:
            yield for_you(self.file.at(call), WITH_FILE, authority=AUTHORITY_OF_FILE)
            return
        quote = "'" if self.file.text(given.value.elts[0]).startswith("'") else '"'
        edit = self.file.appended(given.value, [f"{quote}--param-file{quote}", expression])
        what = "the spawner gives its controllers their parameters: --param-file"
        entry = ReportEntry(EntryKind.DONE, what, self.file.at(call), authority=AUTHORITY_OF_FILE)
        yield Proposal((edit, *imports), entries=(entry,))

    def _file_of_manager(self, scope: ast.AST) -> ast.expr | None:
        """The only file that the controller manager of the same function gets."""
        for call, around in self.nodes:
            given = keyword(call, "parameters")
            if around is not scope or given is None or not isinstance(given.value, ast.List):
                continue
            values = [(item, self.file.value_of(item, scope)) for item in given.value.elts]
            files = [item for item, value in values if not isinstance(value, (ast.Dict, ast.Starred))]
            if len(files) == 1:
                return files[0]
        return None

    def _path_in(self, item: ast.expr, scope: ast.AST) -> str | None:
        """The expression for the path of a file, which may be in a ParameterFile: a spawner takes none."""
        value = self.file.value_of(item, scope)
        if isinstance(value, ast.Call) and called(value) == "ParameterFile":
            named = keyword(value, "param_file")
            inner = named.value if named else next(iter(value.args), None)
            return " ".join(self.file.text(inner).split()) if inner is not None else None
        return " ".join(self.file.text(item).split())

    def _is_evaluated(self, item: ast.expr, scope: ast.AST) -> bool:
        """Whether launch replaces substitutions in the file, and the controllers have any."""
        value = self.file.value_of(item, scope)
        allowed = keyword(value, "allow_substs") if isinstance(value, ast.Call) else None
        if allowed is None or (isinstance(allowed.value, ast.Constant) and not allowed.value.value):
            return False
        files = {path for paths in self.known.values() for path in paths}
        return any(b"$(" in self.packages.read(path).data for path in files)

    def _file_in_package(self, path: str) -> tuple[str, tuple[Edit, ...]]:
        """The expression for a file of a package, and the imports that it needs."""
        package, parts = installed_path(self.packages, path)
        shown = ", ".join(f'"{part}"' for part in parts)
        needed = (("launch.substitutions", "PathJoinSubstitution"), ("launch_ros.substitutions", "FindPackageShare"))
        imports = [edit for module, one in needed if (edit := self.file.imports(module, one)) is not None]
        merged = (Edit(imports[0].span, "".join(edit.text for edit in imports)),) if imports else ()
        return f'PathJoinSubstitution([FindPackageShare("{package}"), {shown}])', merged


def _executable(call: ast.Call) -> str:
    return text_of(getattr(keyword(call, "executable"), "value", None))


def _arguments(call: ast.Call) -> list[ast.expr]:
    given = keyword(call, "arguments")
    return given.value.elts if given and isinstance(given.value, ast.List) else []


LAUNCH_PYTHON = Step(
    name="launch-files-in-python",
    part=Part.LAUNCH,
    summary="The controller manager and its spawners in launch files",
    propose=_launch_python,
    rows=(
        Row("manager: parameter robot_description", "topic robot_description", "jazzy", AUTHORITY_OF_TOPIC),
        Row("remapping of ~/robot_description", "remapping of robot_description", "jazzy", AUTHORITY_OF_TOPIC),
        Row("spawner without parameters", "spawner --param-file FILE", "jazzy", AUTHORITY_OF_FILE),
        Row(
            "manager: remapping of a controller's topic",
            "spawner --controller-ros-args",
            "lyrical",
            AUTHORITY_OF_REMAPPING,
        ),
        Row("spawner.py", "spawner", "humble", AUTHORITY_OF_OPTIONS),
        Row("spawner: --stopped", "--inactive", "humble", AUTHORITY_OF_OPTIONS),
    ),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([
                        Node(
                            package="controller_manager",
                            executable="ros2_control_node",
                            parameters=["controllers.yaml"],
                            remappings=[("~/robot_description", "/robot_description")],
                        ),
                        Node(package="controller_manager", executable="spawner.py", arguments=["arm"]),
                        Node(package="controller_manager", executable="spawner", arguments=["hand", "--stopped"]),
                    ])
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([
                        Node(
                            package="controller_manager",
                            executable="ros2_control_node",
                            parameters=["controllers.yaml"],
                        ),
                        Node(package="controller_manager", executable="spawner", arguments=["arm"]),
                        Node(package="controller_manager", executable="spawner", arguments=["hand", "--inactive"]),
                    ])
            """,
        },
    ],
)
