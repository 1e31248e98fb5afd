"""Find the distro that each package of a migration comes from."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from urdfctl.catalog.distros import ALL, ROS2, generation
from urdfctl.errors import UserError
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.source.disk.files import is_launch
from urdfctl.source.workspaces.packages import package_around
from urdfctl.startup.records import NamedTuple

_SINCE_FILES = "jazzy"
"""The first distro in which the spawner must name the file of its controllers."""
_FILE_OPTION = b"--param-file"


class Origins(NamedTuple):
    """The distros that packages come from.

    packages: the distro of each package folder; without those for which nothing says it.
    all: the earliest of them; None if none is known.
    """

    packages: Mapping[str, str]
    all: str | None

    def of(self, path: str) -> str | None:
        """Return the distro that the package of a file comes from; the earliest of all if nothing says it."""
        return self.packages.get(package_around(os.path.dirname(path)) or "", self.all)


def origins(options: MigrationOptions, linted: Sequence[tuple[Target, TargetResult]], scratch: Scratch) -> Origins:
    """Return the distros that packages come from, before anything is changed.

    The distro that the user names holds for the packages of its generation. A package that may be for the target is
    taken to be there if its spawners name files as those of the target must, or if others of the run are for ROS 1: the
    migration of these packages is under way.
    """
    possible = _possible(linted)
    is_mixed = {1, 2} <= {result.ros for _, result in linted}
    naming = {package_around(os.path.dirname(path)) for path in scratch.files() if _names_files(scratch, path)}
    found = {}
    for folder, distros in possible.items():
        first = distros[0]
        if options.source and generation(options.source) == generation(first):
            first = options.source
        elif generation(first) == generation("rolling"):
            first = _likely(options.target, distros, is_there=is_mixed, has_files=folder in naming)
        found[folder] = first
    known = [options.source] if options.source else sorted(found.values(), key=ALL.index)
    return Origins(found, next(iter(known), None))


def check_direction(target: str, found: Origins) -> None:
    """Raise UserError if all packages come from a distro later than the target."""
    distros = set(found.packages.values())
    if distros and all(ALL.index(distro) > ALL.index(target) for distro in distros):
        first = min(distros, key=ALL.index)
        raise UserError(
            f"the packages are for {first} or later, and '{target}' is earlier; urdfctl migrates to later distros only"
            " (--from DISTRO says which distro they are for)"
        )


def _possible(linted: Sequence[tuple[Target, TargetResult]]) -> dict[str, tuple[str, ...]]:
    """The distros that each package may be for, in order, by the targets in it that say something."""
    found: dict[str, tuple[str, ...]] = {}
    for target, result in linted:
        folder = package_around(os.path.dirname(target.path)) or ""
        if 0 < len(result.distros) < len(ALL):
            known = found.get(folder, ())
            both = tuple(distro for distro in known if distro in result.distros)
            found[folder] = both or (min(known, result.distros, key=_first) if known else result.distros)
    return found


def _first(distros: Sequence[str]) -> int:
    return ALL.index(distros[0])


def _likely(target: str, distros: Sequence[str], *, is_there: bool, has_files: bool) -> str:
    """The distro that a package of ROS 2 comes from: the first that it may be for, or a later one by these signs."""
    if has_files and _SINCE_FILES in distros:
        distros = [distro for distro in distros if ROS2.index(distro) >= ROS2.index(_SINCE_FILES)]
    return target if is_there and target in distros else distros[0]


def _names_files(scratch: Scratch, path: str) -> bool:
    """Whether a launch file has a spawner that names the file of its controllers."""
    return is_launch(path) and _FILE_OPTION in scratch.content(path)
