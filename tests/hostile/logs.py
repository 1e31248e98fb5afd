"""Logs that take long to be read, by their size; 20,000 of it is too much for any log."""

from __future__ import annotations

from collections.abc import Callable, Mapping

LITERAL = b"[ERROR] Could not find joint 'Could not find joint '"
LONG_LOGS: Mapping[str, Callable[[int], bytes]] = {
    "one line": lambda size: b"a" * 1500 * size,
    "no letters": lambda size: bytes(range(256)) * 2 * size,
    "escapes": lambda size: b"\x1b[" * 25 * size,
    "beginnings of a message": lambda size: (LITERAL * 100 + b"\n") * (size // 40),
    "errors of all kinds": lambda size: b"".join(
        b"[ERROR] [1]: %x could not hardware joint\n" % (number * number) for number in range(size)
    ),
    "many values": lambda size: b"".join(
        b"No valid hardware interface element found in joint 'j%d'.\n" % number for number in range(size // 2)
    ),
}
