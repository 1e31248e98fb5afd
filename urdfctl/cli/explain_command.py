"""`urdfctl explain`: explain a rule, a pasted line of a log, or a whole log."""

from __future__ import annotations

import io
import json
import os
import sys
from collections.abc import Sequence
from typing import BinaryIO

from urdfctl.cli.writing import print_text, write_file
from urdfctl.errors import UserError
from urdfctl.names import did_you_mean
from urdfctl.rule import Rule
from urdfctl.startup.records import NamedTuple

_FORMATS = ("text", "json")
_DESCRIPTIONS = (".urdf", ".xacro", ".yaml", ".yml", ".launch", ".launch.py", ".sdf", ".world")
_NOTHING = (
    "nothing to explain; pass a rule code, a line of a log in quotes, or a log: urdfctl explain gazebo.log, "
    "or pipe it: ... | urdfctl explain"
)


class CheckIn(NamedTuple):
    """Where to check which causes are really the case. folder: None for nowhere. distro: None to detect it."""

    folder: str | None = None
    distro: str | None = None


def run_explain(words: Sequence[str], output_format: str, files: CheckIn, output_file: str | None = None) -> int:
    """Explain the rule, message or log that the words name. Without words, or for `-`, read standard input.

    files: check which causes the robots in its folder have.
    output_file: where to write the explanation; None for standard output.
    Raises UserError if there is nothing to explain, or for a single word that is neither a rule nor a file.
    """
    explanation = _explained(words, output_format, files)
    if output_file is None:
        print_text(explanation)
    else:
        write_file(output_file, explanation, force=True)
    return 0


def _explained(words: Sequence[str], output_format: str, files: CheckIn) -> str:
    if output_format not in _FORMATS:
        raise UserError(f"unknown format '{output_format}'; known are {', '.join(_FORMATS)}")
    text = " ".join(words).strip()
    if words and not text:
        raise UserError(_NOTHING)
    if files.distro is not None and files.folder is None:
        raise UserError("--distro is for --in FOLDER, which checks the robot's files")
    if text in {"", "-"}:
        return _explain_log(_standard_input(), output_format, files)
    rule = _rule(text)
    if rule is not None:
        return _explain_rule(rule, output_format, files)
    if " " not in text and text.lower().endswith(_DESCRIPTIONS):
        raise UserError(f"explain reads rules, messages and logs; to check '{text}', run: urdfctl lint {text}")
    if os.path.isfile(text):
        return _explain_file(text, output_format, files)
    if len(text.split()) == 1:
        raise UserError(_unknown(text))
    return _explain_log(io.BytesIO(text.encode("utf-8", "surrogateescape")), output_format, files, pasted=True)


def _rule(text: str) -> Rule | None:
    from urdfctl.rules import all_rules

    if " " in text:
        return None
    return next((rule for rule in all_rules() if text.upper() == rule.code or text.lower() == rule.name), None)


def _unknown(word: str) -> str:
    """The error for a word that is neither a rule nor a file."""
    from urdfctl.rules import all_rules

    if os.sep in word or word.endswith((".log", ".txt")):
        return f"'{word}' is not a regular file" if os.path.exists(word) else f"file '{word}' does not exist"
    if any(rule.code.startswith(word.upper()) for rule in all_rules()):
        return f"unknown rule '{word}'. To list the rules with this prefix, run urdfctl rules --select {word.upper()}"
    known = [name for rule in all_rules() for name in (rule.code, rule.name)]
    return f"unknown rule '{word}'{did_you_mean(word, known) or '.'} To list all rules, run urdfctl rules"


def _explain_rule(rule: Rule, output_format: str, files: CheckIn) -> str:
    if files.folder is not None:
        raise UserError(
            f"--in is for messages and logs; to check files, run urdfctl lint {files.folder} --select {rule.code}"
        )
    if output_format == "json":
        from urdfctl.cli.rules_command import plain_rule

        return json.dumps(plain_rule(rule), indent=1) + "\n"
    from urdfctl.report.rule_explanation import rule_explanation

    return rule_explanation(rule)


def _standard_input() -> BinaryIO:
    if sys.stdin is None or sys.stdin.isatty():
        raise UserError(_NOTHING)
    return sys.stdin.buffer


def _explain_file(path: str, output_format: str, files: CheckIn) -> str:
    try:
        with open(path, "rb") as file:
            return _explain_log(file, output_format, files)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None


def _explain_log(stream: BinaryIO, output_format: str, files: CheckIn, *, pasted: bool = False) -> str:
    from urdfctl.logs.digest import digest
    from urdfctl.logs.reading import Lines

    lines = Lines(stream)
    messages, folder = digest(lines, pasted=pasted), None
    if not messages.lines:
        raise UserError(_NOTHING)
    if files.folder is not None:
        from urdfctl.cli.explain_files import checked

        messages, folder = checked(messages, files.folder, files.distro)
    if output_format == "json":
        from urdfctl.report.log_json import render_log_json

        return render_log_json(messages, complete=lines.complete, files=folder)
    from urdfctl.report.log_text import render_log

    return render_log(messages, pasted=pasted, complete=lines.complete, files=folder)
