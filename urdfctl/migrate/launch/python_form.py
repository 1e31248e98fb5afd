"""Write actions as a launch file in Python."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.generate.text.scalars import python_text
from urdfctl.migrate.launch.actions import Action, ActionCondition, Text, all_actions, is_literal, parsed, plain
from urdfctl.migrate.launch.expressions import Used, parts_of

_STEP = "    "
_NAMES = {
    "launch": ("LaunchDescription",),
    "launch.actions": (
        "DeclareLaunchArgument",
        "ExecuteProcess",
        "GroupAction",
        "IncludeLaunchDescription",
        "SetEnvironmentVariable",
        "SetLaunchConfiguration",
        "Shutdown",
    ),
    "launch.conditions": ("IfCondition", "UnlessCondition"),
    "launch.launch_description_sources": ("AnyLaunchDescriptionSource",),
    "launch.substitutions": (
        "Command",
        "EnvironmentVariable",
        "LaunchConfiguration",
        "PythonExpression",
        "ThisLaunchFileDir",
    ),
    "launch_ros.actions": ("Node", "PushRosNamespace", "SetParameter", "SetRemap"),
    "launch_ros.parameter_descriptions": ("ParameterFile", "ParameterValue"),
    "launch_ros.substitutions": ("FindPackageShare",),
}


_SETTINGS = {"let": "SetLaunchConfiguration", "set_env": "SetEnvironmentVariable"}
"""The classes of actions that are a name and a value."""


def python_file(actions: Sequence[Action], about: str) -> str:
    """Return a launch file in Python. `about` is the first line of its docstring."""
    body = [line for action in actions for line in _action(action, 3)]
    text = "\n".join(body)
    imports = [
        f"from {module} import {', '.join(used)}"
        for module, names in _NAMES.items()
        if (used := [name for name in names if re.search(rf"\b{name}\b", text) or name == "LaunchDescription"])
    ]
    head = [f'"""{about}"""', "", *imports, "", "", "def generate_launch_description():"]
    doc = f'{_STEP}"""Return the actions, in order."""'
    return (
        "\n".join(
            [*head, doc, f"{_STEP}return LaunchDescription(", f"{_STEP * 2}[", *body, f"{_STEP * 2}]", f"{_STEP})"]
        )
        + "\n"
    )


def _action(action: Action, depth: int) -> Iterator[str]:
    indent = _STEP * depth
    if action.kind == "comment":
        yield from (f"{indent}# {line}".rstrip() for line in action.name.splitlines())
        return
    head, arguments = _call(action, depth)
    if action.condition is not None:
        arguments.append(f"condition={_condition(action.condition)}")
    one_line = f"{indent}{head}({', '.join(arguments)}),"
    if len(one_line) <= 110 and "\n" not in one_line:  # noqa: PLR2004 (as wide as the files of ROS)
        yield one_line
        return
    yield f"{indent}{head}("
    for argument in arguments:
        yield f"{indent}{_STEP}{argument},"
    yield f"{indent}),"


def _call(action: Action, depth: int) -> tuple[str, list[str]]:
    """The class of an action, and the arguments of its constructor."""
    value = _text(action.value or ())
    if action.kind == "argument":
        more = [f"default_value={value}"] if action.value is not None else []
        about = [f"description={python_text(action.about)}"] if action.about else []
        return "DeclareLaunchArgument", [python_text(action.name), *more, *about]
    if action.kind in _SETTINGS:
        return _SETTINGS[action.kind], [python_text(action.name), value]
    if action.kind == "set_parameter":
        return "SetParameter", [f"name={python_text(action.name)}", f"value={_typed(action.value or ())}"]
    if action.kind == "set_remap":
        return "SetRemap", [f"src={_text(action.remaps[0][0])}", f"dst={_text(action.remaps[0][1])}"]
    if action.kind == "include":
        given = "".join(f"{python_text(name)}: {_text(text)}, " for name, text in action.pairs).rstrip(", ")
        more = [f"launch_arguments={{{given}}}.items()"] if given else []
        return "IncludeLaunchDescription", [f"AnyLaunchDescriptionSource({_listed(action.value or ())})", *more]
    if action.kind == "group":
        inner = [f"PushRosNamespace({value})"] if action.value else []
        lines = [line for each in action.inner for line in _action(each, depth + 2)]
        indent = _STEP * (depth + 1)
        body = "\n".join([*(f"{indent}{_STEP}{each}," for each in inner), *lines])
        return "GroupAction", [f"[\n{body}\n{indent}]"]
    if action.kind == "process":
        words = _items([_text(word) for word in action.words], depth + 1)
        return "ExecuteProcess", [f"cmd={words}", *(f"{name}={_flag(name, each)}" for name, each in action.flags)]
    return "Node", list(_node(action, depth))


def _node(node: Action, depth: int) -> Iterator[str]:
    yield f"package={_text(parsed(node.package))}"
    yield f"executable={_text(parsed(node.name))}"
    if node.node_name:
        yield f"name={_text(node.node_name)}"
    if node.value:
        yield f"namespace={_text(node.value)}"
    if node.words:
        yield f"arguments={_items([_text(word) for word in node.words], depth + 1)}"
    parameters = [f"ParameterFile({_listed(file)})" if not is_literal(file) else _text(file) for file in node.files]
    values = [f"{python_text(name)}: {_typed(value)}" for name, value in node.pairs]
    if node.description:
        values.insert(0, f'"robot_description": ParameterValue({_command(node.description)}, value_type=str)')
    if values:
        parameters.append(f"{{{', '.join(values)}}}")
    if parameters:
        yield f"parameters={_items(parameters, depth + 1)}"
    if node.remaps:
        pairs = [f"({_text(old)}, {_text(new)})" for old, new in node.remaps]
        yield f"remappings={_items(pairs, depth + 1)}"
    if node.env:
        yield f"additional_env={{{', '.join(f'{python_text(name)}: {_text(value)}' for name, value in node.env)}}}"
    for name, value in node.flags:
        yield f"{name}={_flag(name, value)}"


def _flag(name: str, value: str) -> str:
    if name == "on_exit":
        return "Shutdown()"
    return value if value in {"True", "False"} or name == "respawn_delay" else python_text(value)


def _items(items: Sequence[str], depth: int) -> str:
    one_line = f"[{', '.join(items)}]"
    if len(one_line) + len(_STEP) * depth <= 96:  # noqa: PLR2004 (leaves room for the keyword)
        return one_line
    inner = "".join(f"{_STEP * (depth + 1)}{item},\n" for item in items)
    return f"[\n{inner}{_STEP * depth}]"


def _text(text: Text) -> str:
    """A text as a Python expression."""
    parts = [_part(part.kind, part.text, part.default) for part in text]
    if not parts:
        return '""'
    return parts[0] if len(parts) == 1 else f"[{', '.join(parts)}]"


def _listed(text: Text) -> str:
    found = _text(text)
    return found if found.startswith("[") else f"[{found}]"


def _part(kind: str, text: str, default: str | None) -> str:
    if kind == "arg":
        return f"LaunchConfiguration({python_text(text)})"
    if kind == "find":
        return f"FindPackageShare({python_text(text)})"
    if kind == "env":
        more = "" if default is None else f", default_value={python_text(default)}"
        return f"EnvironmentVariable({python_text(text)}{more})"
    if kind == "dirname":
        return "ThisLaunchFileDir()"
    if kind == "command":
        return _command(parsed(text))
    if kind == "written":
        return text
    if kind == "eval":
        return f"PythonExpression([{_expression(text)}])"
    return python_text(text)


def _command(words: Text) -> str:
    """What a command prints; its warnings end no launch."""
    return f'Command({_listed(words)}, on_stderr="warn")'


def _expression(text: str) -> str:
    """The parts of an expression of $(eval), with the substitutions in it."""
    shown: list[str] = []
    before = ""
    for part in parts_of(text):
        if isinstance(part, Used):
            shown += [python_text(before + part.before), _part(part.kind, part.name, part.default)]
            before = part.after
        else:
            before += part
    return ", ".join(piece for piece in (*shown, python_text(before)) if piece not in ('""', "''"))


def _typed(text: Text) -> str:
    """A value of a parameter: roslaunch takes the type from the text."""
    if text and text[0].kind == "double":
        return f"ParameterValue({_text(text[1:])}, value_type=float)"
    if len(text) == 1 and text[0].kind == "yaml":
        return _python_value(text[0].text)
    if not is_literal(text):
        return _text(text)
    value = plain(text).strip()
    if value.lower() in {"true", "false"}:
        return value.capitalize()
    return value if re.fullmatch(r"-?\d+(\.\d*)?([eE][+-]?\d+)?", value) else python_text(value)


def _python_value(text: str) -> str:
    """A value in YAML's flow style as a Python literal."""
    import yaml

    value = yaml.safe_load(text)
    if isinstance(value, list):
        return f"[{', '.join(python_text(item) if isinstance(item, str) else repr(item) for item in value)}]"
    return python_text(value) if isinstance(value, str) else repr(value)


def _condition(condition: ActionCondition) -> str:
    name = "UnlessCondition" if condition.negated else "IfCondition"
    return f"{name}({_text(condition.text)})"


def packages_in(actions: Sequence[Action]) -> list[str]:
    """Return the packages that actions use, sorted."""
    names = {action.package for action in all_actions(tuple(actions)) if action.package}
    for action in all_actions(tuple(actions)):
        texts = [action.value or (), *action.words, *action.files, action.description, *(t for _, t in action.pairs)]
        texts += [parsed(part.text) for text in texts for part in text if part.kind == "command"]
        names |= {part.text for text in texts for part in text if part.kind == "find"}
    return sorted(names)
