"""Did-you-mean: the known name nearest to one that is not known."""

from __future__ import annotations

from collections.abc import Iterable


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name most like `name`, or None where nothing is like it."""
    from difflib import get_close_matches

    candidates = sorted({candidate for candidate in known if candidate})
    by_folded = {candidate.casefold().replace("-", "_"): candidate for candidate in candidates}
    same = by_folded.get(name.casefold().replace("-", "_"))
    if same is not None and same != name:
        return same
    found = get_close_matches(name, [c for c in candidates if c != name], n=1, cutoff=0.8)
    return found[0] if found else None


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """`"; did you mean 'x'?"`, or nothing, to be put behind a message."""
    found = nearest(name, known)
    return f"; did you mean '{found}'?" if found else ""
