"""Families of packages: those whose names begin with the same word, such as `ur_description` and `ur_robot_driver`.

The same last words after another first word are no slip where other packages begin with that word: beside `ur_tools`,
`ur_description` is not `mur_description` with a letter missing.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence


def may_be_meant(
    name: str, known: Sequence[str], own: str, declared: Callable[[], Collection[str]]
) -> tuple[list[str], str]:
    """Return the packages that may be meant by a name which none has, and the own one; empty if that is not meant.

    known: the names of the packages that are here.
    own: the name of the package that contains the file.
    declared: returns the names of all packages that these declare.
    """
    first, mark, rest = name.partition("_")
    family = first + mark
    alike = {each for each in (*known, own) if each.partition("_")[2] == rest and not each.startswith(family)}
    if not rest or not alike:
        return [*known], own
    if not any(each.startswith(family) and each != name for each in (*known, *declared())):
        return [*known], own
    return [each for each in known if each not in alike], "" if own in alike else own
