"""The namespaces of robots in ROS 1, and what is loaded or spawned outside of them."""

from __future__ import annotations

from collections.abc import Collection


def nearest_home(namespace: str, homes: Collection[str], default: str) -> str:
    """Return the nearest of some namespaces that is around another one, or the same."""
    return max((one for one in homes if f"{namespace}/".startswith(f"{one}/")), key=len, default=default)


def strays(
    namespaces: Collection[str | None], partners: Collection[str | None], homes: Collection[str]
) -> dict[str, set[str]]:
    """Return those namespaces that are of no robot and have no partner, each with the robots that are meant.

    Parameters are loaded where controllers are spawned. In a namespace without the other, one of the two is wrong: it
    belongs to a robot which has only the other.

    namespaces: those of parameters, or of spawners. partners: those of the others. homes: those of the robots.
    """
    known = {*homes, *(one for one in partners if one is not None)} - {""}
    lost = {one for one in namespaces if one and not nearest_home(one, known, "")}
    served = {nearest_home(one, homes, "") for one in namespaces if one is not None and one not in lost}
    lacking = {home for home in homes if home in partners} - served
    return dict.fromkeys(lost, lacking) if lacking else {}
