"""`python -m urdfctl`, and the entry point of the command."""

from __future__ import annotations

import gc
import os
import sys


def main() -> None:
    """Run a command, and exit with its status: 2 after a UserError, 3 after a crash."""
    gc.disable()  # nothing that an import makes is garbage; a command that takes long enables it again
    from urdfctl.startup.isolation import leave_current_folder

    leave_current_folder()
    from urdfctl.startup.quick_imports import import_quickly

    import_quickly()
    from urdfctl.errors import UserError

    open_closed_streams()
    try:
        status = run(sys.argv[1:])
    except UserError as error:
        status = _refused(str(error))
    except BrokenPipeError:  # `urdfctl lint | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 1
    except KeyboardInterrupt:
        status = 130
    except RecursionError:
        status = _refused("something in these files is nested too deeply to be read")
    except Exception:  # noqa: BLE001 (the last place where it can be reported)
        from urdfctl.commands.crash import report_crash

        sys.stderr.write(report_crash())
        status = 3
    leave(status)


def _refused(why: str) -> int:
    """Print why nothing is done, and return the exit status."""
    from urdfctl.output.printing import print_message

    print_message(why)
    return 2


def open_closed_streams() -> None:
    """Replace closed standard streams by the null device: `urdfctl lint >&-` has no standard output."""
    if sys.stdout is None or sys.stderr is None:
        nowhere = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 (open until the end)
        sys.stdout, sys.stderr = sys.stdout or nowhere, sys.stderr or nowhere


def leave(status: int) -> None:
    """Exit without tearing down the interpreter, which takes a tenth of a run."""
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    finally:
        os._exit(status)


def run(words: list[str]) -> int:
    """Run a command line, given without the program's name, and return the exit status."""
    if words in (["--version"], ["-V"]):  # a common call in scripts, without the import of typer
        from urdfctl import __version__

        sys.stdout.write(f"urdfctl {__version__}\n")
        return 0
    from urdfctl.commands.running import run_words

    return run_words(words)


if __name__ == "__main__":
    main()
