"""The nodes of a roslaunch file: what they are given, and the controllers that those which spawn load."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from urdfctl.model.launch.abbreviations import whole_option
from urdfctl.model.launch.parts import Node, ProgramOption, Spawn, Word
from urdfctl.model.launch.scope import Scope, Substitutions
from urdfctl.source.opaque import UNKNOWN, if_known
from urdfctl.source.span import Place
from urdfctl.source.xml.dom import Element

SPAWNER_OPTIONS_WITH_VALUE = ("--namespace", "--timeout", "--wait-for", "--shutdown-timeout")
SPAWNER_OPTIONS = (*SPAWNER_OPTIONS_WITH_VALUE, "--stopped", "--no-timeout", "--help")
_VERBS = {"spawn": True, "load": False, "start": True}
"""The verbs of the program `controller_manager` that load controllers, and whether they start them."""


def node_of(element: Element, name: str, words: Sequence[Word], scope: Scope, texts: Substitutions) -> Node:
    """Return the node that an element starts.

    name: its own, without namespace. words: its arguments.
    """
    children = list(element.elements())
    parameters = [Word(child.attrs["name"], child.at["name"]) for child in children if "name" in child.attrs]
    parameters += [Word(child.attrs["param"], child.at["param"]) for child in children if "param" in child.attrs]
    remaps = tuple(
        (texts.resolve(child.attrs.get("from", "")), texts.resolve(child.attrs.get("to", "")))
        for child in children
        if child.tagName == "remap"
    )
    return Node(
        package=Word(element.attrs.get("pkg", ""), element.at["pkg"]),
        executable=Word(element.attrs.get("type", ""), element.at["type"]),
        name=if_known(name),
        namespace=if_known(scope.namespace),
        at=element.at,
        words=tuple(words),
        parameters=tuple(parameters),
        remaps=remaps,
        sure=scope.sure,
        complete=not any(child.tagName == "rosparam" and "param" not in child.attrs for child in children),
    )


def spawn_of(element: Element, words: Sequence[str], scope: Scope) -> tuple[Spawn, list[Word]] | None:
    """Return the controllers that a node loads, and the parameter files among its arguments; None if it loads none."""
    kind = element.attrs.get("type", "")
    if element.attrs.get("pkg") != "controller_manager" or kind not in ("spawner", "controller_manager"):
        return None
    at = element.at["args"]
    given = zip(words, at.words(words), strict=True)
    active = True
    if kind == "controller_manager":
        verb = next(given, ("", at))[0]
        if verb not in _VERBS:
            return None
        active = _VERBS[verb]
    spawn = Spawn((), if_known(scope.namespace), at, active, scope.sure)
    return _with_arguments(spawn._replace(program=Word(kind, element.at["type"])), given, scope)


def _with_arguments(spawn: Spawn, words: Iterator[tuple[str, Place]], scope: Scope) -> tuple[Spawn, list[Word]]:
    """Add the controllers and options of a command line; the parameter files in it are returned besides."""
    names: list[tuple[str, Place]] = []
    options: list[ProgramOption] = []
    files: list[Word] = []
    for word, place in words:
        written, mark, value = word.partition("=")
        option = whole_option(written, SPAWNER_OPTIONS)
        if option in SPAWNER_OPTIONS_WITH_VALUE:
            value, of_value = (value, place) if mark else next(words, ("", spawn.at))
            if option == "--namespace":
                spawn = spawn._replace(namespace=if_known(scope.joined(value)))
            options.append(ProgramOption(option, Word(value, of_value), place))
        elif word.startswith("--"):
            spawn = spawn._replace(active=spawn.active and option != "--stopped")
            options.append(ProgramOption(option, None, place))
        elif UNKNOWN in word:
            spawn = spawn._replace(complete=False)
        elif word.endswith((".yaml", ".yml")):
            files.append(Word(word, place))
        elif not word.startswith("-"):
            names.append((word, place))
    complete = spawn.complete and not files
    return spawn._replace(names=tuple(names), options=tuple(options), complete=complete), files


def model_in(node: Node) -> Word | None:
    """Return the URDF file that a node puts into the simulator; None if it takes its model from elsewhere.

    gazebo_ros (noetic), scripts/spawn_model: -file is the path of the model, and -urdf says what is in it.
    """
    words = [word.text for word in node.words]
    if not node.runs("gazebo_ros", "spawn_model") or "-urdf" not in words:
        return None
    files = [word for before, word in pairwise(node.words) if before.text == "-file"]
    return files[0] if len(files) == 1 and files[0].text.endswith(".urdf") else None
