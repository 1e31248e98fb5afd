"""Keep what lies in the current folder, which may be a stranger's, from being run.

Python finds modules in the current folder if it is started by `python -m`, or if PYTHONPATH has a relative entry;
programs are found there if PATH has one. This module imports only what Python has already imported.
"""

from __future__ import annotations

import os
import sys

_INSTALLED = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
"""The folder that holds the package: its modules are trusted, wherever it is."""


def leave_current_folder() -> None:
    """From now on, find no module and no program in the current folder, or in one that is named relative to it."""
    here = _current_folder()
    relative = [entry for entry in os.environ.get("PYTHONPATH", "").split(os.pathsep) if not os.path.isabs(entry)]
    unwanted = {here, *(os.path.normpath(os.path.join(here, entry)) for entry in relative)} - {_INSTALLED}
    sys.path[:] = [entry for entry in sys.path if os.path.isabs(entry) and entry not in unwanted]
    path = os.environ.get("PATH")
    if path is not None:
        kept = [entry for entry in path.split(os.pathsep) if os.path.isabs(entry)]
        if kept:
            os.environ["PATH"] = os.pathsep.join(kept)
        else:
            del os.environ["PATH"]
    if sys.platform == "win32":  # which looks in the current folder before PATH
        os.environ["NODEFAULTCURRENTDIRECTORYINEXEPATH"] = "1"


def _current_folder() -> str:
    try:
        return os.getcwd()
    except OSError:  # it was removed, and nothing can be found in it
        return os.sep


def python_command(code: str, *words: str) -> list[str]:
    """Return the command that runs some code in a Python with this one's search path, whatever folder it starts in.

    words: what the code finds in sys.argv[1:].
    """
    path = [entry for entry in sys.path if os.path.isabs(entry)]
    mode = ["-X", "utf8"] if sys.flags.utf8_mode else []
    return [sys.executable, "-I", *mode, "-c", f"import sys; sys.path[:] = {path!r}; {code}", *words]


def pip_command() -> list[str]:
    """Return the command that runs pip for this Python, whatever folder it is typed in."""
    # -I would also hide what `pip install --user` installed, perhaps urdfctl itself
    return [sys.executable, "-P" if sys.version_info >= (3, 11) else "-I", "-m", "pip"]
