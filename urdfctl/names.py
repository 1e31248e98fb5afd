"""Names in messages: the known name most similar to an unknown one, did-you-mean hints, and lists of names."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence

_LEAST_SIMILARITY = 0.8
"""The least ratio, from 0 to 1, at which one name counts as a misspelling of the other."""
_SEPARATORS = "/_-:."
_LEAST_OF_REST = 0.6
"""The least ratio at which what two names have before the last word that they share counts as similar."""
_FEW = 3
"""A prefix that fewer names than this share says nothing."""
_MOST_COMPARED = 300_000
"""Names that may be compared for the hints of one rule; a hundred unknown names among a thousand joints are fewer."""
_CLOSELY = 10
"""Names that are compared in the time of one close comparison."""
_SHORTEST = 4
_FEWEST_WORDS = 2
_MOST_WORDS_MORE = 2
_WORD = r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+"
_OPPOSED = (
    ("left l lft", "right r rgt"),
    ("front", "rear", "back", "hind"),
    ("upper", "lower"),
    ("top", "bottom"),
    ("min minimum", "max maximum"),
    ("x", "y", "z"),
    ("roll", "pitch", "yaw"),
    ("position", "velocity", "effort", "acceleration"),
    ("tf", "rate"),
    ("linear", "angular"),
    ("inner", "outer"),
    ("open", "close"),
)
"""Words that exclude each other: a name with one of a row never means one with another of it."""
_MEANINGS = {
    word: (row, place)
    for row, words in enumerate(_OPPOSED)
    for place, same in enumerate(words)
    for word in same.split()
}
_KINDS = ("joint", "link", "motor", "controller")
_KINDS_OF_PACKAGES = ("bringup", "config", "control", "description", "driver", "gazebo", "msgs", "simulation")
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

    A name of another side, axis, quantity or number, such as `left` for `right`, is not similar. A namespace or a
    robot's name before most names makes none of them more similar, nor does the word for a kind of package, such as
    `description`. After too many comparisons, see `forget_comparisons`, none is looked for.
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
        candidate
        for candidate in candidates
        if candidate != name
        and _may_be_alike(name, candidate, _LEAST_SIMILARITY)
        and not are_opposed(name, candidate)
        and _are_alike_before_last_word(name, candidate)
    ]
    if not similar:
        return _slip_of(name, candidates)
    if not _may_compare(_CLOSELY * len(similar)):
        return None
    prefix = _prefix_of_most(name, candidates)
    ratio, closest = max((_similarity_past(prefix, name, candidate), candidate) for candidate in similar)
    return closest if ratio >= _LEAST_SIMILARITY else None


def _slip_of(name: str, candidates: Sequence[str]) -> str | None:
    """The only name of four letters or more, too short to be similar, from which another one differs by one letter."""
    if len(name) < _SHORTEST:
        return None
    slips = [other for other in candidates if len(other) >= _SHORTEST and is_slip(name, other)]
    return slips[0] if len(slips) == 1 and not are_opposed(name, slips[0]) else None


def fuller(name: str, known: Iterable[str]) -> str | None:
    """Return the only known name that has all words of another one in their order, and one or two more; None if there
    is none: `joint1_position_controller` for `joint1_controller`."""
    words = _words(name)
    if len(words) < _FEWEST_WORDS:
        return None
    found = [other for other in known if 0 < len(_words(other)) - len(words) <= _MOST_WORDS_MORE]
    found = [other for other in found if _are_in_order(words, _words(other))]
    return found[0] if len(found) == 1 else None


def differ_by_kind(name: str, other: str) -> bool:
    """Return whether two names differ only by the word for what they name: `elbow` and `elbow_joint`."""
    here, there = ([word for word in _words(each) if word not in _KINDS] for each in (name, other))
    return name != other and bool(here) and here == there


def _are_in_order(words: Sequence[str], others: Sequence[str]) -> bool:
    rest = iter(others)
    return all(word in rest for word in words)


def is_only_slip(name: str, meant: str, known: Iterable[str]) -> bool:
    """Return whether a name is another one with one letter wrong, and no third one comes near."""
    return is_slip(name, meant) and nearest(name, (other for other in known if other != meant)) is None


def _words(name: str) -> tuple[str, ...]:
    """The words of a name in lower case, and its numbers without leading zeros."""
    parts = re.findall(_WORD, name)
    return tuple(part.lstrip("0") or "0" if part.isdigit() else part.lower() for part in parts)


def are_opposed(name: str, other: str) -> bool:
    """Return whether two names differ by words that exclude each other: left and right, x and y, 1 and 2."""
    here, there = set(_words(name)), set(_words(other))
    return any(_excludes(one, another) for one in here - there for another in there - here)


def in_row(name: str) -> str:
    """Return what a name has in common with the others of its row: no numbers, and no words such as left and right."""
    meanings = ((word, _MEANINGS.get(word)) for word in _words(name))
    return "_".join("0" if word.isdigit() else str(meaning[0]) if meaning else word for word, meaning in meanings)


def _excludes(word: str, other: str) -> bool:
    if word.isdigit() and other.isdigit():
        return len(word) == len(other)  # another number; a digit more or less is a slip
    meaning, others = _MEANINGS.get(word), _MEANINGS.get(other)
    return meaning is not None and others is not None and meaning[0] == others[0] and meaning != others


def _are_alike_before_last_word(name: str, other: str) -> bool:
    """Whether more than the word for a kind of package makes two names similar."""
    first, _, word = name.rpartition("_")
    other_first, _, other_word = other.rpartition("_")
    is_kind = word == other_word and word in _KINDS_OF_PACKAGES
    return not is_kind or is_alike(first, other_first, _LEAST_OF_REST)


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


def shortened(names: Sequence[str], most: int) -> str:
    """Return names as `a, b and 4 more`: the first `most`, or all of them if there is only one more."""
    shown = names if len(names) <= most + 1 else names[:most]
    more = f" and {len(names) - len(shown)} more" if len(names) > len(shown) else ""
    return f"{', '.join(shown)}{more}"


def enumerated(parts: Iterable[str], conjunction: str = "and") -> str:
    """Return `a, b and c`, or an empty string if there are no parts."""
    *most, last = [*parts] or [""]
    return f"{', '.join(most)} {conjunction} {last}" if most else last
