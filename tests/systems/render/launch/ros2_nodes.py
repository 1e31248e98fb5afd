"""What is started of a robot in ROS 2: its state publisher, its manager, its spawners, and a simulator."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from systems.possible import Idioms
from systems.render.actions import Action, Execute, Group, Include, Node, Param, ParamFile, Value, When
from systems.render.arguments import Values
from systems.render.description import CHOICE, both
from systems.render.launch.ros2_spawners import first_label, spawners
from systems.render.parameters import types_of
from systems.render.places import DESCRIPTION, MANAGER, SIMULATOR, SPAWNERS, pick
from systems.render.planner import move_group
from systems.system import CLASSIC, System


def actions_of(role: str, values: Values) -> list[Action]:
    """Return what a role starts for a robot."""
    if role == SIMULATOR:
        return []
    found = {DESCRIPTION: _description, MANAGER: _manager, SPAWNERS: _spawners}[role](values)
    if values.idioms["hardware"] == "chosen":
        found = _chosen(values, role, found)
    if values.idioms["namespacing"] == "group" and values.robot.namespace:
        return _in_namespace(found, values.namespace)
    return found


def _chosen(values: Values, role: str, found: list[Action]) -> list[Action]:
    """Actions of which an argument chooses whether they are for a simulator or for hardware."""
    system, real = values.system, When(CHOICE, "true", "if", holds=False)
    if role == MANAGER:
        return [replace(each, when=real) for each in found if isinstance(each, Node)]
    if role == SPAWNERS:
        return found
    simulated = both(system)[1]
    beside = replace(values, system=simulated)
    if system.is_simulated:
        hardware = [each for each in _manager(beside) if isinstance(each, Node)]
        model = [replace(each, when=_SIMULATED) if each is found[-1] else each for each in found]
        return [*model, *(replace(each, when=real, label="") for each in hardware)]
    model = [replace(_spawned_model(beside, _namespace(values)), when=_SIMULATED, label="")]
    return [*found, *simulator(simulated, values.idioms), *model]


_SIMULATED = When(CHOICE, "true", "if")


def _in_namespace(actions: list[Action], namespace: Value) -> list[Action]:
    """Actions in a group with a namespace; within the block of an `if` of Python if they stand in one."""
    blocks = [each for each in actions if isinstance(each, Group) and each.when and each.when.form == "python"]
    if len(blocks) == len(actions):
        return [replace(each, actions=(Group(each.actions, namespace),)) for each in blocks]
    return [Group(tuple(actions), namespace)]


def _namespace(values: Values) -> Value:
    return values.namespace if values.idioms["namespacing"] == "attribute" else ()


def simulator(system: System, idioms: Idioms) -> list[Action]:
    """Return what starts the simulator with an empty world, if it is chosen."""
    found = _simulator(system, idioms)
    return _under(found, _SIMULATED) if idioms["hardware"] == "chosen" else found


def _simulator(system: System, idioms: Idioms) -> list[Action]:
    classic, humble = system.simulator == CLASSIC, system.distro == "humble"
    if idioms["world"] == "programs":
        if classic:
            libraries = ("-s", "libgazebo_ros_init.so", "-s", "libgazebo_ros_factory.so")
            return [Execute(tuple((word,) for word in ("gazebo", "--verbose", *libraries)))]
        words = ("ign", "gazebo", "-r", "empty.sdf") if humble else ("gz", "sim", "-r", "empty.sdf")
        return [Execute(tuple((word,) for word in words)), _clock(humble=humble)]
    if classic:
        return [Include("gazebo_ros", "launch/gazebo.launch.py", (), is_external=True)]
    arguments = ("gz_args", ("-r -v 4 empty.sdf",))
    return [Include("ros_gz_sim", "launch/gz_sim.launch.py", (arguments,), is_external=True), _clock(humble=humble)]


def _clock(*, humble: bool) -> Node:
    gz = "ignition" if humble else "gz"
    topic = f"/clock@rosgraph_msgs/msg/Clock[{gz}.msgs.Clock"
    return Node("ros_gz_bridge", "parameter_bridge", arguments=((topic,),))


def _description(values: Values) -> list[Action]:
    system, namespace = values.system, _namespace(values)
    parameters = (Param("robot_description", values.description),)
    if system.is_simulated:
        parameters = (*parameters, Param("use_sim_time", True))
    publisher = "robot_state_publisher"
    name = pick(system, "publisher name", ("", publisher))
    found: list[Action] = [Node(publisher, publisher, name, namespace, parameters)]
    if values.idioms["planner"] == "other arguments":
        found.append(move_group(values, namespace))
    return [*found, _spawned_model(values, namespace)] if system.is_simulated else found


def _spawned_model(values: Values, namespace: Value) -> Node:
    """What puts the robot into the simulator."""
    system = values.system
    classic = system.simulator == CLASSIC
    words = ("-topic", "robot_description", "-entity" if classic else "-name")
    arguments: tuple[Value, ...] = (*((word,) for word in words), values.model)
    if values.idioms["model"] == "text":
        arguments = (("-string",), (values.description,), *arguments[2:])
    package, program = ("gazebo_ros", "spawn_entity.py") if classic else ("ros_gz_sim", "create")
    return Node(package, program, "", namespace, (), arguments, label=first_label(system, values.robot))


def _manager(values: Values) -> list[Action]:
    system, idioms = values.system, values.idioms
    how = idioms["manager description"]
    package, program = (
        ("webots_ros2_driver", "driver") if how == "webots" else ("controller_manager", "ros2_control_node")
    )
    is_given = how in ("parameter", "webots")
    description = (Param("robot_description", values.description),) if is_given else ()
    rewritten = idioms["sections"] if idioms["sections"] in ("replaced", "rewritten") else ""
    rewritten = "written" if idioms["parameters"] == "written" else rewritten
    files = tuple(ParamFile(path, rewritten, values.namespace) for path in values.files)
    types: tuple[Param, ...] = ()
    if idioms["parameters"] == "dictionary":
        types = tuple(Param(f"{name}.type", each["type"]) for name, each in types_of(system, values.robot).items())
    remaps = (("~/robot_description", "robot_description"),) if how == "remap" else ()
    return [
        Node(
            package,
            program,
            namespace=_namespace(values),
            parameters=(*description, *files, *types),
            remaps=remaps,
            label=first_label(system, values.robot),
        )
    ]


def _spawners(values: Values) -> list[Action]:
    planners = [move_group(values, _namespace(values))] if values.idioms["planner"] == "with spawners" else []
    return [*planners, *_conditional(values)]


def _conditional(values: Values) -> list[Action]:
    """The spawners, under a condition if the switch says so."""
    found = spawners(values, _namespace(values))
    form = values.idioms["condition"]
    if form == "none":
        return found
    robot = values.robot
    if form in ("expression", "equals", "substitution"):
        when = When(pick(values.system, "mode", ("mode", "start_mode")), "full", form)
    else:
        value = "false" if form == "unless" else "true"
        names = ("only_states", "passive") if form == "unless" else ("spawn_all", "autostart")
        when = When(pick(values.system, "flag", names), value, form)
    few = {**values.idioms, "spawners": "together", "event": "none"}
    states = replace(robot, spawned=robot.spawned[:1])
    others = spawners(replace(values, robot=states, idioms=few), _namespace(values))
    unlabelled = [replace(action, label="") for action in others if isinstance(action, Node)]
    return [*_under(found, when), *_under(unlabelled, replace(when, holds=False))]


def _under(actions: Sequence[Action], when: When) -> list[Action]:
    """Actions under a condition: of each node if there are only nodes, otherwise of a group."""
    single = [action for action in actions if isinstance(action, Node | Execute)]
    if len(single) == len(actions) and when.form != "python":
        return [replace(action, when=when) for action in single]
    return [Group(tuple(actions), (), when)]


DEFAULTS = {"mode": "full", "start_mode": "full", "only_states": "false", "passive": "false"}
"""The defaults of the arguments that conditions are on, where it is not "true"."""
