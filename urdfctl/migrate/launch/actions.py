"""The actions of a launch file of ROS 2, before they are written in Python or XML."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from urdfctl.startup.records import NamedTuple


class PartOfText(NamedTuple):
    """A part of a text: its kind is `text`, `arg`, `find`, `env`, `dirname`, `eval`, `yaml`, `double`, `command` (what
    one prints), or `written`, an expression that a migration wrote in the form of its launch file.

    A `double` is empty: it stands before the value of a parameter that is a double whatever its substitutions give.

    A `yaml` is a whole value with its type: a number, a quoted string or a list of these, in YAML's flow style.

    default: the default of an environment variable; None if it has none.
    """

    kind: str
    text: str
    default: str | None = None


Text = tuple[PartOfText, ...]
"""A text with substitutions."""


class ActionCondition(NamedTuple):
    """A condition: the text must be true, or must not be."""

    text: Text
    negated: bool


class Action(NamedTuple):
    """An action.

    kind: `argument`, `let`, `include`, `group`, `node`, `process`, `set_parameter`, `set_env`, `set_remap` or
        `comment`.
    name: the name of an argument, parameter or variable, the executable of a node, or the text of a comment.
    value: the default or value; the file of an include; the namespace of a group or node.
    package: of a node.
    pairs: the arguments of an include, the parameters of a node, by name.
    words: the arguments of a node, or the command of a process.
    env: the environment variables of a node.
    """

    kind: str
    name: str = ""
    value: Text | None = None
    package: str = ""
    node_name: Text = ()
    words: tuple[Text, ...] = ()
    pairs: tuple[tuple[str, Text], ...] = ()
    files: tuple[Text, ...] = ()
    description: Text = ()
    remaps: tuple[tuple[Text, Text], ...] = ()
    about: str = ""
    condition: ActionCondition | None = None
    inner: tuple[Action, ...] = ()
    flags: tuple[tuple[str, str], ...] = ()
    env: tuple[tuple[str, Text], ...] = ()


def literal(text: str) -> Text:
    """Return a text without substitutions."""
    return (PartOfText("text", text),) if text else ()


def is_literal(text: Text) -> bool:
    """Return whether a text has no substitutions."""
    return all(part.kind == "text" for part in text)


def plain(text: Text) -> str:
    """Return the literal parts of a text."""
    return "".join(part.text for part in text if part.kind == "text")


def _in_parentheses(levels: int) -> str:
    """Return the pattern of a text in which parentheses close what they open, up to so many levels."""
    pattern = "[^()]*"
    for _ in range(levels):
        pattern = rf"[^()]*(?:\({pattern}\)[^()]*)*"
    return pattern


IN_PARENTHESES = _in_parentheses(4)
_SUBSTITUTION = rf"\$\((arg|find|env|optenv|dirname|anon|eval)\s*({IN_PARENTHESES})\)"


def parsed(text: str) -> Text:
    """Return a text of roslaunch with its substitutions.

    What follows `$(find)` is a path in the package, also without a slash (roslib substitution_args.py: _find).
    """
    parts = divided(" ".join(text.split()), _SUBSTITUTION, _part)
    before = ("", *(part.kind for part in parts))
    return tuple(
        part._replace(text=f"/{part.text}")
        if kind == "find" and part.kind == "text" and part.text[0].isalnum()
        else part
        for kind, part in zip(before, parts, strict=False)
    )


def _part(found: re.Match[str]) -> PartOfText:
    kind, inner = found[1], found[2].strip()
    if kind == "optenv":
        name, _, default = inner.partition(" ")
        return PartOfText("env", name, default.strip())
    return PartOfText("text" if kind == "anon" else kind, inner)


def divided(text: str, substitution: str, part_of: Callable[[re.Match[str]], PartOfText]) -> Text:
    """Return a text in parts: what lies between the matches of a pattern, and what each of these stands for."""
    parts: list[PartOfText] = []
    position = 0
    for found in re.finditer(substitution, text):
        parts += [PartOfText("text", text[position : found.start()]), part_of(found)]
        position = found.end()
    parts.append(PartOfText("text", text[position:]))
    return tuple(part for part in parts if part.text or part.kind != "text")


def joined(*texts: Text) -> Text:
    """Return several texts as one, with neighbouring literal parts as one part."""
    parts: list[PartOfText] = []
    for part in (part for text in texts for part in text):
        if part.kind == "text" and parts and parts[-1].kind == "text":
            parts[-1] = PartOfText("text", parts[-1].text + part.text)
        else:
            parts.append(part)
    return tuple(parts)


_PIECES = re.compile(r"\s+|[^\s'\"]+|['\"]")


def words_of(text: Text) -> tuple[Text, ...]:
    """Return the words of a command line, with their quotes; a substitution never contains a blank.

    A blank between quotes does not end a word. Quotes without their partner are taken as they are.
    """
    is_paired = all(plain(text).count(quote) % 2 == 0 for quote in "'\"")
    words: list[list[PartOfText]] = [[]]
    open_quote = ""
    for part in text:
        if part.kind != "text":
            words[-1].append(part)
            continue
        for piece in _PIECES.findall(part.text):
            if piece.isspace() and not open_quote:
                words.append([])
                continue
            if is_paired and piece in ("'", '"') and open_quote in ("", piece):
                open_quote = "" if open_quote else piece
            last = words[-1][-1] if words[-1] else None
            if last is not None and last.kind == "text":
                words[-1][-1] = PartOfText("text", last.text + piece)
            else:
                words[-1].append(PartOfText("text", piece))
    return tuple(tuple(word) for word in words if word)


def without_quotes(word: Text) -> Text:
    """Return a word of a command line without the quotes in it."""
    found = [part._replace(text=re.sub("['\"]", "", part.text)) if part.kind == "text" else part for part in word]
    return tuple(part for part in found if part.text or part.kind != "text")


def all_actions(actions: tuple[Action, ...]) -> Iterator[Action]:
    """Yield actions and those in groups."""
    for action in actions:
        yield action
        yield from all_actions(action.inner)
