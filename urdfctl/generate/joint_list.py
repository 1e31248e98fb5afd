"""Read lists of joints written by users: one name per line, CSV with a header, or YAML."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Mapping

from urdfctl.errors import UserError
from urdfctl.generate.facts import JointFacts
from urdfctl.names import did_you_mean
from urdfctl.startup.hints import Any

_NUMBERS = ("lower", "upper", "effort", "velocity", "reduction", "radius", "inertia")
_GAINS = ("p", "i", "d", "i_clamp")
_TEXTS = ("name", "type", "interface")
_YAML = re.compile(r"- |\[|\{|[^,]+:(\s|$)")
KEYS = (*_TEXTS, *_NUMBERS, *_GAINS, "gains", "limits")


def joints_listed(text: str, source: str) -> tuple[JointFacts, ...]:
    """Return the joints of a list. UserError, starting with `source`, if it cannot be read.

    The format is YAML if the name of the source ends in .yaml or .yml, or if the text starts like YAML. It is CSV if
    the first line contains a comma.
    """
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    first = lines[0].strip() if lines else ""
    if source.endswith((".yaml", ".yml")) or _YAML.match(first):
        return tuple(_of_yaml(text, source))
    if source.endswith(".csv") or "," in first:
        return tuple(_of_csv(lines, source))
    return tuple(JointFacts(line.strip()) for line in lines)


def _of_csv(lines: Iterable[str], source: str) -> Iterable[JointFacts]:
    try:
        rows = [[cell.strip() for cell in row] for row in csv.reader(lines, skipinitialspace=True)]
    except csv.Error as error:  # a cell of more than 128 KiB; in Python 3.10 a NUL, too
        raise UserError(f"{source}: not valid CSV: {error}") from None
    if not rows:
        return
    header = rows[0] if "name" in rows[0] else None
    if header is None:
        yield from (JointFacts(cell) for row in rows for cell in row if cell)
        return
    for row in rows[1:]:
        filled = {key: value for key, value in zip(header, row, strict=False) if value}
        yield _joint(filled, source)


def _of_yaml(text: str, source: str) -> Iterable[JointFacts]:
    import yaml

    from urdfctl.source.budget import OverBudget
    from urdfctl.source.yaml_size import check_size

    try:
        check_size(text.encode("utf-8", "surrogateescape"))
        plain = yaml.load(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (a safe loader)
    except yaml.YAMLError as error:
        raise UserError(f"{source}: not valid YAML: {' '.join(str(error).split())}") from None
    except (OverBudget, ValueError) as error:  # such as a date in a thirteenth month
        raise UserError(f"{source}: not valid YAML: {error}") from None
    if isinstance(plain, Mapping) and isinstance(plain.get("joints"), list | Mapping):
        plain = plain["joints"]
    if isinstance(plain, Mapping):
        plain = [{"name": name, **(value if isinstance(value, Mapping) else {})} for name, value in plain.items()]
    if not isinstance(plain, list):
        raise UserError(f"{source}: not a list of joints; write one name per line, or `- name: ...`")
    for entry in plain:
        yield _joint(entry, source) if isinstance(entry, Mapping) else JointFacts(_name(entry, source))


def _joint(plain: Mapping[Any, object], source: str) -> JointFacts:
    flat: dict[str, object] = {}
    for key, value in plain.items():
        if key not in KEYS:
            raise UserError(f"{source}: unknown key '{key}'{did_you_mean(str(key), KEYS)}; known: {', '.join(KEYS)}")
        flat.update(value if key in ("gains", "limits") and isinstance(value, Mapping) else {key: value})
    unknown = [key for key in flat if key not in KEYS]
    if unknown or "name" not in flat:
        raise UserError(f"{source}: {f'unknown key {unknown[0]!r}' if unknown else 'a joint without a name'}")
    numbers: dict[str, Any] = {
        key: _number(key, flat[key], source) for key in (*_NUMBERS, *_GAINS) if flat.get(key) is not None
    }
    gains = tuple((key, numbers.pop(key)) for key in _GAINS if key in numbers)
    texts: dict[str, Any] = {key: str(flat[key]) for key in ("type", "interface") if flat.get(key) is not None}
    return JointFacts(_name(flat["name"], source))._replace(**numbers, **texts, gains=gains)


def _name(value: object, source: str) -> str:
    if not isinstance(value, str) or not value:
        raise UserError(f"{source}: '{value}' is not a joint name; quote names that YAML reads as another type")
    return value


def _number(key: str, value: object, source: str) -> float:
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise UserError(f"{source}: '{key}' must be a number, not '{value}'") from None
