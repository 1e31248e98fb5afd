"""The ROS distributions, in the order of their release, and what they are called in messages."""

from __future__ import annotations

from collections.abc import Iterable

ROS1 = ("hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic")
ROS2 = ("foxy", "galactic", "humble", "iron", "jazzy", "kilted", "lyrical", "rolling")
ALL = ROS1 + ROS2
SIMULATORS = ("gz", "gazebo-classic", "mujoco", "none")


def since(distro: str) -> tuple[str, ...]:
    """The distros of the same generation from one on."""
    family = ROS1 if distro in ROS1 else ROS2
    return family[family.index(distro) :]


def until(distro: str) -> tuple[str, ...]:
    """The distros of the same generation up to and with one."""
    family = ROS1 if distro in ROS1 else ROS2
    return family[: family.index(distro) + 1]


def generation(distro: str) -> int:
    """1 or 2."""
    return 1 if distro in ROS1 else 2


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
