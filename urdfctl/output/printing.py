"""Print to standard output, and messages to standard error."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from typing import Any

from urdfctl.errors import UserError
from urdfctl.output.writing import encoded

INVISIBLE = (
    *((0x7F, 0x9F), (0xAD, 0xAD), (0x61C, 0x61C), (0x180E, 0x180E), (0x200B, 0x200F), (0x2028, 0x202E)),
    *((0x2060, 0x206F), (0xFEFF, 0xFEFF), (0xFFF9, 0xFFFB), (0xE0000, 0xE007F)),
)
"""Ranges of characters that control the terminal or the direction of a text, or that cannot be seen."""
_CONTROLS = (*range(0x20), *(code for first, last in INVISIBLE for code in range(first, last + 1)))
_ESCAPES = {code: repr(chr(code))[1:-1] for code in _CONTROLS}


def print_text(text: str) -> None:
    """Print a text as UTF-8, whatever the locale. UserError if standard output cannot be written."""
    print_bytes(encoded(text))


def print_bytes(data: bytes) -> None:
    """Print bytes unchanged. UserError if standard output cannot be written."""
    try:
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise UserError(f"standard output cannot be written: {error.strerror}") from None


def is_coloured() -> bool:
    """Return whether to print colours: to a terminal, or if FORCE_COLOR is set; never if NO_COLOR is."""
    return not os.environ.get("NO_COLOR") and (bool(os.environ.get("FORCE_COLOR")) or sys.stdout.isatty())


def is_watched() -> bool:
    """Return whether standard error is a terminal on which a line can be written anew."""
    return sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


def print_message(line: str) -> None:
    """Print a line to standard error after the program's name, with control characters escaped."""
    sys.stderr.write(f"urdfctl: {visible(line)}\n")


def print_messages(lines: Iterable[str]) -> None:
    """Print lines to standard error, each as `print_message` does."""
    for line in lines:
        print_message(line)


def visible(text: str) -> str:
    """Return a text with its control characters escaped: a file must not control the terminal or turn the direction of
    a text, and a finding must stay on one line."""
    return text.translate(_ESCAPES) if not text.isprintable() else text


def visible_in(value: Any) -> Any:
    """Return plain data with the control characters in its texts escaped, also in the names of its objects."""
    if isinstance(value, str):
        return visible(value)
    if isinstance(value, dict):
        return {visible_in(name): visible_in(inner) for name, inner in value.items()}
    if isinstance(value, list | tuple):
        return [visible_in(inner) for inner in value]
    return value
