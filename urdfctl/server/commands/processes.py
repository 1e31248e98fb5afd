"""Commands of urdfctl in processes of their own: for what takes long, and may need much memory."""

from __future__ import annotations

import asyncio
import os
import shlex
import signal
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress

from urdfctl.startup.isolation import pip_command, python_command
from urdfctl.startup.records import NamedTuple

_START = "from urdfctl.__main__ import main; main()"
_MOST_LINE = 1 << 20
_PATIENCE = 5.0
"""Seconds for a command to end by itself after it was interrupted."""


class Ended(NamedTuple):
    """What a command printed, and its exit status. problems: the lines on its standard error."""

    status: int
    output: bytes
    problems: tuple[str, ...]

    @property
    def reason(self) -> str:
        """Return why the command failed, in its own words."""
        return self.problems[-1].removeprefix("urdfctl: ") if self.problems else f"exit status {self.status}"


def pip_install(extra: str) -> str:
    """Return the command that installs an extra of urdfctl where the server runs."""
    return shlex.join([*pip_command(), "install", f"urdfctl[{extra}]"])


async def run_command(
    words: Sequence[str], folder: str, on_line: Callable[[str], None], cancelled: asyncio.Event
) -> Ended:
    """Run a command of urdfctl in a folder until it ends, or until it is cancelled; then it is interrupted.

    on_line: called with each line on standard error.
    """
    process = await asyncio.create_subprocess_exec(
        *python_command(_START, *words),
        cwd=folder,
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        limit=_MOST_LINE,
        env={**os.environ, "NO_COLOR": "1"},
        start_new_session=True,  # its workers end with it
    )
    stdout, stderr = process.stdout, process.stderr
    if stdout is None or stderr is None:
        raise AssertionError("both are pipes")
    problems: list[str] = []

    async def follow() -> None:
        async for line in stderr:
            problems.append(line.decode("utf-8", "replace").rstrip())
            on_line(problems[-1])

    watching = asyncio.create_task(_end_when(cancelled, process))
    try:
        output, _ = await asyncio.gather(stdout.read(), follow())
        status = await process.wait()
    finally:
        watching.cancel()
        _kill(process)
        await process.wait()
    return Ended(status, output, tuple(problems))


async def _end_when(cancelled: asyncio.Event, process: asyncio.subprocess.Process) -> None:
    await cancelled.wait()
    with suppress(ProcessLookupError):
        if sys.platform == "win32":
            process.terminate()
        else:
            process.send_signal(signal.SIGINT)
    await asyncio.sleep(_PATIENCE)
    _kill(process)


def _kill(process: asyncio.subprocess.Process) -> None:
    """End a process that has not ended by itself, with its workers."""
    if process.returncode is not None:
        return
    with suppress(ProcessLookupError):  # it ends meanwhile
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)
