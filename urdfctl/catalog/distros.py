"""The ROS distributions in the order of their release, and how messages name them."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import lru_cache

from urdfctl.startup.records import NamedTuple


class Distro(NamedTuple):
    """A ROS distribution.

    ros: 1 or 2.
    maintained: True if it still gets releases.
    long_term: True if it is supported for five years.
    bygone: True if its support ended before 2020: nobody starts with it.
    """

    name: str
    ros: int
    maintained: bool = False
    long_term: bool = False
    bygone: bool = False


DISTROS = (
    Distro("hydro", 1, bygone=True),
    Distro("indigo", 1, bygone=True),
    Distro("jade", 1, bygone=True),
    Distro("kinetic", 1),
    Distro("lunar", 1, bygone=True),
    Distro("melodic", 1),
    Distro("noetic", 1),
    Distro("foxy", 2, long_term=True),
    Distro("galactic", 2),
    Distro("humble", 2, maintained=True, long_term=True),
    Distro("iron", 2),
    Distro("jazzy", 2, maintained=True, long_term=True),
    Distro("kilted", 2, maintained=True),
    Distro("lyrical", 2, maintained=True, long_term=True),
    Distro("rolling", 2, maintained=True),
)
"""In the order of their release. A new distro is one line here, before rolling; rules name distros by `since`,
`until` and `between`, so that they hold for it."""
ROS1 = tuple(distro.name for distro in DISTROS if distro.ros == 1)
ROS2 = tuple(distro.name for distro in DISTROS if distro.ros == 2)  # noqa: PLR2004 (the generation)
ALL = ROS1 + ROS2
MAINTAINED = tuple(distro.name for distro in DISTROS if distro.maintained)
_LONG_TERM = tuple(distro.name for distro in DISTROS if distro.long_term)
BYGONE = tuple(distro.name for distro in DISTROS if distro.bygone)
SIMULATORS = ("gz", "gazebo-classic", "mujoco", "none")


def since(distro: str) -> tuple[str, ...]:
    """Return a distro and the later ones of its generation."""
    family = ROS1 if distro in ROS1 else ROS2
    return family[family.index(distro) :]


def until(distro: str) -> tuple[str, ...]:
    """Return a distro and the earlier ones of its generation."""
    family = ROS1 if distro in ROS1 else ROS2
    return family[: family.index(distro) + 1]


def between(first: str, last: str) -> tuple[str, ...]:
    """Return the distros of one generation from `first` to `last`, both included."""
    return tuple(distro for distro in since(first) if distro in until(last))


def coming(distro: str) -> tuple[str, ...]:
    """Return the ROS 2 distros after one, up to the next one with long-term support; none for ROS 1."""
    later = since(distro)[1:] if distro in ROS2 else ()
    next_long = next((index for index, each in enumerate(later) if each in _LONG_TERM), len(later))
    return later[: next_long + 1]


def generation(distro: str) -> int:
    """Return the ROS generation of a distro, 1 or 2."""
    return 1 if distro in ROS1 else 2


@lru_cache(maxsize=1024)
def spanned(text: str, ros: int) -> tuple[str, ...]:
    """Return the distros of a generation that a span names: `humble..`, `..iron`, `galactic, iron`.

    Distros of the other generation are ignored. Raises ValueError if a name is not a distro.
    """
    family = ROS1 if ros == 1 else ROS2
    named: set[str] = set()
    for part in text.split(","):
        first, dots, last = part.strip().partition("..")
        if not {first, last} <= {*ALL, ""}:
            raise ValueError(f"'{part.strip()}' is not a distro")
        if not {first, last} <= {*family, ""}:
            continue
        start = family.index(first) if first or not dots else 0
        end = family.index(last) if last else len(family) - 1 if dots else start
        named.update(family[start : end + 1])
    return tuple(distro for distro in family if distro in named)


def in_words(distros: Iterable[str]) -> str:
    """Return `ROS 1`, `ROS 2`, `all distros`, `kinetic to noetic`, `ROS 1, foxy`, or the names."""
    wanted = set(distros)
    if wanted.issuperset(ALL):
        return "all distros"
    families = (("ROS 1", ROS1), ("ROS 2", ROS2))
    return ", ".join(filter(None, (_family_in_words(wanted, whole, family) for whole, family in families)))


def _family_in_words(wanted: Collection[str], whole: str, family: tuple[str, ...]) -> str:
    names = tuple(distro for distro in family if distro in wanted)
    if names == family:
        return whole
    if len(names) > 2 and names == family[family.index(names[0]) :][: len(names)]:  # noqa: PLR2004 (two are listed)
        return f"{names[0]} to {names[-1]}"
    return ", ".join(names)


def span_in_words(distros: Iterable[str]) -> str:
    """Return the first and the last of some distros: `humble to rolling`; the name of a single one."""
    names = [distro for distro in ALL if distro in set(distros)]
    return f"{names[0]} to {names[-1]}" if len(names) > 1 else "".join(names)


APPLIES = "applies "
"""How the note on a finding's distros begins."""


def applies_to(distros: Iterable[str]) -> str:
    """Return the note on a finding's distros: `applies to kilted and later`, `applies from foxy to iron`."""
    names = in_words(distros)
    if names.endswith(" to rolling"):
        return f"{APPLIES}to {names.removesuffix(' to rolling')} and later"
    return f"{APPLIES}{'from' if ' to ' in names and ',' not in names else 'to'} {names}"
