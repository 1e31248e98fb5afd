"""`urdfctl rules`."""

from __future__ import annotations

import json

from urdfctl.commands.declaring import OUTPUT, RULES, Command, Options, option
from urdfctl.commands.options import TEXT_OR_JSON
from urdfctl.commands.words import codes
from urdfctl.errors import UserError
from urdfctl.fault import Fault
from urdfctl.lint.selection import Selection, validate_selection
from urdfctl.logs.printed import printed_because_of
from urdfctl.output.printing import print_text
from urdfctl.rules import all_faults, origin_of


class RulesOptions(Options):
    """List the rules, also those of packages that are installed beside urdfctl.

    \b
    Example: urdfctl rules --select UC2
    """

    output_format: str = option(
        OUTPUT, "Output format: text or json.", "--format", default="text", choices=TEXT_OR_JSON
    )
    select: tuple[str, ...] = option(RULES, "Select rules by code or prefix, e.g. UC2,UC401.", metavar="CODE,...")


def run_rules(options: RulesOptions) -> int:
    """List the rules as a table or as JSON."""
    selection = validate_selection(Selection(codes(options.select)))
    wanted = [fault for fault in all_faults() if selection.admits(fault.code)]
    if options.output_format == "json":
        print_text(json.dumps([plain_fault(fault) for fault in wanted], indent=1) + "\n")
    elif options.output_format == "text":
        print_text("".join(f"{row(fault)}\n" for fault in wanted))
    else:
        raise UserError(f"unknown format '{options.output_format}'; known are text, json")
    return 0


def row(fault: Fault) -> str:
    """Return the line of a fault in the table. Where a package brings it, its name and version come last."""
    origin = origin_of(fault.code)
    brought = "" if origin == "urdfctl" else f" (from {origin})"
    return f"{fault.code}  {fault.severity.value:<8} {fault.name:<44} {fault.summary}{brought}"


def plain_fault(fault: Fault) -> dict[str, object]:
    """Return a fault as plain data, for JSON."""
    return {
        "code": fault.code,
        "name": fault.name,
        "severity": fault.severity.value,
        "summary": fault.summary,
        "why": fault.why,
        "runtime": fault.runtime.value,
        "because": fault.because,
        "authority": fault.authority,
        "distros": list(fault.distros),
        "origin": origin_of(fault.code),
        "prints": [message.text for message in printed_because_of(fault.code)],
    }


command = Command(RulesOptions, run_rules)
