"""The report of a crash of urdfctl, ready to paste into an issue."""

from __future__ import annotations

import platform
import sys
import traceback

from urdfctl import __version__


def report_crash() -> str:
    """Return the exception that is being handled, with the versions and the command."""
    return (
        "urdfctl: this is a bug in urdfctl, not an error in your robot. Please report it with these lines:\n\n"
        f"urdfctl {__version__}, Python {platform.python_version()}, {platform.platform()}\n"
        f"command: {' '.join(sys.argv)}\n"
        f"{traceback.format_exc()}"
    )
