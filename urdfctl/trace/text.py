"""The answer of `urdfctl why` for people."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from urdfctl.output.printing import visible
from urdfctl.report.common import shown

Json = dict[str, Any]


def render(answer: Json) -> str:
    """Return the answer as text: for each value its chain, what decides whether it is there, and what uses it."""
    lines = [line for value in answer["values"] for line in (*_value(value), "")]
    if answer["more"]:
        lines += [f"{answer['more']} more values depend on it", ""]
    return "".join(f"{visible(line)}\n" for line in lines[:-1])


def _value(value: Json) -> Iterator[str]:
    yield f"{value['address']} = {value['value']}"
    calls: list[Json] = []
    for link in value["chain"]:
        yield f"{'  ' * (link['depth'] + 1)}{_link(link)}"
        for call in link["calls"] if link["calls"] != calls else ():
            yield f"{'  ' * (link['depth'] + 2)}in {call['kind']} {call['name']}, at {_place(call)}"
        calls = link["calls"]
    if value["numbers"]:
        yield "  numbers that it depends on: " + ", ".join(f"{one['text']} ({_place(one)})" for one in value["numbers"])
    for decided in value["decided_by"]:
        yield f"  is there because {decided['text']} is {_decided(decided)} ({_place(decided)})"
    for use in value["used_by"]:
        yield f"  used by {use['kind']} {use['name']}: {use['how']}" + (f" ({_place(use)})" if "file" in use else "")


def _link(link: Json) -> str:
    if link["kind"] == "yaml":
        return f"{_where(link)}{link['name']}: {link['value']}" if link["name"] else f"file {shown(link['file'])}"
    what = f"{_where(link)}{link['kind']} {link['name']}".rstrip()
    given = f", {link['given_by']}" if link.get("given_by") else ""
    text = link.get("text", "")
    if not text or text == link["value"]:
        return f"{what} = {link['value']}{given}" if link["value"] else f"{what}{given}"
    return f"{what} = {text} → {link['value']}{given}"


def _decided(decided: Json) -> str:
    return str(decided["value"]).lower() if decided["kind"] == "condition" else f"'{decided['value']}'"


def _where(link: Json) -> str:
    return f"{_place(link)}: " if "file" in link else ""


def _place(at: Json) -> str:
    return f"{shown(at['file'])}:{at['line']}:{at['column']}"
