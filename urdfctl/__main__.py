"""`python -m urdfctl`, and the entry point of the command."""

from __future__ import annotations

import gc
import os
import sys


def main() -> None:
    """Run a command, and exit with its status: 2 after a UserError, 3 after a crash."""
    from urdfctl.startup.quick_imports import import_quickly

    import_quickly()
    from urdfctl.errors import UserError

    _open_closed_streams()
    try:
        status = _run(sys.argv[1:])
    except UserError as error:
        from urdfctl.cli.writing import print_message

        print_message(str(error))
        status = 2
    except BrokenPipeError:  # `urdfctl lint | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 1
    except KeyboardInterrupt:
        status = 130
    except Exception:  # noqa: BLE001 (the last place where it can be reported)
        from urdfctl.cli.crash import report_crash

        sys.stderr.write(report_crash())
        status = 3
    _leave(status)


def _open_closed_streams() -> None:
    """Replace closed standard streams by the null device: `urdfctl lint >&-` has no standard output."""
    if sys.stdout is None or sys.stderr is None:
        nowhere = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 (open until the end)
        sys.stdout, sys.stderr = sys.stdout or nowhere, sys.stderr or nowhere


def _leave(status: int) -> None:
    """Exit without tearing down the interpreter, which takes a tenth of a run."""
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    finally:
        os._exit(status)


def _run(words: list[str]) -> int:
    from urdfctl.cli.fast_path import COMMANDS, options_of

    options = options_of(words[0], words[1:]) if words and words[0] in COMMANDS else None
    if options is not None:
        gc.disable()  # the process is short-lived, and its workers have their own memory limit
        if words[0] == "smoke":
            from urdfctl.cli.smoke_command import run_smoke

            return run_smoke(options)
        from urdfctl.cli.lint_command import run_lint

        return run_lint(options)
    if words in (["--version"], ["-V"]):  # a common call in scripts, without the import of typer
        from urdfctl import __version__

        sys.stdout.write(f"urdfctl {__version__}\n")
        return 0
    from urdfctl.cli.app import app

    try:
        app(prog_name="urdfctl")
    except SystemExit as leaving:
        return leaving.code if isinstance(leaving.code, int) else 0
    return 0


if __name__ == "__main__":
    main()
