"""Launch files in Python."""

from __future__ import annotations

import re
from textwrap import indent

from systems.possible import WRAPPED, Idioms
from systems.render.actions import (
    Action,
    After,
    Description,
    Execute,
    Group,
    Include,
    LaunchFile,
    Loop,
    Node,
    Param,
    ParamFile,
    Share,
    Timer,
    Value,
    parts_of,
)
from systems.render.launch.frontends import FileNames
from systems.render.launch.python_descriptions import description, helper
from systems.render.launch.python_values import PythonValues, call, listed
from systems.render.parameters import RATE
from systems.render.places import pick
from systems.system import System

_SOURCES = {
    "py": "PythonLaunchDescriptionSource",
    "xml": "XMLLaunchDescriptionSource",
    "yaml": "YAMLLaunchDescriptionSource",
}


def written(file: LaunchFile, system: System, idioms: Idioms, names: FileNames) -> str:
    """Return the text of a launch file in Python."""
    return _Writer(file, system, idioms, names).text()


class _Writer:
    """Writes one launch file: statements first, then the list of its actions."""

    def __init__(self, file: LaunchFile, system: System, idioms: Idioms, names: FileNames) -> None:
        self.file, self.system, self.idioms, self.names = file, system, idioms, names
        nodes = any(isinstance(part, Node | Execute) for part in parts_of(file.actions))
        self.values = PythonValues(idioms, nodes and idioms["values"] == "perform", file.package)
        self.statements: list[str] = []
        self.variables: dict[str, str] = {}
        self.descriptions: dict[Description, str] = {}
        self.plain = any(part.is_plain for part in parts_of(file.actions) if isinstance(part, Description))

    def text(self) -> str:
        """Return the whole file."""
        self._hoist()
        items = [self._item(action) for action in self.file.actions]
        body = self._performed(items) if self.values.performs else self._declarative(items)
        uses_helper = self.descriptions and self.idioms["description"] == "function"
        functions = f"{helper(is_plain=self.plain)}\n\n" if uses_helper else ""
        imports = sorted(self.values.imports, key=lambda line: (line.startswith("from"), line))
        return "\n".join(imports) + f"\n\n\n{functions}{body}"

    # -- the frame ------------------------------------------------------------------------------------------------

    def _declared(self) -> list[str]:
        found = []
        for name, default in self.file.declared:
            words = [f'"{name}"']
            if default is not None and self.file.is_set:
                words.append(self._default(default))
                found.append(call(self.values.use("SetLaunchConfiguration"), *words))
                continue
            if default is not None:
                words.append(f"default_value={self._default(default)}")
            found.append(call(self.values.use("DeclareLaunchArgument"), *words))
        return found

    def _default(self, default: Value) -> str:
        """The default of an argument, which is declared where there is no launch context."""
        self.values.performs, before = False, self.values.performs
        text = self.values.value(default)
        self.values.performs = before
        return text

    def _declarative(self, items: list[str]) -> str:
        self.values.use("LaunchDescription")
        declared = self._declared()
        lines = list(self.statements)
        layout = self.idioms["layout"]
        if layout == "add_action":
            lines.append("ld = LaunchDescription()")
            lines += [_added(item) for item in [*declared, *items]]
            lines.append("return ld")
        elif layout == "variables":
            lines.append(f"declared_arguments = {listed(declared)}")
            lines.append(f"nodes = {listed(items)}")
            lines.append("return LaunchDescription(declared_arguments + nodes)")
        else:
            lines.append(f"return {call('LaunchDescription', listed([*declared, *items]))}")
        return _function("generate_launch_description()", lines)

    def _performed(self, items: list[str]) -> str:
        self.values.use("LaunchDescription")
        lines = [*self.statements, f"actions = {listed([item for item in items if not item.startswith('if ')])}"]
        lines += [item for item in items if item.startswith("if ")]
        lines.append("return actions")
        setup = _function("launch_setup(context, *args, **kwargs)", lines)
        declared = self._declared()
        before, called = self._called(f"{self.values.use('OpaqueFunction')}(function=launch_setup)")
        frame = [f"return {call('LaunchDescription', listed([*declared, *called]))}"]
        if self.idioms["layout"] == "add_action":
            frame = ["ld = LaunchDescription()", *(_added(item) for item in [*declared, *called]), "return ld"]
        frame[:0] = before
        return f"{setup}\n\n{_function('generate_launch_description()', frame)}"

    def _called(self, opaque: str) -> tuple[list[str], list[str]]:
        """Statements and actions that call the function: at once, later, or when a process has ended."""
        how = self.idioms["opaque"]
        if how == "timer":
            return [], [call(self.values.use("TimerAction"), "period=2.0", f"actions=[{opaque}]")]
        if how == "event":
            before = f'daemon = {self.values.use("ExecuteProcess")}(cmd=["ros2", "daemon", "start"])'
            event = call(self.values.use("OnProcessExit"), "target_action=daemon", f"on_exit=[{opaque}]")
            return [before], ["daemon", call(self.values.use("RegisterEventHandler"), event)]
        return [], [opaque]

    def _hoist(self) -> None:
        """Give variables to what event handlers name, or to all nodes."""
        targets = {part.label for part in parts_of(self.file.actions) if isinstance(part, After)}
        everything = self.idioms["layout"] == "variables"
        for part in parts_of(self.file.actions):
            if isinstance(part, Node | Execute) and part.label and (everything or part.label in targets):
                name = re.sub(r"\W", "_", part.label)
                self.statements.append(f"{name} = {self._started(part)}")
                self.variables[part.label] = name

    # -- actions --------------------------------------------------------------------------------------------------

    def _item(self, action: Action) -> str:
        if isinstance(action, Node | Execute):
            return self.variables.get(action.label) or self._started(action)
        if isinstance(action, Include):
            return self._include(action)
        if isinstance(action, Group):
            return self._group(action)
        if isinstance(action, Timer):
            inside = listed([self._item(each) for each in action.actions])
            return call(self.values.use("TimerAction"), f"period={action.seconds}", f"actions={inside}")
        if isinstance(action, After):
            return self._handler(action)
        return self._loop(action)

    def _handler(self, action: After) -> str:
        inside = listed([self._item(each) for each in action.actions])
        name = self.values.use("OnProcessExit" if action.event == "exit" else "OnProcessStart")
        target = f"target_action={self.variables[action.label]}"
        event = call(name, target, f"on_{action.event}={inside}")
        return call(self.values.use("RegisterEventHandler"), event)

    def _group(self, action: Group) -> str:
        inside = [self._item(each) for each in action.actions]
        if action.when is not None and action.when.form == "python":
            sign = "==" if action.when.holds else "!="
            value = self.values.configuration(action.when.arg)
            return f'if {value} {sign} "{action.when.value}":\n    actions += {_inner(listed(inside))}'
        if action.namespace:
            inside.insert(0, f"{self.values.use('PushRosNamespace')}({self.values.value(action.namespace)})")
        words = [listed(inside)]
        if action.when is not None:
            words.append(f"condition={self.values.condition(action.when)}")
        return call(self.values.use("GroupAction"), *words)

    def _loop(self, loop: Loop) -> str:
        names = listed([f'"{name}"' for name in loop.names])
        node = self._started(loop.node)
        if loop.style == "comprehension":
            return f"*[{node} for name in {names}]"
        if loop.style == "function":
            return self._by_function(names, node)
        if loop.listed:
            self.values.imports.add("import yaml")
            self.statements.append(f"with open({self.values.text(loop.listed)}) as file:")
            self.statements.append('    names = yaml.safe_load(file)["controllers"]')
            names = "names"
        variable = f"spawners{len(self.variables) or ''}"
        self.variables[variable] = variable
        self.statements.append(f"{variable} = []\nfor name in {names}:\n    {variable}.append({_inner(node)})")
        return f"*{variable}"

    def _by_function(self, names: str, node: str) -> str:
        """Nodes that a function of the launch file makes: a function for each robot, with a name of its own."""
        function = f"spawner{len(self.variables) or ''}"
        self.variables[function] = function
        self.statements.append(f"def {function}(name):\n    return {_inner(node)}\n")
        return f"*[{function}(each) for each in {names}]"

    def _include(self, action: Include) -> str:
        if action.path:
            source = self.values.use("AnyLaunchDescriptionSource")
            return call(self.values.use("IncludeLaunchDescription"), f"{source}({self.values.value(action.path)})")
        path = action.file if action.is_external else f"launch/{self.names(action.package, action.file)}"
        parts = tuple((part,) for part in path.split("/"))
        value = self.values.value((Share((action.package,), parts),))
        source = self.values.use(_SOURCES[path.rpartition(".")[2]])
        if pick(self.system, "any source", (False, False, True)):
            source = self.values.use("AnyLaunchDescriptionSource")
        words = [f"{source}({value})"]
        if action.arguments:
            pairs = [f'"{name}": {self.values.value(given)}' for name, given in action.arguments]
            words.append(f"launch_arguments={{{', '.join(pairs)}}}.items()")
        return call(self.values.use("IncludeLaunchDescription"), *words)

    # -- processes ------------------------------------------------------------------------------------------------

    def _started(self, action: Node | Execute) -> str:
        condition = [f"condition={self.values.condition(action.when)}"] if action.when is not None else []
        if isinstance(action, Execute):
            words = listed([self.values.value(word) for word in action.words])
            return call(self.values.use("ExecuteProcess"), f"cmd={words}", 'output="screen"', *condition)
        if action.package == "webots_ros2_driver":
            return self._driver(action)
        words = [f'package="{action.package}"', f'executable="{action.executable}"']
        words += [f'name="{action.name}"'] if action.name else []
        words += [f"namespace={self.values.value(action.namespace)}"] if action.namespace else []
        words += [f"parameters={listed(self._parameters(action))}"] if action.parameters else []
        words += [f"arguments={listed([self._word(word) for word in action.arguments])}"] if action.arguments else []
        if action.remaps:
            words.append(f"remappings={listed([str(remap).replace(chr(39), chr(34)) for remap in action.remaps])}")
        return call(self.values.use("Node"), *words, *condition)

    def _driver(self, node: Node) -> str:
        """Webots' driver, whose parameters are texts: `WebotsController` takes no substitution for a path."""
        files = [self.values.text(one.path) for one in node.parameters if isinstance(one, ParamFile)]
        found = (one.value for one in node.parameters if isinstance(one, Param))
        paths = [self.values.text(one.path) for one in found if isinstance(one, Description)]
        items = [*(f'{{"robot_description": {path}}}' for path in paths), *files]
        return call(self.values.use("WebotsController"), 'robot_name="robot"', f"parameters={listed(items)}")

    def _word(self, word: Value) -> str:
        """A word of a command line; it may be the whole description."""
        found = next((piece for piece in word if isinstance(piece, Description)), None)
        return self.values.value(word) if found is None else self._description(found)

    def _parameters(self, node: Node) -> list[str]:
        items: list[str] = []
        plain: list[str] = []
        for parameter in node.parameters:
            if isinstance(parameter, ParamFile):
                items.append(self._file(parameter))
            elif isinstance(parameter.value, Description):
                text = self._description(parameter.value)
                if self.idioms["wrapped"] == "where used" and self.idioms["description"] not in WRAPPED:
                    text = f"{self.values.use('ParameterValue')}({text}, value_type=str)"
                plain.append(f'"{parameter.name}": {text}')
            else:
                plain.append(self._plain(parameter))
        mapping = [f"{{{', '.join(plain)}}}"] if plain else []
        return [*items, *mapping] if items else mapping

    def _plain(self, parameter: Param) -> str:
        value = f'"{parameter.value}"' if isinstance(parameter.value, str) else str(parameter.value)
        if self.idioms["wrapped"] != "nothing" and isinstance(parameter.value, bool):
            value = f"{self.values.use('ParameterValue')}({value}, value_type=bool)"
        name, dot, last = parameter.name.partition(".")
        if dot and pick(self.system, "nested dictionary", (False, True)):
            return f'"{name}": {{"{last}": {value}}}'
        return f'"{parameter.name}": {value}'

    def _file(self, parameter: ParamFile) -> str:
        path = self.values.value(parameter.path)
        if not parameter.rewritten:
            return path
        if parameter.rewritten == "written":
            self.statements += self._written(path)
            return "written.name"
        namespace = self.values.value(parameter.namespace)
        if parameter.rewritten == "replaced":
            replacements = f'replacements={{"<robot_namespace>": ("/", {namespace})}}'
            return call(self.values.use("ReplaceString"), f"source_file={path}", replacements)
        words = (f"source_file={path}", f"root_key={namespace}", "param_rewrites={}", "convert_types=True")
        whole = call(self.values.use("RewrittenYaml"), *words)
        if pick(self.system, "parameter file", (False, True)):
            return call(self.values.use("ParameterFile"), whole, "allow_substs=True")
        return whole

    def _written(self, path: str) -> list[str]:
        """The statements that write a file of parameters from a template."""
        name = self.values.use("NamedTemporaryFile")
        return [
            f'with open({path}) as template:\n    text = template.read().replace("@rate@", "{RATE}")',
            f'with {name}("w", suffix=".yaml", delete=False) as written:\n    written.write(text)',
        ]

    def _description(self, found: Description) -> str:
        """The variable that holds a description."""
        if found not in self.descriptions:
            name = "robot_description" if not self.descriptions else f"robot_description_{len(self.descriptions) + 1}"
            before, text = description(self.values, found, self.file.package)
            self.statements += [*before, f"{name} = {text}"]
            self.descriptions[found] = name
        return self.descriptions[found]


def _added(item: str) -> str:
    """The statement that adds an action to a launch description."""
    if item.startswith("*[") and " for name in " in item:
        node, _, names = item[2:-1].rpartition(" for name in ")
        return f"for name in {names}:\n    ld.add_action({_inner(node)})"
    if item.startswith("*"):
        return f"for each in {item[1:]}:\n    ld.add_action(each)"
    return f"ld.add_action({item})"


def _inner(text: str) -> str:
    """A text of several lines that stands in a block."""
    return text.replace("\n", "\n    ")


def _function(head: str, lines: list[str]) -> str:
    return f"def {head}:\n{indent(chr(10).join(lines), '    ')}\n"
