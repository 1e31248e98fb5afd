"""Compare the messages of findings: which are alike but for the names in them, and what the names are."""

from __future__ import annotations

import re
from functools import lru_cache

from urdfctl.catalog.distros import ALL

_NAME = rf"'[^']*'|<[^<>]*>|-?\b\d[\w.]*(?:[eE][+-]?\d+)?|\b(?:{'|'.join(ALL)})\b"
_LIST = r"''(?:, '')*(?:,? and (?:''|# more))?"
_HINT = "; did you mean"
_ADVICE = r"(?:did you mean|\buse|\bwrite|replacement:|\binstead of) .*"


@lru_cache(4096)
def shape(message: str) -> str:
    """Return a message without its names and numbers.

    What it advises is kept, so that two pieces of advice differ; but a name that is part of another, or that another is
    part of, is advised alike for other names: 'a.x' and 'b.x' without their prefixes.
    """
    found = re.search(_ADVICE, message)
    fault, advice = (message[: found.start()], found[0]) if found else (message, "")
    names = [name.strip("'<>") for name in re.findall(_NAME, fault) if _is_name(name)]

    def kept(match: re.Match[str]) -> str:
        advised = match[0].strip("'<>")
        return "''" if any(_is_part(advised, name) or _is_part(name, advised) for name in names) else match[0]

    return re.sub(_LIST, "''", re.sub(_NAME, _blank, fault)) + re.sub(_NAME, kept, advice)


def _is_part(name: str, other: str) -> bool:
    return name != "" and other.endswith((f".{name}", f"/{name}", f":{name}"))


def difference(first: str, other: str) -> str:
    """Return the first name or list of names that `other` has in place of one in `first`.

    Return an empty string if only numbers or distros differ, and all of `other` if the messages are not alike.
    """
    if shape(first) != shape(other):
        ours, theirs = first.partition(_HINT)[0], other.partition(_HINT)[0]
        return difference(ours, theirs) if (ours, theirs) != (first, other) and shape(ours) == shape(theirs) else other
    names, others = re.findall(_NAME, first), re.findall(_NAME, other)
    if len(names) != len(others):
        return next((name for name in others if name not in names and _is_name(name)), "")
    pairs = zip(names, others, strict=True)
    return next((theirs for ours, theirs in pairs if ours != theirs and _is_name(theirs)), "")


def named(first: str, other: str) -> str:
    """Return `difference`, but only the first name of `other` if the messages are not alike."""
    different = difference(first, other)
    if different != other:
        return different
    return next((name for name in re.findall(_NAME, other) if _is_name(name) and name not in first), "")


def _is_name(name: str) -> bool:
    return name[0] in "'<"


def _blank(match: re.Match[str]) -> str:
    return "''" if _is_name(match[0]) else "#"
