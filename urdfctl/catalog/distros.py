"""The ROS distributions, in the order of their release, and what they are called in messages."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

ROS1 = ("hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic")
ROS2 = ("foxy", "galactic", "humble", "iron", "jazzy", "kilted", "lyrical", "rolling")
ALL = ROS1 + ROS2
MAINTAINED = ("humble", "jazzy", "kilted", "lyrical", "rolling")
"""Of ROS 2, those that still get releases."""
_LONG_TERM = ("foxy", "humble", "jazzy", "lyrical")
SIMULATORS = ("gz", "gazebo-classic", "mujoco", "none")


def since(distro: str) -> tuple[str, ...]:
    """The distros of the same generation from one on."""
    family = ROS1 if distro in ROS1 else ROS2
    return family[family.index(distro) :]


def until(distro: str) -> tuple[str, ...]:
    """The distros of the same generation up to and with one."""
    family = ROS1 if distro in ROS1 else ROS2
    return family[: family.index(distro) + 1]


def coming(distro: str) -> tuple[str, ...]:
    """The distros of ROS 2 after one, up to and with the next that is supported for long; of ROS 1 none."""
    later = since(distro)[1:] if distro in ROS2 else ()
    next_long = next((index for index, each in enumerate(later) if each in _LONG_TERM), len(later))
    return later[: next_long + 1]


def generation(distro: str) -> int:
    """1 or 2."""
    return 1 if distro in ROS1 else 2


@lru_cache(maxsize=1024)
def spanned(text: str, ros: int) -> tuple[str, ...]:
    """The distros of a generation that a span names: `humble..` from one on, `..iron` up to one, `galactic, iron`.

    Those of the other generation name nothing here. ValueError where it names what is no distro.
    """
    family = ROS1 if ros == 1 else ROS2
    named: set[str] = set()
    for part in text.split(","):
        first, dots, last = part.strip().partition("..")
        if not {first, last} <= {*ALL, ""}:
            raise ValueError(f"'{part.strip()}' names no distro")
        if not {first, last} <= {*family, ""}:
            continue
        start = family.index(first) if first or not dots else 0
        end = family.index(last) if last else len(family) - 1 if dots else start
        named.update(family[start : end + 1])
    return tuple(distro for distro in family if distro in named)


def in_words(distros: Iterable[str]) -> str:
    """`ROS 1`, `ROS 2`, `all distros`, `kinetic to noetic`, or the names."""
    names = tuple(distro for distro in ALL if distro in set(distros))
    for whole, words in ((ALL, "all distros"), (ROS1, "ROS 1"), (ROS2, "ROS 2")):
        if names == whole:
            return words
    for family in (ROS1, ROS2):
        if len(names) > 2 and names[0] in family and names == family[family.index(names[0]) :][: len(names)]:  # noqa: PLR2004
            return f"{names[0]} to {names[-1]}"
    return ", ".join(names)
