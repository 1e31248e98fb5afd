"""Find the file of a robot description in a ROS 2 launch file: a xacro command, xacro in Python, text, or MoveIt."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from urdfctl.model.launch.ros2.moveit import builder_of
from urdfctl.model.launch.ros2.texts import Content, Texts, table_of
from urdfctl.model.launch.xacro_command import is_of_parameter, known_path, of_command, runs_xacro
from urdfctl.source.launch.terms import Called, Items, Member, OneOf, Term
from urdfctl.source.span import Place

_ARGUMENT = r"(\w+):="
_TEXTS = frozenset({"toxml", "toprettyxml"})
_READING = frozenset({"read", "read_text"})
_RUNNING = frozenset({"subprocess.run", "subprocess.check_output", "subprocess.getoutput", "os.popen"})
_CHANGING = frozenset("replace strip lstrip rstrip encode decode".split())
_REPLACING = frozenset({"sub", "replace"})
_DEEPEST = 30
_MOST_CHOICES = 4


def content_of(term: Term | None, texts: Texts, exists: Callable[[str], bool]) -> Content | None:
    """Return the robot description of a term; None if it is not a known form of a robot description."""
    plain = _unchanged(term)
    content = _content_of(plain, texts, exists)
    return content._replace(edited=content.edited or _is_edited(term, plain)) if content else None


def _content_of(term: Term | None, texts: Texts, exists: Callable[[str], bool]) -> Content | None:  # noqa: PLR0911
    if isinstance(term, (Items, OneOf)):
        several = term.values if isinstance(term, Items) else term.options
        is_one = len(several) == 1 or isinstance(term, OneOf)
        return _of_either([content_of(each, texts, exists) for each in several]) if is_one else None
    if isinstance(term, Member):
        return _of_program(term.of, texts) if term.name == "stdout" else _of_moveit(term, texts, exists)
    if not isinstance(term, Called):
        return None
    if term.name in _RUNNING:
        return _of_program(term, texts)
    if term.short == "ParameterValue":
        value = content_of(term.given("value", 0), texts, exists)
        return value and value._replace(as_yaml=value.as_yaml and term.given("value_type", 1) is None)
    if term.short == "LaunchConfiguration":
        value = texts.scope.contents.get(texts.of(term.given("variable_name", 0)))
        return value and value._replace(as_yaml=True)
    if term.short == "Command":
        return _of_substitution(term, texts)
    if term.short == "FileContent":
        return _of_file(texts.of(term.given("path", 0)), (), term.at)._replace(as_yaml=True)
    if term.name in _TEXTS:
        return _of_process(term.of, texts, term.at)
    if term.name in _READING and isinstance(term.of, Called):
        if term.of.short == "open":
            return _of_file(texts.of(term.of.given("file", 0)), (), term.at)
        return _of_program(term.of, texts)
    return None


def _of_either(contents: Sequence[Content | None]) -> Content | None:
    """One of several descriptions: that of the same file with the same arguments, changed in other ways."""
    first = contents[0]
    known = {(content.path, content.arguments) if content else None for content in contents}
    return first and first._replace(more=first.more or len(contents) > 1) if len(known) == 1 else None


def as_written(content: Content, texts: Texts, exists: Callable[[str], bool]) -> Content:
    """Return the description that the launch file itself writes into the file of another one, if it does."""
    term = texts.sources.written(content.path) if content.path else None
    return content_of(term, texts, exists) or content


def is_of_other_node(term: Term | None, texts: Texts) -> bool:
    """Return whether a term is the robot description that another node has, e.g. by `ros2 param get`."""
    while isinstance(term, Called) and term.short == "ParameterValue":
        term = term.given("value", 0)
    return isinstance(term, Called) and term.short == "Command" and is_of_parameter(texts.of(term.given("command", 0)))


def _unchanged(term: Term | None) -> Term | None:
    """The text that functions such as `re.sub` change only in its form."""
    for _ in range(_DEEPEST):
        inner = _unchanged_once(term)
        if inner is term:
            break
        term = inner
    return term


def _unchanged_once(term: Term | None) -> Term | None:
    if not isinstance(term, Called):
        return term
    if term.name == "re.sub":
        return term.given("string", 2)
    if term.name in _CHANGING and term.of is not None:
        return term.of
    return term.given("value", 0) if term.name in {"str", "Text"} else term


def _is_edited(term: Term | None, plain: Term | None) -> bool:
    """Whether one of the functions around a text puts other words in the place of some."""
    while isinstance(term, Called) and term is not plain:
        if term.short in _REPLACING:
            return True
        term = _unchanged_once(term)
    return False


def _of_substitution(term: Called, texts: Texts) -> Content:
    given = term.given("command", 0)
    choices = [texts.of(_chosen(given, index)) for index in range(_MOST_CHOICES if _is_open(given) else 1)]
    command = choices[0]
    path, arguments = of_command(command)
    every = [of_command(choice)[1] for choice in choices]
    others = dict.fromkeys(other for other in every[1:] if other not in {None, arguments})
    names = tuple(_named(given, texts))
    alternatives = tuple(other for other in others if other)
    more = None in every and arguments is not None  # a loop over values that are not known adds arguments
    return Content(
        path,
        arguments,
        term.at,
        names=names,
        command=command,
        alternatives=alternatives,
        as_yaml=True,
        more=more,
        by_xacro=runs_xacro(command),
    )


def _of_program(term: Term | None, texts: Texts) -> Content | None:
    """The description that a program prints, such as `subprocess.run(["xacro", path])`."""
    if not isinstance(term, Called) or term.name not in _RUNNING:
        return None
    given = term.given("args", 0) or term.given("cmd")
    command = " ".join(map(texts.of, given.values)) if isinstance(given, Items) else texts.of(given)
    path, arguments = of_command(command)
    return Content(path, arguments, term.at, command=command, by_xacro=runs_xacro(command))


def _is_open(term: Term | None) -> bool:
    return isinstance(term, OneOf) or (isinstance(term, Items) and any(map(_is_open, term.values)))


def _chosen(term: Term | None, index: int) -> Term | None:
    """A term with one option of each choice in it."""
    if isinstance(term, OneOf):
        return term.options[min(index, len(term.options) - 1)]
    if isinstance(term, Items):
        return Items([_chosen(value, index) or value for value in term.values], term.at)
    return term


def _named(given: Term | None, texts: Texts, depth: int = 0) -> Iterator[tuple[str, Place]]:
    """The names of the xacro arguments in the parts of a command, each with the place of its part."""
    if isinstance(given, Items) and depth < _DEEPEST:
        for item in given.values:
            yield from _named(item, texts, depth + 1)
    elif given is not None:
        for name in re.findall(_ARGUMENT, texts.of(given)):
            yield name, given.at


def _of_process(term: Term | None, texts: Texts, at: Place) -> Content | None:
    """The description from `xacro.process_file(...)`, or from `xacro.parse(open(...))` and `xacro.process_doc`."""
    if not isinstance(term, Called) or not term.name.startswith("xacro."):
        return None
    file = term.given("input_file_name", 0) or term.given("inp", 0)
    if isinstance(file, Called) and file.short == "open":
        file = file.given("file", 0)
    added = (table_of(argument) for argument in term.added)
    mappings = table_of(term.given("mappings")) or next((table for table in added if table), None)
    values = {name: texts.of(value) for name, value in mappings.entries.items()} if mappings else {}
    whole = mappings is None or mappings.whole
    if term.given("mappings") is not None and mappings is None:
        whole = False
    names = tuple(mappings.keys.items()) if mappings else ()
    return _of_file(texts.of(file), tuple(values.items()) if whole else None, at)._replace(names=names, by_xacro=True)


def _of_file(text: str, arguments: tuple[tuple[str, str], ...] | None, at: Place) -> Content:
    """The description in a file; of one that is not known, what is known of its path is in a command."""
    path = known_path(text)
    return Content(path, arguments, at, command=None if path else f"cat {text}")


def _of_moveit(term: Member, texts: Texts, exists: Callable[[str], bool]) -> Content | None:
    """The description that `MoveItConfigsBuilder` loads."""
    if term.name not in {"robot_description", "[robot_description]"}:
        return None
    builder = builder_of(term.of, texts)
    return builder.description(exists, term.at) if builder else None
