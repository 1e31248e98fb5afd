"""What is told when urdfctl itself is at fault: a report ready to paste."""

from __future__ import annotations

import platform
import sys
import traceback

from urdfctl import __version__


def report_crash() -> str:
    """The exception being handled, with what is needed to understand it."""
    return (
        "urdfctl: this is a fault of urdfctl, not of your robot. Please report it with these lines:\n\n"
        f"urdfctl {__version__}, Python {platform.python_version()}, {platform.platform()}\n"
        f"command: {' '.join(sys.argv)}\n"
        f"{traceback.format_exc()}"
    )
