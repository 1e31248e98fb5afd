"""Whether the process that made a file still runs."""

from __future__ import annotations

import os
import sys

_ENDED = (b"Z", b"X")
"""States of Linux: the process has ended, and its parent has not yet asked how."""


def start_of(process: int) -> int | None:
    """Return when a process started, in ticks of the system's clock; 0 if that is not told; None if it has ended."""
    if sys.platform == "linux" and _proc_is_ours():
        try:
            with open(f"/proc/{process}/stat", "rb") as file:
                state, *numbers = file.read().rpartition(b")")[2].split()  # the name before may hold anything
            return None if state in _ENDED else int(numbers[18])
        except OSError:
            pass
    return 0 if _exists(process) else None


def is_running(process: int, start: int) -> bool:
    """Return whether a process runs that started at `start`; any with its number where the system tells no start."""
    now = start_of(process)
    return now is not None and (now == start or 0 in (now, start))


def _proc_is_ours() -> bool:
    """Return whether /proc names processes by the same numbers as this process does: a container may see another's."""
    try:
        return os.readlink("/proc/self") == str(os.getpid())
    except OSError:
        return False


def _exists(process: int) -> bool:
    if sys.platform in ("emscripten", "wasi"):  # where there is no other process
        return process == os.getpid()
    if sys.platform == "win32":
        import ctypes

        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        handle = kernel.OpenProcess(0x1000, False, process)  # noqa: FBT003 (PROCESS_QUERY_LIMITED_INFORMATION)
        if not handle:
            return ctypes.get_last_error() == 5  # noqa: PLR2004 (access denied: it is another user's)
        status = ctypes.c_ulong()
        is_known = kernel.GetExitCodeProcess(handle, ctypes.byref(status))
        kernel.CloseHandle(handle)
        return not is_known or status.value == 259  # noqa: PLR2004 (STILL_ACTIVE)
    try:
        os.kill(process, 0)
    except PermissionError:
        return True
    except (ProcessLookupError, OverflowError):
        return False
    return True
