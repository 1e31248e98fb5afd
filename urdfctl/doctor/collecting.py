"""Run the collector with the Python in which ROS is sourced, and read what it recorded."""

from __future__ import annotations

import os
import shutil
import subprocess

from urdfctl.errors import UserError

_COLLECTOR = os.path.join(os.path.dirname(os.path.abspath(__file__)), "collector.py")
_LONGEST = 60.0
"""Seconds after which the collector is ended."""
_NO_ROS = 2
"""The exit status of the collector where ROS is not sourced."""


def collected(seconds: float, *, is_private: bool) -> str:
    """Return the recording of the system that runs here, as JSON.

    seconds: for how long topics are listened to. is_private: whether private values are recorded too.
    Raises UserError if ROS is not sourced, or if the system cannot be asked.
    """
    words = [_python(), _COLLECTOR, "--seconds", f"{seconds:g}", *(["--all"] if is_private else [])]
    try:
        ran = subprocess.run(  # noqa: S603 (our own script, with the Python of the environment)
            words, capture_output=True, text=True, check=False, timeout=_LONGEST + seconds
        )
    except subprocess.TimeoutExpired:
        raise UserError(f"the running system did not answer in {_LONGEST + seconds:g} s") from None
    except OSError as error:
        raise UserError(f"'{words[0]}' cannot be run: {error.strerror}") from None
    last = (ran.stderr.strip().splitlines() or ["it said nothing"])[-1]
    if ran.returncode == _NO_ROS:
        raise UserError(f"{last}; source ROS, or name a recording: urdfctl doctor SNAPSHOT.json")
    if ran.returncode != 0:
        raise UserError(f"the running system cannot be recorded: {last}")
    return ran.stdout


def _python() -> str:
    """The Python of the environment that is sourced, whatever Python urdfctl has; none of the current folder."""
    found = shutil.which("python3")
    if found is None or os.path.dirname(os.path.abspath(found)) == os.getcwd():
        raise UserError("no python3 on PATH: source ROS, or name a recording: urdfctl doctor SNAPSHOT.json")
    return os.path.abspath(found)
