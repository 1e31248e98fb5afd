"""Run the collector with the Python in which ROS is sourced, and read what it recorded."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from typing import Any

from urdfctl.errors import UserError

_FOLDER = os.path.dirname(os.path.abspath(__file__))
_COLLECTORS = {"2": "collector.py", "1": "collector_ros1.py"}
"""The collectors by the value of ROS_VERSION that a sourced ROS sets."""
_LONGEST = 20.0
"""Seconds, besides those of listening, after which a collector is ended."""
_LONGEST_START, _LONGEST_CONTROLLER = 60.0, 40.0
"""Seconds after which a manager is ended, without its controllers and for each of them."""
_NO_ROS = 2
"""The exit status of a collector where its ROS is not sourced."""
_SILENT = 3
"""The exit status of a collector if no master answers."""
_INSTEAD = "source ROS, or name a recording: urdfctl doctor SNAPSHOT.json"


class SystemSilent(UserError):
    """ROS is sourced, but no system answers; one may be started later."""


def collected(seconds: float, *, is_private: bool) -> str:
    """Return the recording of the system that runs here, as JSON.

    seconds: for how long topics are listened to. is_private: whether private values are recorded too.
    Raises UserError if ROS is not sourced, or if the system cannot be asked.
    """
    version = os.environ.get("ROS_VERSION", "")
    python = _python()
    for name in [_COLLECTORS[version]] if version in _COLLECTORS else _COLLECTORS.values():
        words = [python, os.path.join(_FOLDER, name), "--seconds", f"{seconds:g}", *(["--all"] if is_private else [])]
        ran = _run(words, _LONGEST + seconds)
        if ran.returncode == 0:
            return ran.stdout
        last = (ran.stderr.strip().splitlines() or ["it said nothing"])[-1]
        if ran.returncode == _SILENT:
            raise SystemSilent(last)
        if ran.returncode != _NO_ROS:
            raise UserError(f"the running system cannot be recorded: {last}")
    if version in _COLLECTORS:
        raise UserError(f"{last}; {_INSTEAD}")
    raise UserError(f"neither ROS 2 nor ROS 1 is sourced for '{python}'; {_INSTEAD}")


def run_mock_manager(plan: dict[str, Any]) -> dict[str, Any]:
    """Return how far a plan comes with the real controller manager. Raises UserError if ROS 2 is not sourced."""
    longest = _LONGEST_START + _LONGEST_CONTROLLER * len(plan["controllers"])
    ran = _run([_python(), os.path.join(_FOLDER, "mock_manager.py")], longest, json.dumps(plan))
    last = (ran.stderr.strip().splitlines() or ["it said nothing"])[-1]
    if ran.returncode == _NO_ROS:
        raise UserError(f"--engine ros2 starts the real controller manager: {last}; source ROS 2, or use --engine none")
    if ran.returncode != 0:
        raise UserError(f"the controller manager cannot be started: {last}")
    found: dict[str, Any] = json.loads(ran.stdout)
    return found


def _run(words: list[str], longest: float, text: str = "") -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(  # noqa: S603 (our own script, with the Python of the environment)
            words, input=text, capture_output=True, text=True, check=False, timeout=longest
        )
    except subprocess.TimeoutExpired:
        raise UserError(f"the running system did not answer in {longest:g} s") from None
    except OSError as error:
        raise UserError(f"'{words[0]}' cannot be run: {error.strerror}") from None


def _python() -> str:
    """The Python of the environment that is sourced, whatever Python urdfctl has; none of the current folder."""
    found = shutil.which("python3")
    if found is None or os.path.dirname(os.path.abspath(found)) == os.getcwd():
        raise UserError(f"no python3 on PATH: {_INSTEAD}")
    return os.path.abspath(found)
