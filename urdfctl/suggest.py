"""What messages make of names: did-you-mean, the known name nearest to one that is not known, and several in a row."""

from __future__ import annotations

import os
from collections.abc import Iterable


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name most like `name`, or None where nothing is like it."""
    candidates = sorted({candidate for candidate in known if candidate})
    by_folded = {candidate.casefold().replace("-", "_"): candidate for candidate in candidates}
    same = by_folded.get(name.casefold().replace("-", "_"))
    if same is not None and same != name:
        return same
    alike = [candidate for candidate in candidates if candidate != name and _may_be_like(name, candidate)]
    if not alike:
        return None
    from difflib import get_close_matches

    found = get_close_matches(name, alike, n=1, cutoff=_ALIKE)
    return found[0] if found else None


_ALIKE = 0.8
"""The least part of two names that is the same where one may be meant by the other."""


def _may_be_like(name: str, other: str) -> bool:
    """Whether so many letters are in both that a closer look, which takes long, may find them alike."""
    least = _ALIKE * (len(name) + len(other)) / 2
    return min(len(name), len(other)) >= least and sum(map(other.__contains__, name)) >= least


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """`"; did you mean 'x'?"`, or nothing, to be put behind a message."""
    found = nearest(name, known)
    return f"; did you mean '{found}'?" if found else ""


def nearest_path(path: str) -> str:
    """Did-you-mean for a path that does not exist."""
    try:
        return did_you_mean(os.path.basename(path), os.listdir(os.path.dirname(path) or os.curdir))
    except OSError:
        return ""


def is_slip(name: str, other: str) -> bool:
    """Whether one letter is missing, too many, wrong, or two have changed places."""
    short, long = sorted((name, other), key=len)
    if len(long) - len(short) > 1 or short == long:
        return False
    start = next((i for i, (a, b) in enumerate(zip(short, long, strict=False)) if a != b), len(short))
    tail, rest = short[start:], long[start:]
    swapped = len(rest) > 1 and len(tail) == len(rest) and tail == rest[1] + rest[0] + rest[2:]
    return rest[1:] in (tail, tail[1:]) or swapped


def folded(name: str) -> str:
    """A name without case, underscores and hyphens."""
    return name.lower().replace("_", "").replace("-", "")


def enumerated(parts: Iterable[str], conjunction: str = "and") -> str:
    """`a, b and c`; empty where there are none."""
    *most, last = [*parts] or [""]
    return f"{', '.join(most)} {conjunction} {last}" if most else last
