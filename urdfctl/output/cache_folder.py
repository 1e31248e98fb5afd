"""Where urdfctl keeps what it needs again."""

from __future__ import annotations

import os
import sys


def cache_folder() -> str | None:
    """Return the folder for results; None if the user has none."""
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA")
    elif sys.platform == "darwin":
        base = os.path.join(os.path.expanduser("~"), "Library", "Caches")
    else:
        base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return os.path.join(base, "urdfctl") if base and os.path.isabs(base) else None
