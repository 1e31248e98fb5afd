"""Quick fixes: what a finding's fix does, to ignore the finding here with a reason, and to have its rule explained."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from lsprotocol import types

from urdfctl.diagnostic import Diagnostic, ShownEdit
from urdfctl.server.protocol.diagnostics import shown_diagnostic
from urdfctl.server.protocol.positions import Positions
from urdfctl.server.protocol.uris import uri_of

EXPLAIN = "urdfctl.explain"
"""The command that explains a rule. Its argument is a code."""
FIX_ALL = types.CodeActionKind.SourceFixAll
_XML = (".urdf", ".xacro", ".launch", ".xml", ".sdf", ".srdf")


def actions_at(
    findings: Sequence[Diagnostic], asked: types.Range, positions: Positions, wanted: Sequence[str] = ()
) -> list[types.CodeAction]:
    """Return what can be done about the findings of a file in a range: first the fixes, the safe ones before others.

    wanted: the kinds that the editor asks for; all if empty.
    """
    here = [finding for finding in findings if _touches(positions.range_of(finding.at), asked)]
    fixes = sorted(_fixes(here, positions), key=lambda action: not action.is_preferred)
    others = [*_ignoring(here, positions), *_explaining(here)]
    of_file = [*_fix_all(findings, positions)]
    return [action for action in (*fixes, *of_file, *others) if _is_wanted(action, wanted)]


def _is_wanted(action: types.CodeAction, wanted: Sequence[str]) -> bool:
    kind = str(getattr(action.kind, "value", action.kind))
    return not wanted or any(kind == one or kind.startswith(f"{one}.") for one in wanted)


def _touches(one: types.Range, other: types.Range) -> bool:
    def pair(at: types.Position) -> tuple[int, int]:
        return at.line, at.character

    return pair(one.start) <= pair(other.end) and pair(other.start) <= pair(one.end)


def _fixes(findings: Iterable[Diagnostic], positions: Positions) -> Iterator[types.CodeAction]:
    for finding in findings:
        if finding.fix and finding.fix.edits:
            yield types.CodeAction(
                title=f"{finding.code}: {finding.fix.title}",
                kind=types.CodeActionKind.QuickFix,
                diagnostics=[shown_diagnostic(finding, positions)],
                is_preferred=finding.fix.safe,
                edit=edit_of(finding.fix.edits, positions),
            )


def _fix_all(findings: Sequence[Diagnostic], positions: Positions) -> Iterator[types.CodeAction]:
    """All safe fixes of a file. One that overlaps an earlier one is left for the next time."""
    safe = [finding.fix for finding in findings if finding.fix and finding.fix.safe and finding.fix.edits]
    kept: list[ShownEdit] = []
    for fix in safe:
        if not any(_overlaps(edit, other) for edit in fix.edits for other in kept):
            kept += (edit for edit in fix.edits if edit not in kept)
    if kept:
        count = len(safe)
        title = f"urdfctl: apply {count} safe fix{'' if count == 1 else 'es'} of this file"
        yield types.CodeAction(title=title, kind=FIX_ALL, edit=edit_of(kept, positions))


def _overlaps(edit: ShownEdit, other: ShownEdit) -> bool:
    if edit == other or edit.file != other.file:
        return False
    return edit.start < other.end and other.start < edit.end


def edit_of(edits: Iterable[ShownEdit], positions: Positions) -> types.WorkspaceEdit:
    """Return edits of files as an editor makes them."""
    changes: dict[str, list[types.TextEdit]] = {}
    for edit in edits:
        changes.setdefault(uri_of(edit.file), []).append(types.TextEdit(positions.range_of(edit.at), edit.text))
    return types.WorkspaceEdit(changes=changes)


def _ignoring(findings: Iterable[Diagnostic], positions: Positions) -> Iterator[types.CodeAction]:
    """A comment on the line before a finding; where it may stand, for inside of a tag it must not."""
    codes: dict[tuple[str, int], list[Diagnostic]] = {}
    for finding in findings:
        codes.setdefault((finding.at.file, finding.at.line), []).append(finding)
    for (file, line), found in codes.items():
        lines = positions.lines(file)
        text = lines[line - 1] if line <= len(lines) else ""
        if not text.strip() or (_is_xml(file) and not text.lstrip().startswith("<")):
            continue
        indent = text[: len(text) - len(text.lstrip())]
        named = ", ".join(dict.fromkeys(finding.code for finding in found))
        words = f"urdfctl: ignore[{named}] reason"
        comment = f"<!-- {words} -->" if _is_xml(file) else f"# {words}"
        start = types.Position(line - 1, 0)
        edit = types.TextEdit(types.Range(start, start), f"{indent}{comment}\n")
        yield types.CodeAction(
            title=f"Ignore {named} here, with a reason",
            kind=types.CodeActionKind.QuickFix,
            diagnostics=[shown_diagnostic(finding, positions) for finding in found],
            edit=types.WorkspaceEdit(changes={uri_of(file): [edit]}),
        )


def _is_xml(file: str) -> bool:
    return os.path.basename(file).endswith(_XML)


def _explaining(findings: Iterable[Diagnostic]) -> Iterator[types.CodeAction]:
    for code in dict.fromkeys(finding.code for finding in findings):
        title = f"Explain {code}"
        command = types.Command(title=title, command=EXPLAIN, arguments=[code])
        yield types.CodeAction(title=title, kind=types.CodeActionKind.QuickFix, command=command)
