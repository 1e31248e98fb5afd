"""Find where a wrong name or value is written: where the robot uses it, or in the macro call or property it is from."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

_DEEPEST = 20
_PARAMETER = r"\$\{\s*([A-Za-z_]\w*)\s*\}"
_SUBSTITUTED = r"\$\{[^{}]*\}|\$\([^()]*\)"


class WrittenName(NamedTuple):
    """The place where a wrong name, or the wrong part of it, is written, and the fix that corrects it there, if any."""

    at: Place
    fix: Fix | None = None


def where_written(at: Place, wrong: str, meant: str | None, *, safe: bool = False) -> WrittenName:
    """Return where a name is written that is wrong, with the fix that makes it `meant`.

    at: where the robot uses the name, which may be a parameter of a macro. Then the call is to be edited, not the
    macro: other calls may be right. If only the macro's own text differs from `meant`, the macro is to be edited.
    safe: whether the name is certainly meant.
    """
    passed = _passed(at, wrong, meant, _DEEPEST)
    if passed is not None:
        return passed._replace(fix=passed.fix._replace(safe=safe)) if passed.fix else passed
    text = at.span.text.replace("\r\n", "\n")
    new = _corrected(text, wrong, meant) if meant else None
    return WrittenName(at, Fix(f"write '{new}'", (Edit(at.span, new),), safe)) if new else WrittenName(at)


def at_written(
    used: Place, wrong: str, meant: str | None, message: str, notes: Sequence[Note] = (), *, safe: bool = False
) -> Finding:
    """Return a finding about a wrong name, where it is written; a note says where the robot uses it, if elsewhere.

    The fix has no edits if the name is put together from parts that no single edit corrects.
    safe: as in `where_written`.
    """
    at, fix = where_written(used, wrong, meant, safe=safe)
    if fix is None and meant is not None:
        fix = Fix(f"write '{meant}'")
    here = () if at is used else (Note("used here", used),)
    return Finding(at, message, (*notes, *here), fix)


def at_value(
    project: Project, used: Place, message: str, *, fix: Fix | None = None, severity: Severity | None = None
) -> Finding:
    """Return a finding about a wrong value where it is written: in a property, or in the call of a macro.

    A note says where the robot uses it, if elsewhere.
    """
    at = project.origin(used)
    notes = () if at is used else (Note("used here", used),)
    return Finding(at, message, notes, fix, severity)


def _passed(at: Place, wrong: str, meant: str | None, depth: int) -> WrittenName | None:
    """The place in a macro call of the part that is wrong; None if the part is not passed by a call."""
    if at.call is None or not depth:
        return None
    text = at.span.text
    own = re.sub(_SUBSTITUTED, "", text).strip("_/ ")
    for value in sorted(_values(at, text), key=lambda one: -len(one.span.text)):
        part = value.span.text
        inner = _passed(value, wrong, meant, depth - 1)
        if inner is not None:
            return inner
        if not part.strip() or "$" in part or part not in wrong:
            continue
        new = _between(wrong, part, meant) if meant else None
        if new:
            return WrittenName(value, Fix(f"write '{new}'", (Edit(value.span, new),)))
        if meant is None and not own:
            return WrittenName(value)
    return None


def _values(at: Place, text: str) -> Iterator[Place]:
    """Yield the places in the nearest macro call of the parameters that a text uses."""
    call = next((step for step in at.call.chain() if step.kind == "macro"), None) if at.call else None
    tag = call.source.start_tag(call.offset) if call else None
    if call is None or tag is None:
        return
    for name in re.findall(_PARAMETER, text):
        if name in tag.attributes:
            start, end = tag.attributes[name]
            yield Place(call.source, start, call.parent, end=end)


def _corrected(text: str, wrong: str, meant: str) -> str | None:
    """A text with the wrong part corrected: the whole text, or a part of it that is not substituted."""
    if text == wrong:
        return meant
    for part in (part for part in re.split(_SUBSTITUTED, text) if part.strip()):
        new = _between(wrong, part, meant)
        if new is not None and text.count(part) == 1 and "$" in text:
            return text.replace(part, new)
    return None


def _between(wrong: str, part: str, meant: str) -> str | None:
    """What must replace a part of a wrong name to make it `meant`; None if the rest of the name differs too."""
    before, _, after = wrong.partition(part)
    if len(before) + len(after) > len(meant) or not (meant.startswith(before) and meant.endswith(after)):
        return None
    new = meant[len(before) : len(meant) - len(after)]
    return new if new != part else None
