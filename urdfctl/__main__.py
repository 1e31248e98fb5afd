"""`python -m urdfctl`, and the entry point of the command."""

from __future__ import annotations

import gc
import os
import sys


def main() -> None:
    """Run a command, and turn what it raises into its exit status: 2 for the user's errors, 3 for ours."""
    from urdfctl.errors import UserError

    _open_what_is_closed()
    try:
        status = _run(sys.argv[1:])
    except UserError as error:
        from urdfctl.cli.writing import tell

        tell(str(error))
        status = 2
    except BrokenPipeError:  # `urdfctl lint | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 1
    except KeyboardInterrupt:
        status = 130
    except Exception:  # noqa: BLE001 (the last place where it can be told)
        from urdfctl.cli.crash import report_crash

        sys.stderr.write(report_crash())
        status = 3
    _leave(status)


def _open_what_is_closed() -> None:
    """`urdfctl lint >&-` has no standard output; what is said then is said to nobody."""
    if sys.stdout is None or sys.stderr is None:
        nowhere = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 (open until the end)
        sys.stdout, sys.stderr = sys.stdout or nowhere, sys.stderr or nowhere


def _leave(status: int) -> None:
    """Leave without taking the interpreter to pieces: that alone would cost a tenth of a run."""
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    finally:
        os._exit(status)


def _run(words: list[str]) -> int:
    if words[:1] == ["lint"]:
        from urdfctl.cli.lint_words import plain_options

        options = plain_options(words[1:])
        if options is not None:
            gc.disable()  # the process lives for a moment, and its workers have a limit of their own
            from urdfctl.cli.lint_command import lint_words

            return lint_words(**options)
    if words == ["--version"]:  # what scripts ask before anything else
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
