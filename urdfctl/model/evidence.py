"""What indicates the ROS distro of a robot, each fact with its weight."""

from __future__ import annotations

from urdfctl.catalog.distros import generation
from urdfctl.startup.records import NamedTuple


class Item(NamedTuple):
    """A fact that speaks for some distros.

    kind: where it is from; of several items of a kind, the heaviest counts.
    what: the fact, in words.
    distros: the distros that it speaks for.
    weight: how much it says about the generation, from 1 to EXPLICIT.
    file: the file that says it; None for the robot itself.
    """

    kind: str
    what: str
    distros: tuple[str, ...]
    weight: int
    file: str | None = None

    @property
    def ros(self) -> int | None:
        """The generation that it speaks for, 1 or 2; None if for both."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None


class Evidence(NamedTuple):
    """The distro and the simulator of a robot, and what indicates them.

    distro: the distro; None if several are possible.
    distros: the possible distros.
    source: what says most for them; None if nothing does.
    items: everything that indicates a distro, also what was outweighed.
    """

    distro: str | None
    distros: tuple[str, ...]
    source: str | None
    simulator: str | None = None
    simulator_from: str | None = None
    items: tuple[Item, ...] = ()

    @property
    def ros(self) -> int | None:
        """1 or 2; None if unknown."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None
