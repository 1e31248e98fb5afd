"""The exit statuses of each command, for the pages of docs/commands and the manual page."""

from __future__ import annotations

from collections.abc import Iterator

_DONE = "Done."
_WRONG = "The command line is wrong, a file cannot be read or written, or there is nothing to do."
_BUG = "A bug in urdfctl. Please report it."
_FOUND = "Findings of the severity of `--fail-on` (default: error) or worse."
_OUT_OF_DATE = "With `--check` or `--diff`: a file is out of date."

_OWN: dict[str, dict[int, str]] = {
    "lint": {0: "No finding of that severity.", 1: f"{_FOUND} With `--diff`: there are fixes."},
    "smoke": {
        0: "No finding of that severity.",
        1: _FOUND,
        5: "No controller was tested; `--allow-empty` makes it 0.",
        130: "Interrupted by Ctrl-C. What was tested until then is reported.",
    },
    "check": {
        0: "No finding of that severity. A robot without controllers is only linted.",
        1: _FOUND,
        130: "Interrupted by Ctrl-C. What was tested until then is reported.",
    },
    "doctor": {0: "Nothing is wrong.", 1: "Something is wrong in the running system."},
    "diff": {1: "With `--fail-on`: one of these areas has a change."},
    "explain": {0: "Explained.", 1: "Nothing of the pasted text is known."},
    "expand": {1: "The file cannot be expanded."},
    "gen-all": {1: f"The package would not start, and was not written. {_OUT_OF_DATE}"},
    "gen-moveit": {1: f"The package would not start, and was not written. {_OUT_OF_DATE}"},
    "gen-check": {0: "All files are up to date.", 1: "A file is out of date."},
    "migrate": {1: "There are changes, which are shown, not written. With `--fail-on left`: something is left to you."},
    "schema": {1: "With `--check`: a file does not fit."},
}
_GENERATORS = ("gen-controllers", "gen-transmissions", "gen-ros2-control", "gen-gazebo", "gen-launch", "convert")


def exits_of(command: str) -> Iterator[tuple[int, str]]:
    """Yield the exit statuses of a command in their order, each with its meaning."""
    own = {1: _OUT_OF_DATE} if command in _GENERATORS else _OWN.get(command, {})
    yield from sorted({0: _DONE, 2: _WRONG, 3: _BUG, **own}.items())
