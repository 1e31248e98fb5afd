"""Names in messages: the known name most similar to an unknown one, did-you-mean hints, and lists of names."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

_LEAST_SIMILARITY = 0.8
"""The least ratio, from 0 to 1, at which one name counts as a misspelling of the other."""
_SEPARATORS = "/_-:."
_FEW = 3
"""A prefix that fewer names than this share says nothing."""
_MOST_COMPARED = 300_000
"""Names that may be compared for the hints of one rule; a hundred unknown names among a thousand joints are fewer."""
_CLOSELY = 10
"""Names that are compared in the time of one close comparison."""
_compared = 0


def forget_comparisons() -> None:
    """Allow as many comparisons for hints again: each rule is to find the same, whatever ran before it."""
    global _compared  # noqa: PLW0603 (counts what `nearest` does, wherever it is called)
    _compared = 0


def _may_compare(count: int) -> bool:
    """Count comparisons. Return whether there were not too many yet."""
    global _compared  # noqa: PLW0603 (see above)
    _compared += count
    return _compared <= _MOST_COMPARED


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name most similar to `name`, or None if none is similar.

    A namespace or a robot's name before most names makes none of them more similar. After too many comparisons, see
    `forget_comparisons`, none is looked for.
    """
    if not _may_compare(0):
        return None
    candidates = sorted({candidate for candidate in known if candidate})
    if not _may_compare(len(candidates)):
        return None
    by_folded = {_folded(candidate): candidate for candidate in candidates}
    same = by_folded.get(_folded(name))
    if same is not None and same != name:
        return same
    similar = [
        candidate for candidate in candidates if candidate != name and _may_be_alike(name, candidate, _LEAST_SIMILARITY)
    ]
    if not similar or not _may_compare(_CLOSELY * len(similar)):
        return None
    prefix = _prefix_of_most(name, candidates)
    ratio, closest = max((_similarity_past(prefix, name, candidate), candidate) for candidate in similar)
    return closest if ratio >= _LEAST_SIMILARITY else None


def _folded(name: str) -> str:
    """A name as it is written in any style: i_clamp, i-clamp, iClamp."""
    return name.casefold().replace("-", "").replace("_", "")


def _prefix_of_most(name: str, known: Sequence[str]) -> str:
    """The longest prefix of a name, up to a separator, that most known names have; empty if few names are known."""
    ends = [end for end, letter in enumerate(name, 1) if letter in _SEPARATORS and end < len(name)]
    least = max(_FEW, len(known) / 2)
    for end in reversed(ends):
        if sum(candidate.startswith(name[:end]) for candidate in known) >= least:
            return name[:end]
    return ""


def _similarity_past(prefix: str, name: str, other: str) -> float:
    """The similarity of what two names have after a prefix; of all of them if one is a slip, or without the prefix."""
    if not prefix or not other.startswith(prefix) or is_slip(name, other):
        return similarity(other, name)
    return similarity(other[len(prefix) :], name[len(prefix) :])


def is_alike(name: str, other: str, ratio: float) -> bool:
    """Return whether the ratio of letters that two names share in order, from 0 to 1, is at least `ratio`."""
    return _may_be_alike(name, other, ratio) and similarity(name, other) >= ratio


def similarity(name: str, other: str) -> float:
    """Return the ratio of letters that two names share in order, from 0 to 1, as `difflib.SequenceMatcher` does."""
    from difflib import SequenceMatcher

    return SequenceMatcher(None, name, other).ratio()


def _may_be_alike(name: str, other: str, ratio: float) -> bool:
    """Whether two names share enough letters in any order. Cheap, to skip most of the slow exact comparisons."""
    least = ratio * (len(name) + len(other)) / 2
    return min(len(name), len(other)) >= least and sum(map(other.__contains__, name)) >= least


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return `"; did you mean 'x'?"` to append to a message, or an empty string."""
    meant = nearest(name, known)
    return f"; did you mean '{meant}'?" if meant else ""


def nearest_path(path: str) -> str:
    """Return the did-you-mean hint for a path that does not exist, from the names in its folder."""
    try:
        return did_you_mean(os.path.basename(path), os.listdir(os.path.dirname(path) or os.curdir))
    except OSError:
        return ""


def is_slip(name: str, other: str) -> bool:
    """Return whether two names differ by one letter missing, added or wrong, or by two letters swapped."""
    short, long = sorted((name, other), key=len)
    if len(long) - len(short) > 1 or short == long:
        return False
    start = next((i for i, (a, b) in enumerate(zip(short, long, strict=False)) if a != b), len(short))
    tail, rest = short[start:], long[start:]
    swapped = len(rest) > 1 and len(tail) == len(rest) and tail == rest[1] + rest[0] + rest[2:]
    return rest[1:] in (tail, tail[1:]) or swapped


def folded(name: str) -> str:
    """Return a name in lower case without underscores and hyphens."""
    return name.lower().replace("_", "").replace("-", "")


def enumerated(parts: Iterable[str], conjunction: str = "and") -> str:
    """Return `a, b and c`, or an empty string if there are no parts."""
    *most, last = [*parts] or [""]
    return f"{', '.join(most)} {conjunction} {last}" if most else last
