"""Read the parameter definitions of generate_parameter_library into the catalogue's form of parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from urdfctl.catalog.validators import NAMES
from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.source.yaml.tree import Mapping as YamlMap
from urdfctl.source.yaml.tree import Node, Scalar, Sequence, YamlFile
from urdfctl.source.yaml.types import typed_by_pyyaml
from urdfctl.startup.records import NamedTuple

_TYPE = re.compile(r"((?:bool|int|double|string)(?:_array)?|none)(?:_fixed_(\d+))?")
_MAP = "__map_"
_OF_PAIRS = ("bounds", "element_bounds")
_OF_LISTS = ("one_of", "subset_of")
_OF_NOTHING = ("not_empty", "unique")


class Definition(NamedTuple):
    """A definition file.

    namespace: the name of the generated code's namespace.
    parameters: the parameters by dotted name, as in the catalogue's data.
    """

    namespace: str
    parameters: Mapping[str, Mapping[str, Any]]


def definition_of(file: YamlFile) -> Definition | None:
    """Return the definition in a YAML file; None if the file is not a definition of parameters, or has tags that
    Python's safe reader rejects, and so the generator of the code.
    """
    if file.python_tags:
        return None
    root = file.documents[0] if len(file.documents) == 1 else None
    if not isinstance(root, YamlMap) or len(root.entries) != 1:
        return None
    namespace, content = root.entries[0].key.text, root.entries[0].value
    if not isinstance(content, YamlMap):
        return None
    parameters = dict(_parameters(content, ""))
    return Definition(namespace, parameters) if parameters else None


def _parameters(content: YamlMap, prefix: str) -> Iterator[tuple[str, dict[str, Any]]]:
    for entry in content.entries:
        key, value = entry.key.text, entry.value
        name = prefix + (f"<{key.removeprefix(_MAP)}>" if key.startswith(_MAP) else key)
        if not isinstance(value, YamlMap):
            continue
        kind = value.get("type")
        found = _TYPE.fullmatch(kind.text) if isinstance(kind, Scalar) else None
        if found:
            yield name, _parameter(value, found[1], found[2])
        elif not isinstance(kind, Scalar):
            yield from _parameters(value, f"{name}.")


def _parameter(content: YamlMap, kind: str, size: str | None) -> dict[str, Any]:
    """One parameter; without a default it is required."""
    parameter: dict[str, Any] = {"type": kind}
    default = content.get("default_value")
    if default is not None:
        parameter["default"] = _value(default)
    elif kind != "none":
        parameter["required"] = True
    validators = dict(_validators(content.get("validation")))
    if size is not None:
        validators.setdefault("size_lt", int(size) + 1)
    if validators:
        parameter["validators"] = validators
    return parameter


def _validators(node: Node | None) -> Iterator[tuple[str, Any]]:
    """The validators that come with generate_parameter_library; what others check is not known."""
    for entry in node.entries if isinstance(node, YamlMap) else ():
        name = entry.key.text.removesuffix("<>")
        name = name.rpartition("::")[2] if name.startswith("rsl::") else name
        if name not in NAMES:
            continue
        value = _value(entry.value)
        arguments = value if isinstance(value, list) else [value]
        limit = _limit(name, arguments)
        if limit is not None:
            yield name, limit


def _limit(name: str, arguments: list[Any]) -> Any:
    """The argument of a validator in the catalogue's form; None if it has another form."""
    if name in _OF_NOTHING:
        return True
    if name in _OF_PAIRS:
        return arguments if len(arguments) == 2 and all(map(_is_number, arguments)) else None  # noqa: PLR2004
    if name in _OF_LISTS:
        choices = arguments[0] if len(arguments) == 1 and isinstance(arguments[0], list) else None
        return choices or None
    return arguments[0] if len(arguments) == 1 and _is_number(arguments[0]) else None


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _value(node: Node) -> Any:
    if isinstance(node, Sequence):
        return [_value(item) for item in node.items]
    if isinstance(node, YamlMap):
        return {entry.key.text: _value(entry.value) for entry in node.entries}
    typed = typed_by_pyyaml(node)
    return None if typed.kind is ValueKind.NULL else typed.value
