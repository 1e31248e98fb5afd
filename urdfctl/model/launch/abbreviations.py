"""Options of argparse, which accepts the beginning of a long one: `--shutdown-time` is `--shutdown-timeout`."""

from __future__ import annotations

from collections.abc import Collection


def whole_option(written: str, options: Collection[str]) -> str:
    """Return the option that is written, in full or by its beginning; what is written if it is none, or one of several.

    options: the names of all options of the program.
    """
    if written in options or not written.startswith("--") or written == "--":
        return written
    begun = [option for option in options if option.startswith(written)]
    return begun[0] if len(begun) == 1 else written
