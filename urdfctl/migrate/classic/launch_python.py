"""Launch files in Python that start Gazebo Classic: they start gz, or the controller manager for real hardware."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator, Sequence

from urdfctl.catalog.distros import since
from urdfctl.diagnostic import Edit
from urdfctl.generate.files.bringup import gz_names
from urdfctl.migrate.classic.empty_worlds import EMPTY, empty_world_paths, filled_defaults, reached
from urdfctl.migrate.classic.launch_process import classic_processes
from urdfctl.migrate.classic.starting import (
    ARGUMENTS,
    CLIENT,
    EMPTY_WORLDS,
    FILES,
    SPAWN,
    GzOption,
    create_options,
    flags,
    has_own_empty_world,
    is_empty_world,
    undecided,
)
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, outermost, text_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.bridge_file import bridge_file_of
from urdfctl.migrate.shared.hardware import goes_to_gz, leaves_classic, simulated_by
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.workspaces.packages import package_around, package_name

_CLASSIC = re.compile(rb"gazebo_ros|['\"](?:gazebo|gzserver|gzclient)['\"]")
_AUTHORITY = "ros_gz_sim README; gazebosim.org, Migrating Gazebo Classic ROS 2 packages"
_UNCLEAR = (
    "start gz here by gz_sim.launch.py of ros_gz_sim: the words of this command line are for Gazebo Classic alone"
)


def _launch_python(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages):
        return
    for path in packages.files(".py"):
        source = packages.read(path)
        if _CLASSIC.search(source.data) and packages.may_change(path):
            file = _ClassicLaunchFile(packages, PythonFile(source))
            yield from file.to_gz() if goes_to_gz(packages) else file.to_hardware()


class _ClassicLaunchFile:
    """One launch file."""

    def __init__(self, packages: MigratedPackages, file: PythonFile) -> None:
        self.packages, self.file = packages, file
        self.gz = gz_names(packages.options.target)
        self.includes = [
            (call, scope, name)
            for call, scope in file.calls("IncludeLaunchDescription")
            if (name := self._launched(call, scope)) is not None
        ]
        processes = list(classic_processes(file))
        self.processes = [process for process in processes if process.is_clear()]
        self.unclear = [process for process in processes if not process.is_clear()]
        nodes = ((call, scope, keyword(call, "executable")) for call, scope in file.calls("Node"))
        self.spawns = [(call, scope) for call, scope, given in nodes if given and text_of(given.value) == SPAWN]

    def _launched(self, call: ast.Call, scope: ast.AST) -> str | None:
        """The launch file of gazebo_ros that an include starts; None if it starts another one."""
        texts = {text_of(node) for node in self._reached(call, scope) if isinstance(node, ast.Constant)}
        if not any("gazebo_ros" in text.split("/") for text in texts):
            return None
        return next((name for name in FILES if any(text.endswith(name) for text in texts)), None)

    def _reached(self, call: ast.Call, scope: ast.AST) -> Iterator[ast.AST]:
        """The nodes of an expression, and of the values of the names in it."""
        source = keyword(call, "launch_description_source")
        return reached(self.file, [*call.args[:1], *([source.value] if source else [])], scope)

    # -- to gz ---------------------------------------------------------------------------------------------------------

    def to_gz(self) -> Iterator[Proposal]:
        for process in self.unclear:
            yield for_you(self.file.at(process.call), _UNCLEAR, authority=_AUTHORITY)
        if not self.includes and not self.spawns and not self.processes:
            return
        started = [process.in_gz(self.file, self.gz) for process in self.processes]
        edits = [edit for edit, _ in started]
        needed = [name for _, names in started for name in names]
        for call, scope, name in self.includes:
            edits += self._arguments(call, scope, name)
            for key, item in self._pairs(call, scope)[1]:
                edits += filled_defaults(self.file, item, scope) if key == "world" else []
        for call, _ in self.spawns:
            edits += self._without_options(call)
        edits += self._names()
        if any("PythonExpression(" in edit.text for edit in edits):
            needed.append(("launch.substitutions", "PythonExpression"))
        if (self.includes or self.processes) and (bridge := self._bridge(edits)) is not None:
            edits.append(bridge[0])
            needed += bridge[1]
        edits += self.file.all_imports(needed)
        entries = [ReportEntry(EntryKind.DONE, "the launch file starts gz", self._place(), authority=_AUTHORITY)]
        if dropped := sorted({name for call, scope, _ in self.includes for name in self._dropped(call, scope)}):
            what = f"gz has no argument {', '.join(dropped)}: dropped"
            entries.append(ReportEntry(EntryKind.DONE, what, self._place(), authority=_AUTHORITY))
        yield Proposal(tuple(outermost(edits)), entries=tuple(entries))

    def _pairs(self, call: ast.Call, scope: ast.AST) -> tuple[ast.expr | None, list[tuple[str, ast.expr]]]:
        """The dict with the arguments of an included launch file, None if it is not known, and its items."""
        given = keyword(call, "launch_arguments")
        value = given.value if given else None
        inner = value.func.value if isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute) else value
        known = self.file.value_of(inner, scope) if inner is not None else None
        if not isinstance(known, ast.Dict):
            return None, []
        return known, [(text_of(key), item) for key, item in zip(known.keys, known.values, strict=True)]

    def _dropped(self, call: ast.Call, scope: ast.AST) -> list[str]:
        """The arguments of an included launch file that gz does not have."""
        return [name for name, _ in self._pairs(call, scope)[1] if name not in ARGUMENTS]

    def _place(self) -> Place:
        calls: list[ast.expr] = [call for call, _, _ in self.includes]
        calls += [call for call, _ in self.spawns]
        return self.file.at([*calls, *(process.command for process in self.processes)][0])

    def _without_options(self, call: ast.Call) -> Iterator[Edit]:
        """The edits that remove the arguments of a spawner that gz does not know."""
        given = keyword(call, "arguments")
        items = given.value.elts if given and isinstance(given.value, ast.List) else []
        kept = [item for _, item in create_options([(text_of(item), item) for item in items])]
        yield from self.file.without_all(items, [item for item in items if item not in kept])

    def _arguments(self, call: ast.Call, scope: ast.AST, name: str) -> Iterator[Edit]:
        """The edit of the arguments of an included launch file."""
        given = keyword(call, "launch_arguments")
        known, pairs = self._pairs(call, scope)
        text = f'{{"{self.gz["argument"]}": {self._gz_arguments(name, pairs, scope)}}}'
        if known is not None:
            yield Edit(self.file.span(known), text)
        elif given is not None:
            yield Edit(self.file.span(given.value), f"{text}.items()")
        else:
            last = self.file.span(call.args[-1] if call.args else call.keywords[-1].value).end
            yield Edit(SourceSpan(self.file.source, last, last), f", launch_arguments={text}.items()")

    def _gz_arguments(self, name: str, pairs: list[tuple[str, ast.expr]], scope: ast.AST) -> str:
        """The arguments of gz, as an expression in Python, for those of an included launch file."""
        written = {key: " ".join(self.file.text(item).split()) for key, item in pairs}
        values = ((key, self.file.value_of(item, scope)) for key, item in pairs)
        given = {key: text_of(value) if isinstance(value, ast.Constant) else None for key, value in values}
        options, open_ones = flags(name, given), undecided(name, given)
        world = written.get("world", "")
        if name == CLIENT:
            return f'"{options.strip()}"'
        if is_empty_world(world.strip("'\""), is_own=has_own_empty_world(self.packages)):
            world = '"empty.sdf"'
            if not open_ones:
                return f'"{options}empty.sdf"'
        conditions = (self._condition(option, written[option.argument]) for option in open_ones)
        items = [f'"{options}"', *conditions, world]
        return f"[{', '.join(items)}]"

    @staticmethod
    def _condition(option: GzOption, value: str) -> str:
        """An option of gz that depends on an expression for an argument of Gazebo Classic."""
        head, _, tail = option.expression("'@'").partition("@")
        return f'PythonExpression(["{head}", {value}, "{tail}"])'

    def _names(self) -> Iterator[Edit]:
        """The edits of names in the file: packages, programs, launch files and worlds.

        A launch file of another package may have the name of one of gazebo_ros.
        """
        launch = self.gz["launch"]
        of_classic = {id(node) for call, scope, _ in self.includes for node in self._reached(call, scope)}
        files = {f"{start}{name}": f"{start}{launch}" for name in FILES for start in ("", "/launch/", "launch/", "/")}
        new = {
            "gazebo_ros": self.gz["package"],
            SPAWN: "create",
            "-entity": "-name",
            **files,
            **({} if has_own_empty_world(self.packages) else dict.fromkeys(EMPTY_WORLDS, "empty.sdf")),
            "GAZEBO_MODEL_PATH": "GZ_SIM_RESOURCE_PATH",
            "GAZEBO_RESOURCE_PATH": "GZ_SIM_RESOURCE_PATH",
        }
        paths = list(empty_world_paths(self.file))
        yield from (Edit(self.file.span(path), f'"{EMPTY}"') for path, is_classic in paths if is_classic)
        kept = {id(node) for path, _ in paths for node in ast.walk(path) if _is_empty(node)}
        for node in ast.walk(self.file.tree) if self.file.tree else ():
            if not isinstance(node, ast.Constant) or not isinstance(node.value, str) or id(node) in kept:
                continue
            if node.value in new and (node.value not in files or id(node) in of_classic):
                span = self.file.span(node)
                yield Edit(span, span.text.replace(node.value, new[node.value]))

    def _bridge(self, others: Sequence[Edit]) -> tuple[Edit, list[tuple[str, str]]] | None:
        """The edit that adds the bridge of the clock and of the robot's topics, and what it imports; None if it cannot
        be placed, or is there."""
        if b"parameter_bridge" in self.file.source.data:
            return None
        found = bridge_file_of(self.packages, self.file.source.path)
        needed = [("launch_ros.actions", "Node")]
        if found is not None:
            needed.insert(0, ("launch_ros.substitutions", "FindPackageShare"))
            needed.insert(0, ("launch.substitutions", "PathJoinSubstitution"))
            path = f'PathJoinSubstitution([FindPackageShare("{found}"), "{BRIDGE_FILE}"])'
            more = f'\n    parameters=[{{"config_file": {path}}}],\n'
        else:
            more = f'arguments=["/clock@rosgraph_msgs/msg/Clock[{self.gz["messages"]}.Clock"]'
        package, program = f'package="{self.gz["bridge"]}",', 'executable="parameter_bridge",'
        text = f"Node(\n    {package}\n    {program}{more})" if found else f"Node({package} {program} {more})"
        placed = self._added(text, others)
        return None if placed is None else (placed, needed)

    def _added(self, text: str, others: Sequence[Edit]) -> Edit | None:
        """The edit that adds an action to the launch description, beside others."""
        for call, scope in self.file.calls("LaunchDescription"):
            items = call.args[0] if call.args else None
            if isinstance(items, ast.List) and items.elts:
                indent = self.file.indent_of(items.elts[-1])
                return self.file.appended(items, [text.replace("\n", f"\n{indent}")], others)
            edit = self._before_return(call, scope, text)
            if edit is not None:
                return edit
            known = self.file.value_of(items, scope) if items is not None else None
            if items is not None and isinstance(known, ast.List | ast.BinOp):
                end = self.file.span(items).end
                return Edit(SourceSpan(self.file.source, end, end), f" + [{text}]")
        return None

    def _before_return(self, call: ast.Call, scope: ast.AST, text: str) -> Edit | None:
        for node in ast.walk(scope):
            if isinstance(node, ast.Return) and isinstance(node.value, ast.Name):
                value = self.file.value_of(node.value, scope)
                if value is call:
                    start = self.file.span(node).start
                    indent = self.file.indent_of(node)
                    added = f"{node.value.id}.add_action({text})\n".replace("\n", f"\n{indent}")
                    return Edit(SourceSpan(self.file.source, start, start), added)
        return None

    # -- to real hardware ----------------------------------------------------------------------------------------------

    def to_hardware(self) -> Iterator[Proposal]:
        if simulated_by(self.packages) != "none" or not (self.includes or self.spawns):
            return
        manager = self._manager()
        if manager is None or len(self.includes) != 1:
            at = self.file.at((self.includes or self.spawns)[0][0])
            yield for_you(at, "start ros2_control_node with the controller file, instead of Gazebo Classic")
            return
        edits = [Edit(self.file.span(self.includes[0][0]), manager), *self._clock()]
        for call, scope in self.spawns:
            edits += self._without_spawn(call, scope)
        entry = ReportEntry(
            EntryKind.DONE, "the launch file starts ros2_control_node", self._place(), authority=_AUTHORITY
        )
        yield Proposal(tuple(edits), entries=(entry,))

    def _clock(self) -> Iterator[Edit]:
        """The edits that make nodes and controllers use the time of the system."""
        for node in ast.walk(self.file.tree) if self.file.tree else ():
            for key, value in zip(node.keys, node.values, strict=True) if isinstance(node, ast.Dict) else ():
                if text_of(key) == "use_sim_time" and isinstance(value, ast.Constant) and value.value is True:
                    yield Edit(self.file.span(value), "False")
        for path in self._controller_files():
            source = self.packages.read(path)
            for found in re.finditer(rb"(?m)^\s+use_sim_time:\s*(true|True)\b", source.data):
                yield Edit(SourceSpan(source, *found.span(1)), "false")

    def _controller_files(self) -> list[str]:
        """The controller files of the package."""
        folder = package_around(os.path.dirname(self.file.source.path))
        yamls = (path for path in self.packages.files(".yaml") if folder and path.startswith(folder + os.sep))
        texts = {path: self.packages.read(path).data for path in yamls}
        return [path for path, text in texts.items() if b"controller_manager" in text and b"ros__parameters" in text]

    def _manager(self) -> str | None:
        """The controller manager of the package's only controller file, in the namespace of the spawned robot."""
        folder = package_around(os.path.dirname(self.file.source.path))
        name = package_name(os.path.join(folder, "package.xml")) if folder else None
        files = self._controller_files()
        if folder is None or name is None or len(files) != 1:
            return None
        address = os.path.relpath(files[0], folder).replace(os.sep, "/")
        spaces = (keyword(call, "namespace") for call, _ in self.spawns)
        space = next((f"namespace={self.file.text(each.value)}, " for each in spaces if each), "")
        remap = 'remappings=[("~/robot_description", "robot_description")]'
        more = "" if self.packages.options.target in since("jazzy") else f", {remap}"
        file = f'[FindPackageShare("{name}"), "/{address}"]'
        start = 'Node(package="controller_manager", executable="ros2_control_node", '
        return f"{start}{space}parameters=[ParameterFile({file})]{more})"

    def _without_spawn(self, call: ast.Call, scope: ast.AST) -> Iterator[Edit]:
        """The edits that remove a spawner of the model, and start at once what waited for it."""
        name = self._name_of(call, scope)
        for node in ast.walk(scope):
            if isinstance(node, ast.List):
                for item in node.elts:
                    if item is call or (isinstance(item, ast.Name) and item.id == name):
                        yield self.file.without(node.elts, item)
            elif isinstance(node, ast.Assign) and node.value is call:
                span = self.file.span(node)
                line = self.file.source.data.rfind(b"\n", 0, span.start) + 1
                end = self.file.source.data.find(b"\n", span.end) + 1
                yield Edit(SourceSpan(self.file.source, line, end or span.end), "")
            elif isinstance(node, ast.Call) and (waiting := self._waiting(node, name)) is not None:
                yield Edit(self.file.span(node), ", ".join(self.file.text(item) for item in waiting))
        imports = self.file.imports("launch_ros.parameter_descriptions", "ParameterFile")
        if imports is not None:
            yield imports

    @staticmethod
    def _name_of(call: ast.Call, scope: ast.AST) -> str:
        """The name that a call is assigned to; empty if it is not assigned."""
        for node in ast.walk(scope):
            if isinstance(node, ast.Assign) and node.value is call and isinstance(node.targets[0], ast.Name):
                return node.targets[0].id
        return ""

    @staticmethod
    def _waiting(node: ast.Call, name: str) -> list[ast.expr] | None:
        """What starts when the named process exits; None if the call is no such handler."""
        inner = node.args[0] if getattr(node.func, "id", "") == "RegisterEventHandler" and node.args else None
        if not isinstance(inner, ast.Call):
            return None
        target, then = keyword(inner, "target_action"), keyword(inner, "on_exit")
        if target is None or then is None or getattr(target.value, "id", None) != name:
            return None
        return then.value.elts if isinstance(then.value, ast.List) else [then.value]


def _is_empty(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and text_of(node) in EMPTY_WORLDS


CLASSIC_LAUNCH = Step(
    name="classic-launch-files",
    part=Part.LAUNCH,
    summary="Launch files in Python that start Gazebo Classic",
    propose=_launch_python,
    rows=(
        Row("gazebo_ros gazebo.launch.py: world", "ros_gz_sim gz_sim.launch.py: gz_args", "jazzy", _AUTHORITY),
        Row("gzserver.launch.py, gzclient.launch.py", "gz_sim.launch.py with -s, with -g", "jazzy", _AUTHORITY),
        Row("gazebo, gzserver, gzclient by ExecuteProcess", "gz_sim.launch.py: gz_args", "jazzy", _AUTHORITY),
        Row("spawn_entity.py -entity NAME", "ros_gz_sim create -name NAME", "jazzy", _AUTHORITY),
        Row("the clock of Gazebo Classic", "ros_gz_bridge parameter_bridge", "jazzy", _AUTHORITY),
        Row("GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH", "jazzy", _AUTHORITY),
    ),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch.actions import IncludeLaunchDescription
                from launch.launch_description_sources import PythonLaunchDescriptionSource
                from launch.substitutions import PathJoinSubstitution
                from launch_ros.actions import Node
                from launch_ros.substitutions import FindPackageShare


                def generate_launch_description():
                    gazebo = PathJoinSubstitution([FindPackageShare("gazebo_ros"), "launch", "gazebo.launch.py"])
                    return LaunchDescription([
                        IncludeLaunchDescription(PythonLaunchDescriptionSource(gazebo)),
                        Node(package="gazebo_ros", executable="spawn_entity.py", arguments=["-entity", "arm"]),
                    ])
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch.actions import IncludeLaunchDescription
                from launch.launch_description_sources import PythonLaunchDescriptionSource
                from launch.substitutions import PathJoinSubstitution
                from launch_ros.actions import Node
                from launch_ros.substitutions import FindPackageShare


                def generate_launch_description():
                    gazebo = PathJoinSubstitution([FindPackageShare("ros_gz_sim"), "launch", "gz_sim.launch.py"])
                    return LaunchDescription([
                        IncludeLaunchDescription(PythonLaunchDescriptionSource(gazebo), launch_arguments={"gz_args": "-r empty.sdf"}.items()),
                        Node(package="ros_gz_sim", executable="create", arguments=["-name", "arm"]),
                        Node(package="ros_gz_bridge", executable="parameter_bridge", arguments=["/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"]),
                    ])
            """,
        },
    ],
)
