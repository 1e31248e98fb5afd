"""Where launch files of ROS 1 publish the robot description and its frames: namespaces, and what is remapped."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import pairwise

from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.launch.actions import Text, is_literal, literal, parsed, plain, words_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.left_over import named_files
from urdfctl.migrate.ros1.roslaunch_values import namespace_of
from urdfctl.source.xml.dom import Element

_DESCRIPTION = "robot_description"
_PUBLISHER = "robot_state_publisher"
_MOST_DEPTH = 8


def is_description(element: Element, names: Collection[str]) -> bool:
    """Return whether an element sets a robot description.

    names: the names of the parameters that are descriptions.
    """
    return sets_text(element) and attribute(element, "name").rpartition("/")[2] in names


def sets_text(element: Element) -> bool:
    """Return whether an element of a launch file sets a parameter to the text of a file, or to what a command prints."""
    return element.tagName == "param" and ("command" in element.attrs or "textfile" in element.attrs)


def description_names(packages: MigratedPackages) -> frozenset[str]:
    """Return the names of the parameters that launch files set to a robot description.

    Those are robot_description, and what a simulator or a publisher reads instead of it; all that are called so if
    nothing says which they read.
    """
    every = [one for root in packages.found(launch_roots).values() for one in elements(root)]
    last = {attribute(one, "name").rpartition("/")[2] for one in every if sets_text(one)}
    named = {name for name in last if name == _DESCRIPTION or name.endswith(f"_{_DESCRIPTION.partition('_')[2]}")}
    read = {_DESCRIPTION}
    for one in every:
        if one.tagName == "remap" and names_description(parsed(attribute(one, "from"))):
            read.add(attribute(one, "to").rpartition("/")[2])
        words = words_of(parsed(attribute(one, "args"))) if one.tagName == "node" else ()
        for option, value in pairwise(words):
            if plain(option) == "-param" and literal("-sdf") not in words:
                read |= {plain(value).rpartition("/")[2]} if is_literal(value) else named
    return frozenset(last & read if last & read - {_DESCRIPTION} or _DESCRIPTION in last else named)


def names_description(old: Text) -> bool:
    """Return whether a remapping is of the description: a parameter in ROS 1, and the topic of all in ROS 2."""
    return plain(old).rpartition("/")[2] == "robot_description"


def idle_publishers(packages: MigratedPackages) -> dict[str, Element]:
    """Return the only robot_state_publisher of launch files that set no description, for each launch file: the one of
    the files that are started with it, or of all without any; none if several differ."""
    names, roots = packages.found(description_names), packages.found(launch_roots)
    idle: dict[str, list[Element]] = {}
    for path, root in roots.items():
        every = list(elements(root))
        if not any(is_description(element, names) for element in every):
            idle[path] = [one for one in every if _is_publisher(one)]
    found: dict[str, Element] = {}
    for path, group in packages.found(_started_together).items():
        own = [one for other in sorted(group) for one in idle.get(other, ())]
        kinds = {_said(one): one for one in own or (one for each in idle.values() for one in each)}
        if len(kinds) == 1:
            found[path] = next(iter(kinds.values()))
    return found


def _is_publisher(element: Element) -> bool:
    return element.tagName == "node" and attribute(element, "pkg") == _PUBLISHER


def _said(node: Element) -> str:
    """What distinguishes a publisher from others."""
    inner = (f"{one.tagName} {sorted(one.attrs.items())}" for one in node.elements())
    return f"{namespace_of(node)}|{'|'.join(inner)}"


def spaces_of_description(packages: MigratedPackages) -> frozenset[str]:
    """Return the namespaces, without the slash before, in which launch files publish the robot description.

    They are as written, with arguments. They are those of robot_state_publisher; without one, those of the parameter.
    """
    return frozenset(space for spaces in packages.found(_published).values() for space in spaces)


def spaces_by_file(packages: MigratedPackages) -> dict[str, frozenset[str]]:
    """Return those namespaces for each launch file: of the files that are started with it, or of all without any."""
    published, every = packages.found(_published), packages.found(spaces_of_description)
    found = {}
    for path, group in packages.found(_started_together).items():
        found[path] = frozenset(space for one in group for space in published.get(one, ())) or every
    return found


def spaces_of_robots(packages: MigratedPackages, robots: Iterable[LoadedTarget]) -> frozenset[str]:
    """Return those namespaces for the launch files of some robots; for all, if none starts them."""
    by_file = packages.found(spaces_by_file)
    found = (by_file[path] for one in robots for path in one.sources if path in by_file)
    return frozenset(space for spaces in found for space in spaces) or packages.found(spaces_of_description)


def _started_together(packages: MigratedPackages) -> dict[str, set[str]]:
    """The launch files that are started with each one: that it includes, that include it, and so on."""
    joined: dict[str, set[str]] = {path: {path} for path in packages.found(launch_roots)}
    for path, parents in packages.found(_including).items():
        for parent, _ in parents:
            both = joined[path] | joined[parent]
            joined.update(dict.fromkeys(both, both))
    return joined


def _published(packages: MigratedPackages) -> dict[str, set[str]]:
    """The namespaces in which a launch file publishes the description, by its path: those of its publishers, or of the
    parameter where no publisher is started with it.

    A publisher in a file without a description is started in the files that set one.
    """
    roots, names = packages.found(launch_roots), packages.found(description_names)
    contexts = _contexts(packages, roots)
    set_in = {path: [one for one in elements(root) if is_description(one, names)] for path, root in roots.items()}
    together, idle = packages.found(_started_together), packages.found(idle_publishers)
    staying = [path for path in roots if set_in[path] or not any(set_in[other] for other in together[path])]
    nodes = [(path, one) for path in staying for one in elements(roots[path]) if _is_publisher(one)]
    publishing = {path for path, _ in nodes}
    parameters = [(path, one) for path in roots if not together[path] & publishing for one in set_in[path]]
    found: dict[str, set[str]] = {}
    for path, one in (*nodes, *parameters):
        moved = idle.get(path) if one.tagName != "node" else None
        own = namespace_of(moved) if moved is not None else ""
        spaces = {"/".join(part for part in (space, _own_space(one)) if part) for space in contexts[path]}
        found.setdefault(path, set()).update({own} if own else spaces)
    return found


def described_for(spaces: Collection[str], own: str) -> str:
    """Return the namespace of the description for a node: its own one, the only one, or the root among several.

    spaces: those in which the description is published.
    """
    if own in spaces or not spaces:
        return own
    if len(spaces) == 1:
        return next(iter(spaces))
    return "" if "" in spaces and "$(" not in own else own


def _own_space(element: Element) -> str:
    space = namespace_of(element)
    return space if element.tagName == "node" else space.rpartition("/")[0]


def _contexts(packages: MigratedPackages, roots: dict[str, Element]) -> dict[str, set[str]]:
    """The namespaces in which each launch file is included; that of the root for one that no other includes."""
    including = packages.found(_including)
    return {path: set(_spaces(path, including, ())) or {""} for path in roots}


def _including(packages: MigratedPackages) -> dict[str, list[tuple[str, str]]]:
    """The launch files that include each launch file, with the namespaces in which they do."""
    roots = packages.found(launch_roots)
    including: dict[str, list[tuple[str, str]]] = {path: [] for path in roots}
    for path, root in roots.items():
        for one in elements(root):
            if one.tagName == "include":
                for file in named_files(packages, one) & roots.keys():
                    including[file].append((path, namespace_of(one)))
    return including


def _spaces(path: str, including: dict[str, list[tuple[str, str]]], seen: tuple[str, ...]) -> Iterator[str]:
    if not including[path]:
        yield ""
    for parent, space in including[path]:
        if parent not in seen and len(seen) < _MOST_DEPTH:
            for above in _spaces(parent, including, (*seen, path)):
                yield "/".join(part for part in (above, space) if part)
