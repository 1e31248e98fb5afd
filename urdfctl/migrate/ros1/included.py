"""Arguments of included launch files: those of ROS 1 are a file's own, those of ROS 2 are seen by, and set for, all others.

In launch of ROS 2 an included file sees the arguments of the file around it, and whatever it is given or declares stays
set afterwards, unless a group is around it (launch actions/group_action.py: scoped).
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.migrate.edits.markup import attribute, elements, root_of
from urdfctl.migrate.launch.actions import Action, Text, parsed, words_of
from urdfctl.migrate.launch.expressions import Used, parts_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.classic_programs import SERVERS, programs_of
from urdfctl.migrate.ros1.described import description_names, is_description
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.left_over import addressed_files, named_files
from urdfctl.migrate.ros1.roslaunch_values import around
from urdfctl.migrate.ros1.set_descriptions import is_overridden
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_MOST_DEPTH = 8
_WORLDS = re.compile(r"\$\(find gazebo_(ros|worlds)\)/launch/")


class IncludedFile(NamedTuple):
    """A launch file that another one includes.

    arguments: its arguments with the texts of their defaults; None for one without.
    sets: the names that are set when it has run: its own, and those of the files that it includes.
    starts: whether it starts a simulator, or a file does that it includes.
    spawns: whether it starts controllers, or a file does that it includes.
    describes: the descriptions that it sets whatever its arguments are, or a file does that it includes.
    """

    arguments: Mapping[str, str | None]
    sets: frozenset[str]
    starts: bool = False
    spawns: bool = False
    describes: frozenset[str] = frozenset()


def included_file(packages: MigratedPackages, written: str, folder: str, depth: int = 0) -> IncludedFile:
    """Return what an address of ROS 1 means: nothing for a launch file of other packages.

    folder: that of the file that includes it.
    """
    known = packages.found(_included_files)
    key = written, folder, depth
    if key not in known:
        known[key] = _included_file(packages, written, folder, depth)
    return known[key]


def _included_files(_: MigratedPackages) -> dict[tuple[str, str, int], IncludedFile]:
    """The included files that were read: many files include the same ones, and these others."""
    return {}


def _included_file(packages: MigratedPackages, written: str, folder: str, depth: int) -> IncludedFile:
    arguments: dict[str, str | None] = {}
    sets: set[str] = set()
    starts = spawns = False
    describes: frozenset[str] = frozenset()
    local = os.path.normpath(written.replace("$(dirname)", folder))
    for path in sorted({local} & {*packages.files()} or addressed_files(packages, written, folder)):
        root = root_of(packages.read(path))
        if root is not None and root.tagName == "launch" and depth < _MOST_DEPTH:
            describes |= descriptions_in(packages, root, os.path.dirname(path), depth)
        for element in elements(root) if root is not None and root.tagName == "launch" else ():
            name = element.attrs.get("name", "")
            if element.tagName == "arg" and element.parentNode is not None and _is_of_file(element):
                sets.add(name)
                if "value" not in element.attrs:
                    arguments.setdefault(name, element.attrs.get("default"))
            elif element.tagName == "include" and depth < _MOST_DEPTH:
                inner = included_file(packages, element.attrs.get("file", ""), os.path.dirname(path), depth + 1)
                sets |= inner.sets | {one.attrs.get("name", "") for one in element.elements() if one.tagName == "arg"}
                starts |= inner.starts or _WORLDS.match(element.attrs.get("file", "")) is not None
                spawns |= inner.spawns
            elif element.tagName == "node":
                starts |= not programs_of(element).isdisjoint(SERVERS)
                spawns |= element.attrs.get("pkg") == "controller_manager"
    return IncludedFile(arguments, frozenset(sets), starts, spawns, describes)


def descriptions_in(
    packages: MigratedPackages, root: Element, folder: str, depth: int = 0, *, own: bool = True
) -> frozenset[str]:
    """Return the commands and files of the descriptions that a launch file sets in its own namespace, whatever its
    arguments are, itself or by files that it includes.

    own: whether those that it sets itself count.
    """
    found: set[str] = set()
    names = packages.found(description_names)
    for element in elements(root):
        if any({"if", "unless", "ns"} & one.attrs.keys() for one in (element, *around(element))):
            continue
        is_main = attribute(element, "name").rpartition("/")[2] == "robot_description" or len(names) == 1
        if is_main and is_description(element, names) and not is_overridden(element, names):
            found |= {said_by(element)} if own else set()
        elif element.tagName == "include":
            written = element.attrs.get("file", "")
            given = {one.attrs.get("name"): one.attrs.get("value") for one in element.elements()}
            if given.get("load_robot_description") == "true":  # so do the packages of MoveIt's Setup Assistant
                found.add(written)
            found |= included_file(packages, written, folder, depth + 1).describes
    return frozenset(found)


def said_by(description: Element) -> str:
    """Return the command or the file of a description."""
    return " ".join((description.attrs.get("command") or description.attrs["textfile"]).split())


def _is_of_file(argument: Element) -> bool:
    """Whether an <arg> is one of its file, and not the value that an include passes on."""
    return not (isinstance(argument.parentNode, Element) and argument.parentNode.tagName == "include")


def split_arguments(packages: MigratedPackages) -> dict[str, set[str]]:
    """Return the arguments to which launch files give several words when they include a file, by its path."""
    found: dict[str, set[str]] = {}
    for root in packages.found(launch_roots).values():
        every = list(elements(root))
        own = {
            one.attrs.get("name"): one.attrs.get("default", one.attrs.get("value", ""))
            for one in every
            if one.tagName == "arg"
        }
        for include in (one for one in every if one.tagName == "include"):
            given = [one for one in include.elements() if one.tagName == "arg"]
            texts = {one.attrs.get("name", ""): one.attrs.get("value", one.attrs.get("default", "")) for one in given}
            several = {name for name, text in texts.items() if len(words_of(parsed(_resolved(text, own)))) > 1}
            for path in named_files(packages, include) if several else ():
                found.setdefault(path, set()).update(several)
    return found


def _resolved(text: str, own: Mapping[str | None, str]) -> str:
    """A text with the argument that it is as a whole replaced by its default."""
    whole = re.fullmatch(r"\s*\$\(arg\s+([\w-]+)\)\s*", text)
    return own.get(whole[1], text) if whole is not None else text


def passed_on(
    element: Element, given: Mapping[str, Text], outer: Mapping[str, str], names: Mapping[str, str | None]
) -> Iterator[tuple[str, Text]]:
    """Yield the arguments that an include of ROS 2 must have besides those given.

    outer: the arguments of the file that includes another, with their defaults.
    names: the arguments of the included file, with their defaults.
    """
    passes_all = element.attrs.get("pass_all_args", "").strip().lower() in ("true", "1")
    for name, default in names.items():
        if name in given or name not in outer:
            continue
        if passes_all:
            yield name, parsed(f"$(arg {name})")
        elif default is not None and "$(arg" not in default and "$(eval" not in default:
            yield name, parsed(default)


def kept_apart(actions: Sequence[Action], included: Mapping[Text, IncludedFile]) -> list[Action]:
    """Return the actions with a group around each include that would set arguments of those after it.

    included: what is known of the included files, by their addresses in ROS 2.
    """
    found: list[Action] = []
    for index, action in enumerate(actions):
        inner = tuple(kept_apart(action.inner, included))
        one = action._replace(inner=inner)
        if _sets(action, included) & _read_by(actions[index + 1 :], included):
            condition = one.condition
            one = Action("group", inner=(one._replace(condition=None),), condition=condition)
        found.append(one)
    return found


def _sets(action: Action, included: Mapping[Text, IncludedFile]) -> frozenset[str]:
    """The arguments that an include sets to anything else than what they are."""
    if action.kind != "include":
        return frozenset()
    same = {name for name, text in action.pairs if text == parsed(f"$(arg {name})")}
    its = included.get(action.value or ())
    declared = its.sets if its is not None else frozenset()
    return frozenset({name for name, _ in action.pairs} | declared) - same


def _read_by(actions: Sequence[Action], included: Mapping[Text, IncludedFile]) -> frozenset[str]:
    """The arguments that actions read, which are set before them."""
    found: set[str] = set()
    for action in actions:
        texts = [action.value or (), action.node_name, *action.words, *action.files, action.description]
        texts += [text for _, text in (*action.pairs, *action.env)]
        texts += [text for pair in action.remaps for text in pair]
        texts += [action.condition.text] if action.condition is not None else []
        for part in (part for text in texts for part in text):
            if part.kind == "arg":
                found.add(part.text)
            elif part.kind == "eval":
                found |= {used.name for used in parts_of(part.text) if isinstance(used, Used) and used.kind == "arg"}
        its = included.get(action.value or ()) if action.kind == "include" else None
        if its is not None:
            found |= its.arguments.keys() - {name for name, _ in action.pairs}
        found |= _read_by(action.inner, included)
    return frozenset(found)
