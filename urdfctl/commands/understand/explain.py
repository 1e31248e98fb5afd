"""`urdfctl explain`: explain a rule, a pasted line of a log, or a whole log."""

from __future__ import annotations

import io
import json
import os
import sys
from typing import BinaryIO

from urdfctl.catalog.distros import ALL
from urdfctl.commands.declaring import CHECKED_FOR, OUTPUT, Command, Options, Reads, argument, option
from urdfctl.commands.options import TEXT_OR_JSON
from urdfctl.errors import UserError
from urdfctl.fault import Fault
from urdfctl.names import did_you_mean
from urdfctl.output.links import check_output
from urdfctl.output.printing import print_text
from urdfctl.output.writing import write_file
from urdfctl.source.disk.gate import opened

_DESCRIPTIONS = (".urdf", ".xacro", ".yaml", ".yml", ".launch", ".launch.py", ".sdf", ".world")
_NOTHING = (
    "nothing to explain; pass a rule code, a line of a log in quotes, or a log: urdfctl explain gazebo.log, "
    "or pipe it: ... | urdfctl explain"
)


class ExplainOptions(Options):
    """Explain a rule, an error message, or a whole log: why it is printed, and what to do.

    \b
    Example: urdfctl explain UC201
             urdfctl explain "No p gain specified for pid."
             urdfctl explain gazebo.log --in .
             urdfctl explain --in .
    """

    what: tuple[str, ...] = argument(
        "A rule's code or name, a line of a log in quotes, or a log file (- for standard input).",
        reads=Reads.WORKSPACE_OF_LINE,
    )
    folder: str | None = option(
        CHECKED_FOR,
        "Folder with the robot. Checks which of the causes its files have, and shows these first.",
        "--in",
        metavar="FOLDER",
        reads=Reads.WORKSPACE,
    )
    distro: str | None = option(
        CHECKED_FOR,
        "ROS distro. Default: the one that the log shows, or else with --in, detected from the files.",
        choices=ALL,
        metavar="DISTRO",
    )
    output_format: str = option(
        OUTPUT, "Output format: text or json.", "--format", default="text", choices=TEXT_OR_JSON
    )
    output_file: str | None = option(
        OUTPUT,
        "Write the explanation to this file, not to standard output.",
        "-o",
        "--output-file",
        metavar="FILE",
    )


def run_explain(options: ExplainOptions) -> int:
    """Explain the rule, message or log that the words name. Without words, or for `-`, read standard input.

    The exit status is 1 if nothing of a pasted text is known. Raises UserError if there is nothing to explain, or for a
    single word that is neither a rule nor a file.
    """
    check_output(options.output_file)
    text, is_known = _explained(options)
    if options.output_file is None:
        print_text(text)
    else:
        write_file(options.output_file, text, force=True)
    return 0 if is_known else 1


def explanation(options: ExplainOptions) -> str:
    """Return the explanation of what the words name. Raises UserError if they name nothing."""
    return _explained(options)[0]


def _explained(options: ExplainOptions) -> tuple[str, bool]:
    """The explanation, and whether anything of what was pasted is known."""
    if options.output_format not in TEXT_OR_JSON:
        raise UserError(f"unknown format '{options.output_format}'; known are {', '.join(TEXT_OR_JSON)}")
    text = " ".join(options.what).strip()
    if options.what and not text:
        raise UserError(_NOTHING)
    if options.distro is not None and options.distro not in ALL:
        raise UserError(f"unknown distro '{options.distro}'{did_you_mean(options.distro, ALL)}")
    if not text and options.folder is not None and (sys.stdin is None or sys.stdin.isatty()):
        return _forecast(options.folder, options), True
    if text in {"", "-"}:
        return _explain_log(_standard_input(), options)
    fault = _fault(text)
    if fault is not None:
        return _explain_fault(fault, options), True
    if " " not in text and text.lower().endswith(_DESCRIPTIONS):
        raise UserError(f"explain reads rules, messages and logs; to check '{text}', run: urdfctl lint {text}")
    if os.path.isfile(text):
        return _explain_file(text, options)
    if len(text.split()) == 1:
        raise UserError(_unknown(text))
    return _explain_log(io.BytesIO(text.encode("utf-8", "surrogateescape")), options, pasted=True)


def _forecast(folder: str, options: ExplainOptions) -> str:
    from urdfctl.commands.understand.forecast import forecast

    return forecast(folder, options.distro, options.output_format)


def _fault(text: str) -> Fault | None:
    from urdfctl.rules import all_faults

    if " " in text:
        return None
    return next((fault for fault in all_faults() if text.upper() == fault.code or text.lower() == fault.name), None)


def _unknown(word: str) -> str:
    """The error for a word that is neither a rule nor a file."""
    from urdfctl.rules import all_faults

    if os.sep in word or word.endswith((".log", ".txt")):
        return f"'{word}' is not a regular file" if os.path.exists(word) else f"file '{word}' does not exist"
    if any(fault.code.startswith(word.upper()) for fault in all_faults()):
        return f"unknown rule '{word}'. To list the rules with this prefix, run urdfctl rules --select {word.upper()}"
    known = [name for fault in all_faults() for name in (fault.code, fault.name)]
    return f"unknown rule '{word}'{did_you_mean(word, known) or '.'} To list all rules, run urdfctl rules"


def _explain_fault(fault: Fault, options: ExplainOptions) -> str:
    if options.folder is not None:
        raise UserError(
            f"--in is for messages and logs; to check files, run urdfctl lint {options.folder} --select {fault.code}"
        )
    if options.output_format == "json":
        from urdfctl.commands.understand.rules import plain_fault

        return json.dumps(plain_fault(fault), indent=1) + "\n"
    from urdfctl.report.fault_explanation import fault_explanation

    return fault_explanation(fault)


def _standard_input() -> BinaryIO:
    if sys.stdin is None or sys.stdin.isatty():
        raise UserError(_NOTHING)
    return sys.stdin.buffer


def _explain_file(path: str, options: ExplainOptions) -> tuple[str, bool]:
    try:
        with opened(path) as file:
            return _explain_log(file, options)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None


def _explain_log(stream: BinaryIO, options: ExplainOptions, *, pasted: bool = False) -> tuple[str, bool]:
    from urdfctl.logs.digest import digest
    from urdfctl.logs.reading import Lines

    lines = Lines(stream)
    messages, folder = digest(lines, pasted=pasted, distro=options.distro), None
    if not messages.lines:
        if options.folder is not None and not options.what:
            return _forecast(options.folder, options), True
        raise UserError(_NOTHING)
    if options.folder is not None:
        from urdfctl.commands.understand.explain_files import checked

        messages, folder = checked(messages, options.folder, options.distro)
    is_known = bool(messages.known) or not pasted
    if options.output_format == "json":
        from urdfctl.report.log_explanation.as_json import render_log_json

        return render_log_json(messages, complete=lines.complete, files=folder), is_known
    from urdfctl.report.log_explanation.as_text import render_log

    return render_log(messages, pasted=pasted, complete=lines.complete, files=folder), is_known


command = Command(ExplainOptions, run_explain)
