"""Check entries against schema.json, with messages that name the key.

Supports only the part of JSON Schema that schema.json uses.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from urdfctl.catalog.distros import ALL, spanned
from urdfctl.names import did_you_mean
from urdfctl.startup.records import NamedTuple

Schema = Mapping[str, Any]


class Flaw(NamedTuple):
    """A violation of the schema.

    path: the key at fault, e.g. `parameters.joints.type`.
    message: what is wrong with it.
    """

    path: str
    message: str


def flaws(entry: object, kind: str, path: str = "") -> Iterator[Flaw]:
    """Yield the flaws of an entry.

    kind: a definition in schema.json: `controller`, `hardware`, ...
    path: the path of the entry itself, a prefix of all reported paths.
    """
    return _flaws(entry, _definitions()[kind], path)


@lru_cache(maxsize=1)
def _definitions() -> Mapping[str, Schema]:
    with open(os.path.join(os.path.dirname(__file__), "schema.json"), encoding="utf-8") as file:
        return json.load(file)["$defs"]  # type: ignore[no-any-return]


def _flaws(value: Any, schema: Schema, path: str) -> Iterator[Flaw]:
    if "$ref" in schema:
        yield from _flaws(value, _definitions()[schema["$ref"].rpartition("/")[2]], path)
        return
    if "anyOf" in schema:
        if all(any(_flaws(value, choice, path)) for choice in schema["anyOf"]):
            yield from _flaws(value, _most_likely(value, schema["anyOf"]), path)
        return
    if "enum" in schema and value not in schema["enum"]:
        *others, last = [json.dumps(choice) for choice in schema["enum"]]
        choices = f"{', '.join(others)} or {last}" if others else last
        yield Flaw(path, f"must be {choices}, not {_short(value)}")
    if "type" in schema and not _TYPES[schema["type"]](value):
        yield Flaw(path, f"must be {_WORDS[schema['type']]}, not {_short(value)}")
    elif isinstance(value, str):
        yield from _flaws_of_text(value, schema, path)
    elif isinstance(value, list):
        yield from _flaws_of_list(value, schema, path)
    elif isinstance(value, dict):
        yield from _flaws_of_table(value, schema, path)


def _flaws_of_text(value: str, schema: Schema, path: str) -> Iterator[Flaw]:
    if schema.get("format") == "span":
        try:
            spanned(value, 1)
        except ValueError as error:
            yield Flaw(path, str(error))
    if schema.get("format") == "distro" and value not in ALL:
        yield Flaw(path, f"unknown distro '{value}'{did_you_mean(value, ALL)}")
    if "pattern" in schema and not re.search(schema["pattern"], value):
        yield Flaw(path, f"'{value}' is invalid; expected a {schema['description']}")


def _flaws_of_list(value: list[Any], schema: Schema, path: str) -> Iterator[Flaw]:
    least, most = schema.get("minItems", 0), schema.get("maxItems", len(value))
    if not least <= len(value) <= most:
        limit, bound = ("at least", least) if len(value) < least else ("at most", most)
        yield Flaw(path, f"must have {limit} {bound} {'element' if bound == 1 else 'elements'}")
    for index, element in enumerate(value):
        yield from _flaws(element, schema.get("items", {}), f"{path}[{index}]")


def _flaws_of_table(value: dict[str, Any], schema: Schema, path: str) -> Iterator[Flaw]:
    known: Schema = schema.get("properties", {})
    others = schema.get("additionalProperties", True)
    for key in schema.get("required", ()):
        if key not in value:
            yield Flaw(path, f"required key '{key}' is missing")
    for key, item in value.items():
        below = f"{path}.{_quoted(key)}" if path else _quoted(key)
        if "propertyNames" in schema:
            yield from _flaws(key, schema["propertyNames"], below)
        if key in known:
            yield from _flaws(item, known[key], below)
        elif others is False:
            yield Flaw(path, f"unknown key '{key}'{did_you_mean(key, known)}")
        elif others is not True:
            yield from _flaws(item, others, below)


def _most_likely(value: Any, choices: list[Schema]) -> Schema:
    """The alternative whose flaws to report: the first that accepts the value's type, otherwise the last."""
    resolved = [_definitions()[c["$ref"].rpartition("/")[2]] if "$ref" in c else c for c in choices]
    return next((c for c in resolved if "type" in c and _TYPES[c["type"]](value)), resolved[-1])


def _quoted(key: str) -> str:
    """The key in TOML syntax."""
    return key if re.fullmatch(r"[\w-]+", key) else json.dumps(key)


def _short(value: object) -> str:
    text = json.dumps(value, default=str)
    return text if len(text) <= 40 else f"{text[:40]}..."  # noqa: PLR2004


_TYPES = {
    "string": lambda value: isinstance(value, str),
    "boolean": lambda value: isinstance(value, bool),
    "integer": lambda value: isinstance(value, int) and not isinstance(value, bool),
    "number": lambda value: isinstance(value, int | float) and not isinstance(value, bool),
    "array": lambda value: isinstance(value, list),
    "object": lambda value: isinstance(value, dict),
}
_WORDS = {
    "string": "a string",
    "boolean": "true or false",
    "integer": "an integer",
    "number": "a number",
    "array": "a list",
    "object": "a table",
}
