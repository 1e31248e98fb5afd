"""Which file a robot description of ROS 2 is made of: by xacro's command or its Python, as text, or by MoveIt."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator

from urdfctl.model.launch_texts import Content, Texts, table_of
from urdfctl.model.xacro_command import known_path, of_command
from urdfctl.source.launch.terms import Called, Items, Member, OneOf, Term, outside
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_ARGUMENT = r"(\w+):="
_TEXTS = frozenset({"toxml", "toprettyxml"})
_READING = frozenset({"read", "read_text"})
_DEEPEST = 30


def content_of(term: Term | None, texts: Texts, exists: Callable[[str], bool]) -> Content | None:  # noqa: PLR0911
    """The content that a term stands for; None where it is no robot description that is known."""
    if isinstance(term, Items) and len(term.values) == 1:
        return content_of(term.values[0], texts, exists)
    if isinstance(term, Member):
        return _of_moveit(term, texts, exists)
    if not isinstance(term, Called):
        return None
    if term.short == "ParameterValue":
        return content_of(term.given("value", 0), texts, exists)
    if term.short == "LaunchConfiguration":
        return texts.scope.contents.get(texts.of(term.given("variable_name", 0)))
    if term.short == "Command":
        return _of_substitution(term, texts)
    if term.short == "FileContent":
        return Content(known_path(texts.of(term.given("path", 0))), (), term.at)
    if term.name in _TEXTS:
        return _of_process(term.of, texts, term.at)
    if term.name in _READING and isinstance(term.of, Called) and term.of.short == "open":
        return Content(known_path(texts.of(term.of.given("file", 0))), (), term.at)
    return None


def _of_substitution(term: Called, texts: Texts) -> Content:
    given = term.given("command", 0)
    command = texts.of(given)
    path, arguments = of_command(command)
    return Content(path, arguments, term.at, tuple(_named(given, texts)), command)


def _named(given: Term | None, texts: Texts, depth: int = 0) -> Iterator[tuple[str, Place]]:
    """The arguments that the pieces of a command name, each with the place of its piece."""
    if isinstance(given, Items) and depth < _DEEPEST:
        for item in given.values:
            yield from _named(item, texts, depth + 1)
    elif given is not None:
        for name in re.findall(_ARGUMENT, texts.of(given)):
            yield name, given.at


def _of_process(term: Term | None, texts: Texts, at: Place) -> Content | None:
    """What `xacro.process_file(...)`, or `xacro.parse(open(...))` and `xacro.process_doc`, gives."""
    if not isinstance(term, Called) or not term.name.startswith("xacro."):
        return None
    file = term.given("input_file_name", 0) or term.given("inp", 0)
    if isinstance(file, Called) and file.short == "open":
        file = file.given("file", 0)
    mappings = table_of(term.given("mappings")) or next((t for one in term.added if (t := table_of(one))), None)
    values = {name: texts.of(value) for name, value in mappings.entries.items()} if mappings else {}
    whole = (mappings is None or mappings.whole) and not any(UNKNOWN in value for value in values.values())
    if term.given("mappings") is not None and mappings is None:
        whole = False
    names = tuple(mappings.keys.items()) if mappings else ()
    return Content(known_path(texts.of(file)), tuple(values.items()) if whole else None, at, names)


def _of_moveit(term: Member, texts: Texts, exists: Callable[[str], bool]) -> Content | None:
    """What `MoveItConfigsBuilder` takes for the description: a file below its package."""
    if term.name not in {"robot_description", "[robot_description]"}:
        return None
    builder, described = moveit_builder(term.of)
    if builder is None:
        return None
    folder = known_path(moveit_folder(builder, texts))
    if folder is None:
        return Content(None, None, term.at)
    file = texts.of(described.given("file_path", 0)) if described and described.given("file_path", 0) else ""
    name = texts.of(builder.given("robot_name", 0))
    path = os.path.join(folder, file or f"config/{name}.urdf.xacro")
    given = described.given("mappings", 1) if described else None
    mappings = table_of(given)
    values = {key: texts.of(value) for key, value in mappings.entries.items()} if mappings else {}
    whole = given is None or (
        mappings is not None and mappings.whole and not any(UNKNOWN in v for v in values.values())
    )
    known = known_path(path) if file or exists(path) else None
    names = tuple(mappings.keys.items()) if mappings else ()
    return Content(known, tuple(values.items()) if whole else None, term.at, names)


def moveit_builder(term: Term | None) -> tuple[Called | None, Called | None]:
    """The MoveItConfigsBuilder that a chain of calls begins with, and the call that names its robot description."""
    described: Called | None = None
    for _ in range(_DEEPEST):
        if isinstance(term, Called) and term.short == "MoveItConfigsBuilder":
            return term, described
        if isinstance(term, Called) and term.name == "robot_description":
            described = term
        if isinstance(term, OneOf):
            return None, None
        term = term.of if isinstance(term, (Called, Member)) else None
    return None, None


def moveit_folder(builder: Called, texts: Texts) -> str:
    """The folder of the package whose configuration MoveItConfigsBuilder reads; UNKNOWN in it where it is not known."""
    given = builder.given("package_name") or builder.given("robot_name", 0)
    name = texts.of(given)
    if given is None or UNKNOWN in name:
        return UNKNOWN
    package = name if builder.given("package_name") else f"{name}_moveit_config"
    return texts.find(package, given.at) or outside(package)
