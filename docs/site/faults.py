"""Pages of the rules: what is wrong, why, what the runtime prints, wrong and right files, authority, distros, fix."""

from __future__ import annotations

import re
from collections.abc import Iterator

from texts import Pages, front_matter, how_to_try, one_line, quoted

from urdfctl import REPOSITORY
from urdfctl.catalog.distros import in_words
from urdfctl.fault import Example, Fault
from urdfctl.logs.printed import printed_because_of
from urdfctl.report.fault_explanation import output_of_lint, runtime_of
from urdfctl.rules import all_faults, command_of
from urdfctl.rules.prose import as_markdown

_LANGUAGES = {
    "xacro": "xml",
    "urdf": "xml",
    "launch": "xml",
    "xml": "xml",
    "srdf": "xml",
    "yaml": "yaml",
    "py": "python",
}


def fault_pages() -> Pages:
    """Return a page for each rule, by path."""
    return {f"rules/{fault.code}.md": page_of(fault) for fault in all_faults()}


def page_of(fault: Fault) -> str:
    """Return the page of a fault as Markdown."""
    return "\n".join(_parts(fault))


def _parts(fault: Fault) -> Iterator[str]:
    words = fault.name.replace("-", " ")
    yield front_matter(f"{fault.code}: {words}", one_line(fault.summary))
    yield f"# {fault.code} {fault.name}\n"
    yield f"**{as_markdown(fault.summary)}**\n"
    yield f"| severity | distros | found by |\n|---|---|---|\n| {_facts(fault)} |\n"
    yield f"{as_markdown(fault.why)}\n" if fault.why else ""
    yield f"{as_markdown(runtime_of(fault))}\n"
    yield from _printed(fault)
    if fault.bad:
        yield "## Wrong\n"
        yield from _files(fault.bad[0])
        yield from _output(fault)
        yield "## Right\n"
        yield from _files(fault.good[0])
    yield how_to_try(f"rules/{fault.code}.md")
    yield f"## Authority\n\n{as_markdown(fault.authority)}\n"
    yield "## Ignore it in one place\n"
    yield f"```xml\n<!-- urdfctl: ignore[{fault.code}] the reason -->\n```\n"
    path = fault.module.replace(".", "/")
    yield f"[The rule's source and all its examples]({REPOSITORY}/blob/main/{path}.py)"


def _facts(fault: Fault) -> str:
    found = f"[`urdfctl {command_of(fault.code)}`](../commands/{command_of(fault.code)}.md)"
    return f"{fault.severity.value} | {in_words(fault.distros)} | {found}"


def _printed(fault: Fault) -> Iterator[str]:
    messages = printed_because_of(fault.code)
    if messages:
        yield "## What is printed because of it\n"
        yield from (f"- [{quoted(one.text)}](../messages/{one.id}.md), by {as_markdown(one.by)}" for one in messages)
        yield ""


def _output(fault: Fault) -> Iterator[str]:
    if command_of(fault.code) == "lint":
        yield f"`urdfctl lint` says:\n\n```text\n{output_of_lint(fault).rstrip()}\n```\n"


def _files(example: Example) -> Iterator[str]:
    for name, text in example.files.items():
        language = _LANGUAGES.get(name.rpartition(".")[2], "text")
        plain = re.sub("[«»]", "", text).rstrip()
        yield f'```{language} title="{name}"\n{plain}\n```\n'
