"""The commands of ROS 1 that print a robot description, as commands of ROS 2."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.migrate.launch.actions import (
    PartOfText,
    Text,
    is_literal,
    joined,
    literal,
    parsed,
    plain,
    without_quotes,
    words_of,
)
from urdfctl.source.xml.dom import Element

_XACRO = re.compile(r"(^|/)xacro(\.py)?$")
_STARTERS = ("rosrun", "python", "python2", "python3", "/usr/bin/env", "env")


def description_command(element: Element) -> Text:
    """Return the command of ROS 2 that prints the description of a <param>: the program, a blank, and the rest.

    xacro prints a plain URDF too, and expands what the migration writes into it.
    """
    if "textfile" in element.attrs:
        return (PartOfText("text", "xacro "), *parsed(element.attrs["textfile"]))
    return _command(element.attrs.get("command", ""))


def _is_own_program(text: str) -> bool:
    """Whether a command prints a description by a program that is neither xacro nor cat."""
    words = [plain(without_quotes(word)) for word in words_of(parsed(text))]
    return bool(words and words[0]) and not any(map(_XACRO.search, words)) and not re.search(r"(^|/)cat$", words[0])


def _wrapper_in(text: str) -> str:
    """The program that runs xacro in a command, and changes its output; empty if xacro runs alone."""
    words = [plain(without_quotes(word)) for word in words_of(parsed(text))]
    first = next((index for index, word in enumerate(words) if _XACRO.search(word)), 0)
    return next((word.rpartition("/")[2] for word in words[:first] if word not in _STARTERS), "")


def about_command(command: str) -> Iterator[str]:
    """Yield what a person must see to if a description is not printed by xacro alone."""
    if _is_own_program(command):
        yield f"'{command}' prints the description: port its program to ROS 2, which installs programs in lib/PACKAGE"
    elif wrapper := _wrapper_in(command):
        yield f"the description went through '{wrapper}', and is xacro's own output now: do there what that did"


def command_in(text: str) -> Text:
    """Return the command of ROS 2 for a text that is a command with xacro; empty for another text."""
    return _command(text) if re.match(r"\s*\$\(find xacro\)/xacro(\.py)?\s", text) else ()


def _command(text: str) -> Text:
    words = [without_quotes(word) for word in words_of(parsed(text))]
    if len(words) == 1 and len(words[0]) == 1 and words[0][0].kind == "arg":
        return words[0]  # the argument holds the whole command
    if _is_own_program(text):
        return joined(*(joined(literal(" "), word) if index else word for index, word in enumerate(words)))
    programs = [index for index, word in enumerate(words) if _XACRO.search(plain(word))]
    start = programs[-1] if programs else 0
    shown: list[PartOfText] = [PartOfText("text", "xacro")]
    for word in words[start + 1 :]:
        if is_literal(word) and plain(word) in {"--inorder", "-i"}:
            continue
        shown.append(PartOfText("text", " "))
        shown += _quoted(word)
    return joined(tuple(shown))


def _quoted(word: Text) -> Iterator[PartOfText]:
    """A word of a command; the value of an argument in quotes, because it may be empty or have blanks."""
    name, mark, rest = (word[0].text if word and word[0].kind == "text" else "").partition(":=")
    if mark and (len(word) > 1 or " " in rest):
        yield PartOfText("text", f"{name}:='{rest}")
        yield from word[1:]
        yield PartOfText("text", "'")
    else:
        yield from word
