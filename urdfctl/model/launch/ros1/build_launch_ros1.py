"""Build the model of a ROS 1 launch file (roslaunch XML), together with the files that it includes."""

from __future__ import annotations

import re
from collections import ChainMap
from collections.abc import Mapping, Sequence
from itertools import islice

from urdfctl.model.controllers import FileReference
from urdfctl.model.launch.launch import Launch
from urdfctl.model.launch.parts import (
    FILE_ENDINGS,
    Description,
    InlineParameters,
    LaunchedFile,
    Node,
    ParameterLoad,
    Rewriting,
    Simulation,
    Spawn,
    Word,
    joined,
)
from urdfctl.model.launch.ros1.elements import (
    declared_in,
    held_of,
    is_of_ros2,
    makes_urdf,
    not_declared,
    strays_of_world,
    undeclared_in,
    world_of,
)
from urdfctl.model.launch.ros1.forms import declared_twice, malformed
from urdfctl.model.launch.ros1.nodes import model_in, node_of, spawn_of
from urdfctl.model.launch.scope import Scope, Sources, Substitutions, is_of_environment
from urdfctl.model.launch.xacro_command import of_command, runs_xacro
from urdfctl.model.moveit import MoveItFiles
from urdfctl.names import is_slip
from urdfctl.source.opaque import OUTSIDE, UNKNOWN, if_known
from urdfctl.source.span import Place
from urdfctl.source.xml.dom import Element

_DESCRIPTION = "robot_description"
_SEMANTIC = "_semantic"
_MOST_DEPTH = 16
_MOST_INCLUDES = 200
_MOST_REPLACED = 200
_SIMULATOR_ALONE = ("gazebo_ros", "gazebo_worlds")
"""Packages whose launch files start a simulator, but no controllers."""
_CONDITIONS = ("if", "unless")
_TEXTS = ("textfile", "binfile")
"""Attributes of a parameter whose value is the content of a file."""
_RESOLVED = frozenset("arg env group include machine node param remap rosparam test".split())
"""Elements whose attributes roslaunch resolves."""
_SERVERS = ("gazebo", "gzserver", "debug", "gdbrun", "perf")
"""The programs of gazebo_ros that are a simulator."""


def launch_of(path: str, arguments: Mapping[str, str], sources: Sources) -> Launch | None:
    """Return the model of a ROS 1 launch file that is started with these arguments; None if it is not such a file."""
    document = sources.read(path)
    root = document.documentElement if document else None
    if root is None or root.tagName != "launch" or is_of_ros2(root):
        return None
    builder = _LaunchBuilder(sources)
    declared = declared_in(root).union(arguments)
    builder.file(root, Scope(path, "", ChainMap(dict(arguments)), sure=True, declared=declared))
    return Launch(
        path,
        1,
        tuple(builder.descriptions or builder.others),
        tuple(builder.loads),
        tuple(builder.spawns),
        complete=not builder.unread,
        elsewhere=tuple(builder.elsewhere),
        nodes=tuple(builder.nodes),
        simulations=tuple(builder.simulations),
        references=tuple(builder.references),
        packages=tuple(builder.packages),
        strays=tuple(builder.strays),
        slips=tuple(dict.fromkeys(builder.slips)),
        undeclared=tuple(dict.fromkeys(builder.undeclared)),
        arguments=tuple(builder.arguments.items()),
        inline=tuple(builder.inline),
        moveit=tuple(_with_loads(files, builder.loads) for files in builder.moveit),
        unread=tuple(builder.unread),
        absent=tuple(builder.unread),
        named=tuple(dict.fromkeys(builder.named)),
        misnamed=tuple(builder.misnamed),
        skipped=tuple(dict.fromkeys(builder.skipped)),
    )


def _with_loads(files: MoveItFiles, loads: Sequence[ParameterLoad]) -> MoveItFiles:
    """The files for MoveIt with the YAML files that are loaded for the same robot."""

    def last(ending: str) -> FileReference | None:
        name = f"{files.namespace or ''}/{_DESCRIPTION}{ending}"
        return next((load.file for load in reversed(loads) if load.sure and load.namespace == name), None)

    known = tuple(load.file for load in loads if load.sure and load.file.path)
    return files._replace(kinematics=last("_kinematics"), limits=last("_planning"), controllers=known)


class _LaunchBuilder:
    def __init__(self, sources: Sources) -> None:
        self.sources = sources
        self.descriptions: list[Description] = []
        self.others: list[Description] = []
        """Descriptions with a name other than robot_description; used only if nothing has that name."""
        self.loads: list[ParameterLoad] = []
        self.spawns: list[Spawn] = []
        self.elsewhere: list[Spawn] = []
        self.nodes: list[Node] = []
        self.simulations: list[Simulation] = []
        self.references: list[LaunchedFile] = []
        self.packages: list[Word] = []
        self.strays: list[Word] = []
        self.slips: list[tuple[Word, str]] = []
        self.undeclared: list[Word] = []
        self.moveit: list[MoveItFiles] = []
        self.arguments: dict[str, str | None] = {}
        self.inline: list[InlineParameters] = []
        self.named: list[str] = []
        self.misnamed: list[Word] = []
        self.skipped: list[str] = []
        self.unread: list[Word] = []
        """The included files that cannot be read."""
        self._includes = 0
        self._remapped = False
        self._of_environment: set[str] = set()

    def file(self, root: Element, scope: Scope) -> None:
        """Follow a launch file, or one that is included."""
        for mistake in declared_twice(root) if scope.sure else ():
            self.sources.malformed(mistake)
        self.walk(root, scope)

    def walk(self, parent: Element, scope: Scope) -> None:
        for element in parent.elements():
            texts = self._texts(scope, element)
            held = held_of(element, texts)
            inner = scope._replace(sure=scope.sure and held is True, held=scope.held and held is not False)
            if not inner.held:
                self.skipped.append(element.at.span.text)
            self._judge(element, scope, inner)
            self._packages(element)
            namespace = texts.resolve(element.attrs.get("ns", "")).strip()
            if element.tagName == "arg":
                if held is not False:
                    self._argument(element, inner, texts)
            elif element.tagName == "group":
                own = inner.arguments.new_child()
                self.walk(element, inner._replace(namespace=inner.joined(namespace), arguments=own))
            elif element.tagName == "include":
                self._include(element, inner._replace(namespace=inner.joined(namespace)), texts)
            elif element.tagName == "node":
                self._node(element, inner._replace(namespace=inner.joined(namespace)), texts)
            elif element.tagName == "param" and inner.held:
                self._param(element, inner, texts)
            elif element.tagName == "rosparam" and inner.held:
                self._rosparam(element, inner, texts)
            elif element.tagName == "remap" and not inner.in_node:
                self._remapped = True

    def _judge(self, element: Element, scope: Scope, inner: Scope) -> None:
        """Tell what roslaunch does not take of an element. Add the arguments that it uses and that nothing declares:
        those of conditions are always used."""
        for mistake in malformed(element) if inner.sure else ():
            self.sources.malformed(mistake)
        if element.tagName not in _RESOLVED:
            return
        conditions = [name for name in element.attrs if name in _CONDITIONS]
        others = [name for name in element.attrs if name not in (*_CONDITIONS, "doc")]
        used = (conditions if scope.sure else []) + (others if inner.sure else [])
        self.undeclared += undeclared_in(element, scope.declared, used)
        for child in element.elements() if element.tagName == "include" and inner.sure else ():
            self._judge(child, inner, inner)

    def _packages(self, element: Element) -> None:
        for name, value in element.attrs.items():
            for package in re.findall(r"\$\(find\s+([^\s()$]+)\s*\)", value):
                self.packages.append(Word(package, element.at[name]))

    def _texts(self, scope: Scope, element: Element) -> Substitutions:
        sources = self.sources

        def too_long() -> None:
            sources.too_long(element.at)

        return Substitutions(scope.file, scope.arguments, sources.find, sources.environ, too_long)

    # -- elements ----------------------------------------------------------------------------------------------------

    def _argument(self, element: Element, scope: Scope, texts: Substitutions) -> None:
        name = element.attrs.get("name", "")
        if scope.depth == 0 and not scope.in_node and "value" not in element.attrs:
            self.arguments.setdefault(name, element.attrs.get("default"))
        given = element.attrs.get("value")
        if given is None and name in scope.arguments:
            return
        text = given if given is not None else element.attrs.get("default")
        if text is not None and is_of_environment(text, self._of_environment):
            self._of_environment.add(name)
        value = UNKNOWN if text is None or not scope.sure else texts.resolve(text)
        scope.arguments[name] = value if value or given is not None else self.sources.blank()

    def _include(self, element: Element, scope: Scope, texts: Substitutions) -> None:
        written = element.attrs.get("file", "")
        path = texts.resolve(written)
        for child in element.elements() if scope.held else ():
            if child.tagName == "arg":
                self._named_file(child, scope, texts)
        if any(f"$(find {package})" in written for package in _SIMULATOR_ALONE):
            simulation = world_of(element, texts, sure=scope.sure) if scope.held else None
            self.simulations += [simulation] if simulation else []
            self.strays += strays_of_world(element) if scope.sure else ()
            return
        self._includes += 1
        passes_all = element.attrs.get("pass_all_args", "").lower() in ("true", "1")
        arguments = dict(scope.arguments) if passes_all else {}
        for child in element.elements():
            if child.tagName == "arg" and held_of(child, texts) is not False:
                text = child.attrs.get("value", child.attrs.get("default"))
                sure = held_of(child, texts) is True
                arguments[child.attrs.get("name", "")] = texts.resolve(text) if text is not None and sure else UNKNOWN
        document = None
        if UNKNOWN not in path and scope.depth < _MOST_DEPTH and self._includes <= _MOST_INCLUDES:
            document = self.sources.read(path)
        if scope.held:
            self._reference(written, element.at["file"], if_known(path), "include", sure=scope.sure)
        if document is None or document.documentElement is None:
            if scope.held:
                self.unread.append(Word(path, element.at["file"]))
            return
        declared = declared_in(document.documentElement)
        if scope.held:
            strays, slips = not_declared(element, declared, passes_all=passes_all)
            self.strays += strays
            self.slips += slips
        inner = Scope(
            path,
            scope.namespace,
            ChainMap(arguments),
            scope.sure,
            scope.depth + 1,
            held=scope.held,
            declared=declared.union(arguments),
        )
        self.file(document.documentElement, inner)

    def _param(self, element: Element, scope: Scope, texts: Substitutions) -> None:
        name = joined(scope.namespace, texts.resolve(element.attrs.get("name", "")))
        self.named.append(name)
        last = name.rpartition("/")[2]
        if last.endswith(_SEMANTIC):
            self._semantic(element, name, scope, texts)
            return
        if last != _DESCRIPTION and not ("_description" in last and makes_urdf(element)):
            self._named_file(element, scope, texts)
            if makes_urdf(element) and is_slip(last, _DESCRIPTION) and scope.sure:
                self.misnamed.append(Word(last, element.at["name"]))
            if "value" in element.attrs:
                self._contained(name, element.at["value"], scope)
            return
        path: str | None = None
        arguments: tuple[tuple[str, str], ...] | None = ()
        source = "command" if "command" in element.attrs else "textfile"
        written = re.sub(r"\$\(find xacro\)", "xacro", element.attrs.get(source, ""))
        resolved = texts.resolve(written)
        if source == "command":
            path, arguments = of_command(resolved)
        elif written:
            path = if_known(resolved)
        text = written if path else resolved  # which says in what package it is
        reference = self._reference(text, element.at[source], path, "description", sure=scope.sure)
        at = element.at[source]
        named = re.findall(r"((?<!\w)(\w+):=\S*)", written)
        places = at.words(word for word, _ in named)
        names = tuple(Word(name, place) for (_, name), place in zip(named, places, strict=True))
        namespace = if_known(name.rpartition("/")[0])
        description = Description(
            file=reference,
            arguments=arguments,
            namespace=namespace,
            at=element.at,
            sure=scope.sure,
            names=names,
            command=written,
            in_node=scope.in_node,
            by_xacro=source == "command" and runs_xacro(resolved),
        )
        (self.descriptions if last == _DESCRIPTION else self.others).append(description)

    def _named_file(self, element: Element, scope: Scope, texts: Substitutions) -> None:
        """Add the file that an argument or a parameter names, or whose text is the parameter's value."""
        path = texts.resolve(element.attrs.get("value", ""))
        if path.endswith(FILE_ENDINGS):
            self._reference(element.attrs["value"], element.at["value"], if_known(path), "argument", sure=scope.sure)
        for source in _TEXTS if element.tagName == "param" else ():
            if written := element.attrs.get(source):
                self._reference(written, element.at[source], if_known(texts.resolve(written)), "text", sure=scope.sure)

    def _semantic(self, element: Element, name: str, scope: Scope, texts: Substitutions) -> None:
        """Add an SRDF that is set on the parameter server."""
        source = "command" if "command" in element.attrs else "textfile"
        written = re.sub(r"\$\(find xacro\)", "xacro", element.attrs.get(source, ""))
        text = texts.resolve(written)
        path, arguments = of_command(text) if source == "command" else (if_known(text), ())
        reference = self._reference(written, element.at[source], path, "argument", sure=scope.sure)
        namespace = if_known(name.rpartition("/")[0])
        files = MoveItFiles(element.at, reference, arguments, namespace=namespace, sure=scope.sure)
        self.moveit.append(files)

    def _rosparam(self, element: Element, scope: Scope, texts: Substitutions) -> None:
        if element.attrs.get("command", "load") != "load":
            return
        below = "/".join(texts.resolve(element.attrs[name]) for name in ("ns", "param") if element.attrs.get(name))
        namespace = joined(scope.namespace, below)
        self.named.append(namespace)
        if "file" not in element.attrs:
            if element.at.content.start != element.at.start and element.attrs.get("param"):
                self._contained(namespace, element.at.content, scope)
            elif element.at.content.start != element.at.start and not scope.in_node and UNKNOWN not in namespace:
                self.inline.append(InlineParameters(namespace, "", element.at.content, scope.sure))
            return
        self._load(element.attrs["file"], element.at["file"], namespace, scope, texts)
        if texts.truth(element.attrs.get("subst_value", "")):
            known = (pair for pair in scope.arguments.items() if if_known(pair[1]) is not None)
            replaced = tuple((f"$(arg {name})", value) for name, value in islice(known, _MOST_REPLACED))
            self.loads[-1] = self.loads[-1]._replace(rewriting=Rewriting(texts=replaced))
        if texts.truth(element.attrs.get("subst_value", "false")) is not False:
            self.loads[-1] = self.loads[-1]._replace(substituted=True)

    def _contained(self, name: str, at: Place, scope: Scope) -> None:
        """Add a parameter with its value. Those of a node are private to it."""
        namespace, _, last = name.rpartition("/")
        if not scope.in_node and last and UNKNOWN not in name and "$(" not in at.span.text:
            self.inline.append(InlineParameters(namespace, last, at, scope.sure))

    def _load(self, written: str, at: Place, namespace: str, scope: Scope, texts: Substitutions) -> None:
        path = texts.resolve(written)
        reference = self._reference(written, at, if_known(path), "parameters", sure=scope.sure)
        if if_known(path) is None and not re.search(OUTSIDE, path):
            reference = reference._replace(text=path)  # the package is here, whatever the file is
        self.loads.append(ParameterLoad(reference, if_known(namespace), at, scope.sure, scope.in_node))

    def _reference(self, written: str, at: Place, path: str | None, use: str, *, sure: bool) -> FileReference:
        located, exists = self.sources.locate(path) if path else (None, None)
        if path and not path.startswith("/"):
            exists = None  # depends on the folder that roslaunch is started in
        if not exists and is_of_environment(written, self._of_environment):
            exists = None
        reference = FileReference(written, at, located, exists)
        if located is not None:
            self.references.append(LaunchedFile(reference, use, None, sure))
        return reference

    def _node(self, element: Element, scope: Scope, texts: Substitutions) -> None:
        name = texts.resolve(element.attrs.get("name", ""))
        inside = scope._replace(namespace=scope.joined(name), arguments=scope.arguments.new_child(), in_node=True)
        self.walk(element, inside)
        words = texts.resolve(element.attrs.get("args", "")).split()
        if scope.held:
            self._started(element, name, words, scope, texts)
        spawned = spawn_of(element, words, scope)
        if spawned is None:
            return
        spawn, files = spawned
        (self.spawns if scope.held else self.elsewhere).append(spawn)
        for file in files if scope.held else ():
            self._load(file.text, file.at, "", scope, texts)

    def _started(self, element: Element, name: str, words: list[str], scope: Scope, texts: Substitutions) -> None:
        given = tuple(map(Word, words, element.at["args"].words(words)))
        node = node_of(element, name, given, scope, texts)
        for word in given:
            if word.text.endswith(FILE_ENDINGS):
                self._reference(word.text, word.at, word.known, "argument", sure=scope.sure)
        if node.runs("gazebo_ros", *_SERVERS):
            paused = any(word in ("-u", "--pause") for word in words)
            self.simulations.append(Simulation("gazebo-classic", element.at, paused, scope.sure))
        model = model_in(node)
        if model is not None:
            self._model(element, model, node.namespace, scope)
        self.nodes.append(node._replace(complete=node.complete and not self._remapped))

    def _model(self, element: Element, file: Word, namespace: str | None, scope: Scope) -> None:
        """Add the description of a model that a node puts into the simulator from a file."""
        reference = self._reference(file.text, file.at, file.known, "description", sure=scope.sure)
        command = None if file.known else f"cat {element.attrs['args']}"
        node = element.attrs["type"]
        description = Description(reference, (), namespace, file.at, scope.sure, command=command, node=node)
        self.descriptions.append(description)
