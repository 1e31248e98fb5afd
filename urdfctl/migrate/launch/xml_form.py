"""Write actions as a launch file in XML."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.generate.text.scalars import xml_comment, xml_text
from urdfctl.migrate.launch.actions import Action, Text, parsed
from urdfctl.migrate.launch.expressions import Used, parts_of

_STEP = "  "


def xml_file(actions: Sequence[Action], about: str) -> str:
    """Return a launch file in XML. `about` is the comment at its beginning."""
    lines = [line for action in actions for line in _action(action, 1)]
    return (
        "\n".join(['<?xml version="1.0"?>', f"<!-- {xml_comment(about)} -->", "<launch>", *lines, "</launch>"]) + "\n"
    )


def _action(action: Action, depth: int) -> Iterator[str]:
    indent = _STEP * depth
    if action.kind == "comment":
        yield f"{indent}<!-- {xml_comment(action.name)} -->"
        return
    tag, attributes, children = _element(action, depth)
    if action.condition is not None:
        attributes.append(("unless" if action.condition.negated else "if", _text(action.condition.text)))
    head = "".join(f' {name}="{value}"' for name, value in attributes)
    if not children:
        yield f"{indent}<{tag}{head}/>"
        return
    yield f"{indent}<{tag}{head}>"
    yield from children
    yield f"{indent}</{tag}>"


def _element(action: Action, depth: int) -> tuple[str, list[tuple[str, str]], list[str]]:
    value = _text(action.value or ())
    inner = _STEP * (depth + 1)
    if action.kind == "argument":
        more = [("default", value)] if action.value is not None else []
        about = [("description", xml_text(action.about))] if action.about else []
        return "arg", [("name", action.name), *more, *about], []
    if action.kind in {"let", "set_parameter", "set_env"}:
        return action.kind, [("name", action.name), ("value", value)], []
    if action.kind == "set_remap":
        return "set_remap", [("from", _text(action.remaps[0][0])), ("to", _text(action.remaps[0][1]))], []
    if action.kind == "include":
        given = [f'{inner}<arg name="{name}" value="{_text(text)}"/>' for name, text in action.pairs]
        return "include", [("file", value)], given
    if action.kind == "group":
        push = [f'{inner}<push-ros-namespace namespace="{value}"/>'] if action.value else []
        return "group", [], [*push, *(line for each in action.inner for line in _action(each, depth + 1))]
    if action.kind == "process":
        words = [_text(word) for word in action.words]
        command = " ".join(f"'{word}'" if " " in word else word for word in words)
        return "executable", [("cmd", command), *_flags(action)], []
    return "node", list(_attributes(action)), [f"{inner}{line}" for line in _children(action)]


def _attributes(node: Action) -> Iterator[tuple[str, str]]:
    yield "pkg", _text(parsed(node.package))
    yield "exec", _text(parsed(node.name))
    if node.node_name:
        yield "name", _text(node.node_name)
    if node.value:
        yield "namespace", _text(node.value)
    if node.words:
        yield "args", " ".join(map(_word, node.words))
    yield from _flags(node)


def _flags(action: Action) -> Iterator[tuple[str, str]]:
    for name, value in action.flags:
        if name != "condition":
            yield (
                name.replace("prefix", "launch-prefix"),
                value.lower() if value in {"True", "False"} else xml_text(value),
            )


def _children(node: Action) -> Iterator[str]:
    if node.description:
        yield f'<param name="robot_description" value="{_command(node.description)}" type="str"/>'
    for file in node.files:
        yield f'<param from="{_text(file)}"/>'
    for name, value in node.pairs:
        kind = ' type="float"' if value and value[0].kind == "double" else ""
        yield f'<param name="{name}" value="{_text(value)}"{kind}/>'
    for name, value in node.env:
        yield f'<env name="{name}" value="{_text(value)}"/>'
    for old, new in node.remaps:
        yield f'<remap from="{_text(old)}" to="{_text(new)}"/>'


def _word(word: Text) -> str:
    """A word of a command line, in quotes if it has blanks."""
    has_blank = any(part.kind == "text" and " " in part.text for part in word)
    return f"'{_text(word)}'" if has_blank else _text(word)


def _text(text: Text) -> str:
    return "".join(_part(part.kind, part.text, part.default) for part in text)


def _part(kind: str, text: str, default: str | None) -> str:
    if kind == "arg":
        return f"$(var {text})"
    if kind == "find":
        return f"$(find-pkg-share {text})"
    if kind == "env":
        return f"$(env {text})" if default is None else f"$(env {text} '{xml_text(default)}')"
    if kind == "dirname":
        return "$(dirname)"
    if kind == "command":
        return _command(parsed(text))
    if kind == "written":
        return text
    if kind == "eval":
        return f"$(eval &quot;{''.join(map(_in_expression, parts_of(text)))}&quot;)"
    return xml_text(text)


def _command(words: Text) -> str:
    """What a command prints; its warnings end no launch."""
    command = _text(words).replace("'", "&quot;")
    return f"$(command '{command}' 'warn')"


def _in_expression(part: str | Used) -> str:
    if not isinstance(part, Used):
        return xml_text(part)
    return f"{xml_text(part.before)}{_part(part.kind, part.name, part.default)}{xml_text(part.after)}"
