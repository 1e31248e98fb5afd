"""CommandAnswer as text or as JSON, for the commands that write files or print a text."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.commands.declaring import OUTPUT, Options, option
from urdfctl.commands.options import TEXT_OR_JSON
from urdfctl.commands.words import output_of
from urdfctl.errors import UserError
from urdfctl.output.answer import CommandAnswer
from urdfctl.output.printing import print_text
from urdfctl.output.writing import write_file
from urdfctl.report.common import as_json


class AnswerOptions(Options):
    """The option of every command that does something and says what it did."""

    output_format: str = option(
        OUTPUT,
        "What to print: text, or json: all that is said and done in one object. json=FILE writes a file.",
        "--format",
        default="text",
        choices=TEXT_OR_JSON,
    )


def answered(command: str, options: AnswerOptions, run: Callable[[CommandAnswer], int]) -> int:
    """Run a command, give its answer in the format that is asked for, and return the exit status."""
    output, file = output_of(options.output_format, TEXT_OR_JSON)
    if output == "text" and file is not None:
        raise UserError("--format text is printed; json=FILE writes a file")
    answer = CommandAnswer(is_kept=output == "json")
    status = run(answer)
    if answer.is_kept:
        text = as_json(answer.document(command, status), 1) + "\n"
        if file is None:
            print_text(text)
        else:
            write_file(file, text, force=True)
    return status
