"""Attributes that an element of a launch file does not have, each with the one that was probably meant."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable

from urdfctl.names import nearest


def slips(
    unknown: Iterable[str],
    missing: Iterable[str],
    optional: Iterable[str],
    alike: Callable[[str, Collection[str]], str | None] = nearest,
) -> dict[str, str | None]:
    """Return the unknown attributes in order, each with what it is probably meant to be; None if that is not known.

    missing: the required attributes that the element does not have; each is meant by one unknown one at most.
    optional: the others that it may have.
    """
    left, found = list(missing), dict[str, str | None]()
    for name in unknown:
        meant = found[name] = alike(name, [*left, *optional])
        left = [other for other in left if other != meant]
    return found
