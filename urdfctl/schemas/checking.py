"""Validate a file with its schema, and say where what does not fit is."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from urdfctl.catalog.distros import generation
from urdfctl.errors import UserError
from urdfctl.schemas.controllers import controllers_schema
from urdfctl.schemas.parameters import ROS_TYPE
from urdfctl.source.problem import ReadError
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.source.yaml.tree import Mapping as YamlMap
from urdfctl.source.yaml.tree import Node, Scalar, Sequence, YamlFile, read_yaml
from urdfctl.source.yaml.types import typed_by_pyyaml, typed_by_rcl
from urdfctl.startup.records import NamedTuple

_OF_LIBXML2 = "Warning: No precomputed value available"
"""libxml2 says this beside the error of a value that is not valid, where a key needs that value."""
_UNKNOWN = object()
"""The value of a text with a substitution, such as `$(var prefix)`."""


class SchemaFault(NamedTuple):
    """A place in a file that does not fit the schema, and why."""

    at: Place
    message: str


def faults_in_controllers(source: SourceText, distro: str) -> list[SchemaFault]:
    """Return where a controller file does not fit the schema for the types of its controllers.

    Raises UserError if jsonschema is not installed.
    """
    _needs("jsonschema")
    file = read_yaml(source)
    if not file.readable:
        return [SchemaFault(problem.at, problem.message) for problem in file.problems]
    validator = _validator(controllers_schema(distro, types_in(file)))
    found = [SchemaFault(problem.at, f"'{problem.subject}' makes a Python object") for problem in file.refused_tags]
    for document in file.documents:
        value = _plain(document, ros=generation(distro))
        for error in validator.iter_errors(value):
            path = list(error.absolute_path)
            if not _has_unknown(error.instance):
                found.append(SchemaFault(_place(document, path), _sentence(path, error)))
    return sorted(dict.fromkeys(found), key=lambda fault: (fault.at.start, fault.message))


def types_in(file: YamlFile) -> dict[str, str]:
    """Return the types of the controllers that the controller managers of a file load, by name.

    A name with several types, in several namespaces, is left out.
    """
    types: dict[str, set[str]] = {}
    for manager in (found for document in file.documents for found in _managers(document)):
        for entry in manager.entries:
            name, dot, key = entry.key.text.partition(".")
            kind = entry.value.get("type") if isinstance(entry.value, YamlMap) else None
            kind = entry.value if dot and key == "type" else kind
            if isinstance(kind, Scalar):
                types.setdefault(name, set()).add(kind.text)
    return {name: next(iter(kinds)) for name, kinds in types.items() if len(kinds) == 1}


def faults_in_robot(source: SourceText, schema: str) -> list[SchemaFault]:
    """Return where a robot does not fit an XML Schema.

    Raises UserError if lxml is not installed, or if the file is xacro that has to be expanded first.
    """
    _needs("lxml")
    from lxml import etree

    try:
        document = parse(source, late_declaration=True)
    except ReadError as error:
        return [SchemaFault(error.problem.at, error.problem.message)]
    root = document.documentElement
    if root is None:
        return []
    if any(element.tagName.startswith("xacro:") for element in _elements(root)):
        raise UserError(f"{source.path} is xacro; expand it first: urdfctl expand {source.path} -o robot.urdf")
    skipped = source.data[: len(source.data) - len(source.data.lstrip())].count(b"\n")
    parser = etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=False)
    validator = etree.XMLSchema(etree.fromstring(schema.encode()))
    try:
        tree = etree.fromstring(source.data.strip(), parser)
    except etree.XMLSyntaxError as error:
        return [SchemaFault(root.at, str(error))]
    validator.validate(tree)
    log: Any = validator.error_log
    told = (mistake for mistake in log if _OF_LIBXML2 not in mistake.message)
    found = [SchemaFault(_element_of(root, mistake, skipped).at, mistake.message) for mistake in told]
    return sorted(dict.fromkeys(found), key=lambda fault: (fault.at.start, fault.message))


def _needs(module: str) -> None:
    if importlib.util.find_spec(module) is None:
        raise UserError(f"--check needs {module}: pip install 'urdfctl[schema]'")


# -- YAML --------------------------------------------------------------------------------------------------------------


def _managers(node: Node) -> Iterator[YamlMap]:
    """Yield the parameters of the controller managers in all namespaces."""
    for entry in node.entries if isinstance(node, YamlMap) else ():
        name = entry.key.text.rpartition("/")[2]
        below = entry.value.get("ros__parameters") if isinstance(entry.value, YamlMap) else None
        if name == "controller_manager" and isinstance(below, YamlMap):
            yield below
        elif name != "ros__parameters":
            yield from _managers(entry.value)


def _plain(node: Node, ros: int) -> Any:
    """A value as its ROS generation reads it; None for a value that it cannot read."""
    if isinstance(node, YamlMap):
        return {entry.key.text: _plain(entry.value, ros) for entry in node.entries}
    if isinstance(node, Sequence):
        return [_plain(item, ros) for item in node.items]
    typed = typed_by_rcl(node) if ros == 2 else typed_by_pyyaml(node)  # noqa: PLR2004
    return _UNKNOWN if typed.kind is ValueKind.UNKNOWN else typed.value


def _has_unknown(value: object) -> bool:
    if isinstance(value, Mapping):
        return any(_has_unknown(part) for part in value.values())
    return any(map(_has_unknown, value)) if isinstance(value, list) else value is _UNKNOWN


def _validator(schema: Mapping[str, Any]) -> Any:
    from jsonschema import Draft202012Validator
    from jsonschema.exceptions import ValidationError
    from jsonschema.validators import extend

    def ros_type(_: Any, kinds: list[str], value: object, __: Any) -> Iterator[ValidationError]:
        if not any(_is_of(kind, value) for kind in kinds):
            yield ValidationError(f"{value!r} is not of type {' or '.join(kinds)}; ROS 2 tells 1 from 1.0")

    return extend(Draft202012Validator, {ROS_TYPE: ros_type})(schema)  # type: ignore[no-untyped-call]


def _is_of(kind: str, value: object) -> bool:
    """Return whether a number is one of ROS's type; JSON Schema's own keywords judge all other values."""
    if isinstance(value, list):
        return all(_is_of(kind.removesuffix("_array"), part) for part in value)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return True
    if isinstance(value, float):
        return not (kind.startswith("int") and value.is_integer())
    return not kind.startswith("double")


def _place(node: Node, path: Iterable[Any]) -> Place:
    """The key at a path below a node, or the element of a list."""
    at = node.at
    for step in path:
        if isinstance(node, YamlMap):
            entry = next((each for each in reversed(node.entries) if each.key.text == step), None)
            if entry is None:
                return at
            at, node = (entry.value.at if isinstance(entry.value, Scalar) else entry.key.at), entry.value
        elif isinstance(node, Sequence):
            node = node.items[step]
            at = node.at
    return at


def _sentence(path: list[Any], error: Any) -> str:
    """A message with the name of what it is about."""
    while error.context:
        error = min(error.context, key=lambda each: len(each.absolute_path))
    names = [str(step) for step in path if isinstance(step, str) and step != "ros__parameters"]
    return f"'{'.'.join(names)}': {error.message}" if names else str(error.message)


# -- XML ---------------------------------------------------------------------------------------------------------------


def _elements(root: Element) -> Iterator[Element]:
    yield root
    for child in root.elements():
        yield from _elements(child)


def _element_of(root: Element, mistake: Any, skipped: int) -> Element:
    """The element that lxml reports, by its path `/robot/joint[2]/limit`, or by its name and line."""
    if mistake.path is None:
        name = re.match(r"Element '([^']*)'", mistake.message)
        before = (each for each in _elements(root) if _line_of(each) <= mistake.line + skipped)
        return max((each for each in before if name and each.tagName == name[1]), key=_line_of, default=root)
    element = root
    for step in mistake.path.split("/")[2:]:
        name, _, number = step.partition("[")
        same = [child for child in element.elements() if name in {"*", child.tagName}]
        index = int(number.rstrip("]")) - 1 if number else 0
        if index >= len(same):
            break
        element = same[index]
    return element


def _line_of(element: Element) -> int:
    return element.source.position(element.start).line
