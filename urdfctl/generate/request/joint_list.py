"""Read lists of joints written by users: one name per line, CSV, YAML or JSON."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from urdfctl.errors import UserError
from urdfctl.generate.request.joint_keys import LISTS, is_name_key, joint_of, key_of, name_of
from urdfctl.generate.robot.facts import JointFacts

_YAML = re.compile(r"- |\[|\{|---|[^,;\t]+:(\s|$)")
_DELIMITERS = (";", "\t", ",")
_DEEP = 4


def joints_listed(text: str, source: str) -> tuple[JointFacts, ...]:
    """Return the joints of a list. UserError, starting with `source`, if it cannot be read.

    The format is JSON or YAML if the name of the source ends in .json, .yaml or .yml, or if the text starts like them.
    It is CSV if the first line contains a comma, a semicolon or a tab, or is a header; else one name per line.
    """
    text = text.removeprefix("\ufeff")
    lines = [plain for line in text.splitlines() if (plain := _without_comment(line)).strip()]
    first = lines[0].strip() if lines else ""
    if source.endswith((".yaml", ".yml", ".json")) or _YAML.match(first):
        return tuple(_of_tree(_tree(text, source), source))
    delimiter = max(_DELIMITERS, key=first.count)
    if delimiter in first or source.endswith(".csv") or is_name_key(first):
        return tuple(_of_csv(lines, delimiter, source))
    return tuple(JointFacts(name_of(line.strip(), source)) for line in lines)


def _without_comment(line: str) -> str:
    """A line up to a `#` at its start or after a space, outside double quotes."""
    quoted = False
    for index, c in enumerate(line):
        quoted ^= c == '"'
        if c == "#" and not quoted and (not index or line[index - 1].isspace()):
            return line[:index]
    return line


def _of_csv(lines: Iterable[str], delimiter: str, source: str) -> Iterator[JointFacts]:
    try:
        reader = csv.reader(lines, delimiter=delimiter, skipinitialspace=True)
        rows = [[cell.strip() for cell in row] for row in reader]
    except csv.Error as error:  # a cell of more than 128 KiB; in Python 3.10 a NUL, too
        raise UserError(f"{source}: not valid CSV: {error}") from None
    if not rows:
        return
    if not any(is_name_key(cell) for cell in rows[0]):
        known = next((cell for cell in rows[0] if key_of(cell)), None)
        if known and len(rows) > 1:
            raise UserError(f"{source}: the header has '{known}' and no column `name` with the joints' names")
        yield from (JointFacts(name_of(cell, source)) for row in rows for cell in row if cell)
        return
    header = rows[0]
    twice = next((cell for cell in header if cell and header.count(cell) > 1), None)
    if twice:
        raise UserError(f"{source}: two columns are called '{twice}'")
    for number, row in enumerate(rows[1:], 2):
        if any(row[len(header) :]):
            raise UserError(f"{source}: row {number} has {len(row)} cells, but the header has {len(header)}")
        yield joint_of({key: value for key, value in zip(header, row, strict=False) if key and value}, source)


def _tree(text: str, source: str) -> Any:
    """The content of a JSON or YAML file as plain data."""
    import yaml

    from urdfctl.source.budget import OverBudget
    from urdfctl.source.yaml.size import check_size

    try:
        check_size(text.encode("utf-8", "surrogateescape"))
    except OverBudget as error:
        raise UserError(f"{source}: {error}") from None
    except yaml.YAMLError:
        pass  # reported below, in the words of the format
    if source.endswith(".json") or text.lstrip().startswith(("{", "[")):
        try:
            return json.loads(text)
        except (ValueError, RecursionError) as error:
            if source.endswith(".json"):
                raise UserError(f"{source}: not valid JSON: {error}") from None
    try:
        return yaml.load(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (a safe loader)
    except yaml.YAMLError as error:
        raise UserError(f"{source}: not valid YAML: {' '.join(str(error).split())}") from None
    except ValueError as error:  # such as a date in a thirteenth month
        raise UserError(f"{source}: not valid YAML: {error}") from None


def _of_tree(plain: Any, source: str) -> Iterator[JointFacts]:
    if plain is None:
        return
    if isinstance(plain, Mapping):
        found = list(_lists(plain, _DEEP))
        if len(found) > 1:
            raise UserError(f"{source}: several lists of joints; keep one of them, or use --joint NAME,NAME")
        plain = found[0] if found else plain
    if isinstance(plain, Mapping):
        plain = [{"name": name, **(value if isinstance(value, Mapping) else {})} for name, value in plain.items()]
    if not isinstance(plain, Sequence) or isinstance(plain, str):
        raise UserError(f"{source}: not a list of joints; write one name per line, or `- name: ...`")
    for entry in plain:
        if entry not in ("", None):  # ROS-Industrial's lists begin with an empty name
            yield joint_of(entry, source) if isinstance(entry, Mapping) else JointFacts(name_of(entry, source))


def _lists(plain: Mapping[Any, Any], deep: int) -> Iterator[Any]:
    """The lists of joints in a mapping, at any of the first levels."""
    here = [plain[key] for key in LISTS if isinstance(plain.get(key), list | Mapping)]
    if here or not deep:
        yield from here
        return
    for value in plain.values():
        if isinstance(value, Mapping):
            yield from _lists(value, deep - 1)
