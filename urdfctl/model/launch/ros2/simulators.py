"""The simulators that ROS 2 launch files start, by including a launch file of their packages or by a command."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence

from urdfctl.model.launch import Node, Simulation, Word
from urdfctl.model.launch.parts import WEBOTS
from urdfctl.model.launch.ros2.texts import Texts
from urdfctl.source.launch.terms import Called, Constant, Items, Member, Table, Term
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

WEBOTS_DRIVER = "webots_ros2_driver"
"""The package of Webots' driver, which may have the controller manager; its robot_description is the path of a file."""
COMPONENTS = {
    "GzServer": ("ros_gz_sim", "gzserver"),
    "RosGzBridge": ("ros_gz_bridge", "bridge_node"),
    "WebotsController": (WEBOTS_DRIVER, "driver"),
    "Ros2SupervisorLauncher": (WEBOTS_DRIVER, "ros2_supervisor.py"),
    "WebotsLauncher": WEBOTS,
}
"""Actions of ros_gz and Webots that start a node, or Webots itself, with its package and program."""
_AS_A_NODE = ("namespace", "parameters", "remappings")
"""What webots_ros2_driver's webots_controller.py WebotsController takes as a node does."""
_SERVERS = ("gz_server.launch", "gzserver.launch", "ros_gz_sim.launch")
"""How the launch files of ros_gz_sim begin that start the server alone, which is never paused (gzserver.cpp)."""
_SPAWNING = ("gz_spawn_model.launch", "ros_gz_spawn_model.launch")
_BRIDGING = ("ros_gz_sim.launch", "ros_gz_spawn_model.launch")
_OF_MODEL = {"entity_name": "name", "topic": "topic", "file": "file", "allow_renaming": "allow_renaming"}
"""The arguments of the launch files that spawn a model, with the parameters of `create`."""
_SIMULATORS = {"ros_gz_sim": "gz", "ros_ign_gazebo": "gz", "ros_gz": "gz", "gazebo_ros": "gazebo-classic"}


def package_outside(path: str) -> str | None:
    """Return the package that contains a path, if it is not among the sources; None otherwise."""
    match = re.match(rf"{UNKNOWN}\(([^)]*)\)", path)
    return match.group(1) if match else None


def simulator_of(path: str) -> str | None:
    """Return the simulator in whose package a launch file lies, also by the name of a folder; None if in none."""
    outside = package_outside(path)
    packages = [outside] if outside else reversed(path.split("/"))
    return next((_SIMULATORS[package] for package in packages if package in _SIMULATORS), None)


def included_simulation(path: str, given: Table | None, texts: Texts, at: Place, *, sure: bool) -> Simulation | None:
    """Return what the launch file of a simulator's package starts with some arguments; None if it starts nothing."""
    file, simulator = os.path.basename(path), simulator_of(path)
    if simulator is None or not any(word in file for word in ("sim", "gazebo", "gzserver", "gz_server")):
        return None
    if simulator == "gz" and file.startswith(_SERVERS):
        return Simulation("gz", at, paused=False, sure=sure)
    entries = given.entries if given else {}
    if simulator != "gz":
        paused = texts.truth(entries["pause"]) if "pause" in entries else False
        return Simulation(simulator, at, paused, sure)
    arguments = texts.of(entries.get("gz_args") or entries.get("ign_args") or Constant("", at))
    is_open = given is not None and not given.whole
    return _gz(arguments, at, sure=sure, is_open=is_open)


def included_nodes(
    path: str, given: Table | None, texts: Texts, at: Place, namespace: str | None, *, sure: bool
) -> Iterator[Node]:
    """Yield the nodes that a launch file of ros_gz_sim starts besides the simulator: a spawner of models, a bridge."""
    file = os.path.basename(path)
    entries = given.entries if given else {}
    values = {name: texts.of(value) for name, value in entries.items()}
    started = []
    if file.startswith(_SPAWNING):
        model = {parameter: values[name] for name, parameter in _OF_MODEL.items() if values.get(name)}
        started.append(("ros_gz_sim", "create", model))
    if file.startswith(_BRIDGING):
        started.append(("ros_gz_bridge", "bridge_node", {"config_file": values.get("config_file", UNKNOWN)}))
    for package, program, parameters in started if simulator_of(path) == "gz" else ():
        names = tuple(Word(name, at) for name in parameters)
        yield Node(
            package=Word(package, at),
            executable=Word(program, at),
            name=None,
            namespace=namespace,
            at=at,
            parameters=names,
            sure=sure,
            complete=given is None or given.whole,
            values=tuple(parameters.items()),
        )


def node_simulation(node: Node) -> Simulation | None:
    """Return what a node starts that is a simulator; None if it is none."""
    return Simulation("gz", node.at, paused=False, sure=node.sure) if node.runs("ros_gz_sim", "gzserver") else None


def commanded_simulation(words: Sequence[str], at: Place, *, sure: bool) -> Simulation | None:
    """Return what a command line starts; None if it is not that of a simulator."""
    if words[:2] in (["gz", "sim"], ["ign", "gazebo"]):
        return _gz(" ".join(words[2:]), at, sure=sure)
    if words[:2] == ["ros2", "launch"] and simulator_of("/".join(words[2:3])) == "gz":
        given = (word.partition(":=") for word in words[3:])
        return _gz(next((value for name, _, value in given if name in {"gz_args", "ign_args"}), ""), at, sure=sure)
    if words[0] in {"gazebo", "gzserver"}:
        return Simulation("gazebo-classic", at, any(word in {"-u", "--pause"} for word in words), sure)
    return None


def _gz(arguments: str, at: Place, *, sure: bool, is_open: bool = False) -> Simulation | None:
    """What gz does with arguments; nothing if it starts its window alone, by `-g`.

    It starts paused without `-r`; that is not known if the arguments are not, or are open to more.
    """
    if "-g" in arguments.split():
        return None
    runs = any(re.fullmatch(r"-[a-zA-Z]*r\w*", word) for word in arguments.split())
    is_unknown = UNKNOWN in arguments or is_open
    paused = False if runs else None if is_unknown else True
    return Simulation("gz", at, paused, sure)


def supervisor_of(term: Term | None) -> Called | None:
    """Return the action with which a WebotsLauncher starts what spawns models and publishes /clock; None for others.

    webots_launcher.py WebotsLauncher: `_supervisor` is a Ros2SupervisorLauncher; ros2_supervisor.py publishes Clock.
    """
    if isinstance(term, Member) and isinstance(term.of, Called) and term.of.short == "WebotsLauncher":
        return Called("Ros2SupervisorLauncher", term.at, (), {})
    return None


def node_of_component(term: Called) -> Called:
    """Return the node that an action starts: gz's server, which is never paused, a bridge, or Webots' driver."""
    package, program = COMPONENTS[term.short]
    keywords: dict[str, Term] = {name: term.keywords[name] for name in _AS_A_NODE if name in term.keywords}
    file = term.given("config_file")
    if file is not None:
        table = Table(term.at)
        table.put(Constant("config_file", term.at), file)
        keywords["parameters"] = Items([table], term.at)
    words = {"package": Constant(package, term.at), "executable": Constant(program, term.at)}
    return Called("Node", term.at, (), {**keywords, **words})
