"""Report as JUnit XML, which every CI system shows: a suite for each file, a test case for each finding.

A finding that makes the run fail is a failed test. Other findings are skipped tests. A robot without findings is a
passed test.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from xml.sax.saxutils import escape, quoteattr

from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.results import Report
from urdfctl.output.printing import visible
from urdfctl.report.common import as_text, relative, shown
from urdfctl.report.concise import place
from urdfctl.report.words import paragraph

_CRASH = "UC000"
_NOT_XML = {0xFFFE: "\ufffd", 0xFFFF: "\ufffd"}


def render(report: Report) -> str:
    """Return the report as a JUnit document. Characters that XML forbids are replaced."""
    return suites_document(report)


def suites_document(report: Report, others: Iterable[str] = (), more: tuple[int, int, int] = (0, 0, 0)) -> str:
    """Return a JUnit document with further suites before those of the findings.

    others: the lines of the further suites.
    more: how many tests, failures and skipped tests they contain.
    """
    return "\n".join(_lines(report, others, more)) + "\n"


def _lines(report: Report, others: Iterable[str], more: tuple[int, int, int]) -> Iterator[str]:
    suites: dict[str, list[Diagnostic]] = {shown(target.path): [] for target in report.targets}
    for diagnostic in map(relative, report.findings):
        suites.setdefault(diagnostic.at.file, []).append(diagnostic)
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    counts = _counts(suites.values(), report)
    for kind, number in zip(("tests", "failures", "skipped"), more, strict=True):
        counts[kind] += number
    yield f"<testsuites{attributes_of(name='urdfctl', **counts)}>"
    yield from others
    for file, findings in suites.items():
        yield from _suite(file, findings, report)
    yield "</testsuites>"


def _suite(file: str, findings: Sequence[Diagnostic], report: Report) -> Iterator[str]:
    yield f"  <testsuite{attributes_of(name=file, **_counts([findings], report))}>"
    for diagnostic in findings:
        at = diagnostic.at
        name = f"{diagnostic.code} {diagnostic.name} at {at.line}:{at.column}"
        yield f"    <testcase{attributes_of(name=name, classname=file, file=file, line=at.line)}>"
        yield f"      {_result(diagnostic, report)}"
        yield "    </testcase>"
    if not findings:
        yield f"    <testcase{attributes_of(name='no findings', classname=file, file=file)}/>"
    yield "  </testsuite>"


def _result(diagnostic: Diagnostic, report: Report) -> str:
    kind = _kind(diagnostic, report)
    if kind == "skipped":
        return f"<skipped{attributes_of(message=f'{diagnostic.severity.value}: {diagnostic.message}')}/>"
    body = "\n".join(_text(line) for line in [place(diagnostic), *paragraph(diagnostic)])
    attributes = attributes_of(message=diagnostic.message, type=diagnostic.severity.value)
    return f"<{kind}{attributes}>{escape(body)}</{kind}>"


def _kind(diagnostic: Diagnostic, report: Report) -> str:
    if diagnostic.code == _CRASH:
        return "error"
    return "failure" if diagnostic.severity.weight >= report.fail_on.weight else "skipped"


def _counts(suites: Collection[Sequence[Diagnostic]], report: Report) -> dict[str, int]:
    kinds = [_kind(diagnostic, report) for findings in suites for diagnostic in findings]
    return {
        "tests": sum(max(len(findings), 1) for findings in suites),
        "failures": kinds.count("failure"),
        "errors": kinds.count("error"),
        "skipped": kinds.count("skipped"),
    }


def attributes_of(**values: str | int) -> str:
    """Return the attributes of an element as XML, each with a space before it."""
    return "".join(f" {name}={quoteattr(_text(str(value)))}" for name, value in values.items())


def _text(text: str) -> str:
    """Return a text that XML can contain."""
    return as_text(visible(text)).translate(_NOT_XML)
