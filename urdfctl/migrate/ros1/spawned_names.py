"""Names of controllers below a namespace of their own: ROS 2's manager has all of its controllers in its namespace."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.roslaunch_values import namespace_of
from urdfctl.model.launch.abbreviations import whole_option
from urdfctl.model.launch.ros1.nodes import SPAWNER_OPTIONS, SPAWNER_OPTIONS_WITH_VALUE
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class SpawnedName(NamedTuple):
    """A controller that is spawned by a name with slashes: the namespace of its manager, and its name there."""

    manager: str
    name: str


def spawned_names(packages: MigratedPackages) -> dict[str, SpawnedName]:
    """Return the controllers that launch files of ROS 1 spawn by a name with slashes, by their full names."""
    spawned: dict[str, tuple[str, str]] = {}
    plain: set[str] = set()
    for root in packages.found(launch_roots).values():
        for node in elements(root):
            for word in _words(node):
                manager, full = namespace_of(node), full_name(node, word)
                inside = full.removeprefix(f"{manager}/") if manager else full
                if "/" in word:
                    spawned[full] = manager, inside
                else:
                    plain.add(word)
    lasts = Counter(inside.rpartition("/")[2] for _, inside in spawned.values())
    lasts.update(plain)
    return {
        full: SpawnedName(manager, last if lasts[last := inside.rpartition("/")[2]] == 1 else inside.replace("/", "_"))
        for full, (manager, inside) in spawned.items()
    }


def full_name(spawner: Element, word: str) -> str:
    """Return the full name of a controller that a spawner names, without the slash before."""
    space = "" if word.startswith("/") else namespace_of(spawner)
    return "/".join(part for part in (space, word.strip("/")) if part)


def _words(node: Element) -> Iterator[str]:
    """The names in the arguments of a spawner that are known."""
    is_spawner = attribute(node, "pkg") == "controller_manager" and attribute(node, "type") == "spawner"
    words = iter(attribute(node, "args").split() if node.tagName == "node" and is_spawner else ())
    for word in words:
        if whole_option(word, SPAWNER_OPTIONS) in SPAWNER_OPTIONS_WITH_VALUE:
            next(words, None)
        elif not word.startswith(("-", "_")) and "$(" not in word and ":=" not in word:
            yield word
