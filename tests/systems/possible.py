"""Which positions of the switches are possible together: what ROS would start."""

from __future__ import annotations

from systems.system import GZ, System

Idioms = dict[str, str]
"""The position of each switch."""


def ros2(system: System, _idioms: Idioms, _position: str) -> bool:
    """A launch file of ROS 2 that is written by hand."""
    return system.generation == 2 and not system.moveit


def not_moveit(system: System, _idioms: Idioms, _position: str) -> bool:
    """Not MoveIt's demo, whose launch files are given."""
    return not system.moveit


def moveit(system: System, _idioms: Idioms, _position: str) -> bool:
    """MoveIt's demo."""
    return system.moveit


def _has_inner(system: System, idioms: Idioms, _position: str) -> bool:
    return not_moveit(system, idioms, "") and idioms["depth"] != "flat"


def inner_language(system: System, idioms: Idioms, _position: str) -> bool:
    """The language of included files."""
    return ros2(system, idioms, "") and idioms["depth"] != "flat"


def has_python(system: System, idioms: Idioms, _position: str) -> bool:
    """Whether the file that holds the nodes is in Python."""
    return ros2(system, idioms, "") and idioms["top" if idioms["depth"] == "flat" else "inner"] == "python"


def any_python(system: System, idioms: Idioms, _position: str) -> bool:
    """Whether some launch file is in Python."""
    return ros2(system, idioms, "") and "python" in (idioms["top"], _inner_of(idioms))


def _inner_of(idioms: Idioms) -> str:
    return idioms["top"] if idioms["depth"] == "flat" else idioms["inner"]


def source(system: System, _idioms: Idioms, position: str) -> bool:
    """A plain URDF, and one that is made when the package is built, has no arguments: robots that share it have the
    same names. A plain URDF does not have the path of a file either."""
    if position == "built" and system.is_simulated and any(robot.namespace for robot in system.robots):
        return False
    return position == "macros" or not (
        system.moveit
        or (position == "urdf" and system.is_simulated and system.generation == 2)
        or any(robot.prefix for robot in system.robots)
        or (system.is_simulated and system.is_fleet)
    )


_TEXTS = ("urdf", "built")
"""Sources of which launch files find a text."""


def shared(system: System, idioms: Idioms, _position: str) -> bool:
    """Files that are included once for each robot: all that differs is in their arguments."""
    named = all(robot.namespace for robot in system.robots)
    if not (system.is_fleet and named and idioms["depth"] != "flat" and not system.moveit):
        return False
    first, second = system.robots
    same = (first.model, first.joints, first.spawned, first.manager, first.asked)
    is_same = same == (second.model, second.joints, second.spawned, second.manager, second.asked)
    return is_same and all(robot.section == robot.namespace for robot in system.robots)


def argued(system: System, idioms: Idioms, position: str) -> bool:
    """An argument holds only what the robot has."""
    if system.moveit or (system.is_fleet and idioms["fleet"] == "apart"):
        return False
    if idioms["fleet"] == "shared":
        return True
    robot = system.robots[0]
    possible = {"namespace": bool(robot.namespace), "prefix": bool(robot.prefix) and idioms["source"] not in _TEXTS}
    return possible.get(position, True)


def passing(system: System, idioms: Idioms, position: str) -> bool:
    """Arguments are passed to included files; robots that share files always give them theirs."""
    if idioms["fleet"] == "shared":
        return position == "required"
    return _has_inner(system, idioms, "") and idioms["argued"] != "nothing"


def defaults(system: System, idioms: Idioms, _position: str) -> bool:
    """Where an argument's default comes from: an environment variable, or it is set and no argument at all."""
    return not system.moveit and idioms["argued"] != "nothing"


def description(system: System, idioms: Idioms, position: str) -> bool:
    """A file without xacro can be read; what xacro's Python functions expand depends on no launch argument."""
    if not has_python(system, idioms, ""):
        return False
    if position == "perform":
        return idioms["values"] == "perform"
    is_known = idioms["values"] == "perform" or (idioms["argued"] == "nothing" and idioms["fleet"] == "apart")
    if position == "open":
        return idioms["source"] in _TEXTS and is_known
    return position not in ("process_file", "process_doc", "function", "module") or is_known


def opaque(system: System, idioms: Idioms, _position: str) -> bool:
    """What is done later has neither the namespace of a group that is left, nor the arguments of another include."""
    scoped = idioms["namespacing"] == "group around include" or idioms["fleet"] == "shared"
    return has_python(system, idioms, "") and idioms["values"] == "perform" and not scoped


def address(system: System, idioms: Idioms, _position: str) -> bool:
    """An argument of the description that has no value until the robot is started."""
    if idioms["source"] in _TEXTS or system.moveit or idioms["fleet"] == "shared":
        return False
    return idioms["values"] == "perform" or idioms["description"] not in _EXPANDED


_EXPANDED = ("process_file", "process_doc", "function", "module", "open")
"""How a description is made by Python itself."""


WRAPPED = ("parameter_value", "find_executable")
"""How a description is made as a parameter, not as a text."""


def hardware(system: System, idioms: Idioms, _position: str) -> bool:
    """An argument chooses between a simulator and hardware."""
    one = system.generation == 2 and not system.moveit and not system.is_fleet
    known = idioms["values"] == "perform" or idioms["description"] not in _EXPANDED
    return one and known and idioms["source"] not in _TEXTS and system.robots[0].manager == "controller_manager"


def planner(system: System, idioms: Idioms, position: str) -> bool:
    """A move_group beside one robot; with the spawners, if these are started in a terminal of their own."""
    one = system.generation == 2 and not system.moveit and not system.is_fleet
    if position == "with spawners" and idioms["split"] not in ("spawners apart", "three starts"):
        return False
    return one and idioms["source"] not in _TEXTS and idioms["description"] not in ("function", "module", "open")


def model(system: System, idioms: Idioms, position: str) -> bool:
    """What is put into the simulator: by Gazebo's program for ROS 1 a file, by that for Gazebo Sim a text."""
    if position == "file":
        return system.generation == 1 and system.is_simulated and idioms["source"] in _TEXTS
    wrapped = idioms["description"] in WRAPPED
    return system.simulator == GZ and has_python(system, idioms, "") and not wrapped


def described(system: System, idioms: Idioms, _position: str) -> bool:
    """The parameter is set twice, and the last one wins."""
    return system.generation == 1 and idioms["order"] == "natural"


def namespaced(system: System, idioms: Idioms, position: str) -> bool:
    """Something has to have a namespace."""
    if not any(robot.namespace for robot in system.robots) or system.moveit:
        return False
    return position != "group around include" or _has_inner(system, idioms, "")


def sections(system: System, idioms: Idioms, position: str) -> bool:
    """A file is rewritten for a node that the launch file starts; a plugin reads it as it is."""
    if system.generation == 1 or system.moveit:
        return False
    if position == "wildcard":
        return not _is_section_wrong(system)
    if position == "rooted":
        return not any(robot.section for robot in system.robots)
    if not all(robot.namespace for robot in system.robots) or _is_section_wrong(system):
        return False
    if idioms["hardware"] == "chosen":
        return position == "nested"
    return position == "nested" or (not system.simulator and has_python(system, idioms, ""))


def ros1(system: System, _idioms: Idioms, _position: str) -> bool:
    """Only in ROS 1."""
    return system.generation == 1


FULL_KEYS = ("key", "full names")
"""Where the keys of a parameter file of ROS 1 hold the namespace."""


def loading(system: System, idioms: Idioms, position: str) -> bool:
    """Parameters of ROS 1 below a namespace."""
    if position in FULL_KEYS and (idioms["namespacing"] == "group around include" or idioms["fleet"] == "shared"):
        return False
    return system.generation == 1 and all(robot.section for robot in system.robots)


def _is_section_wrong(system: System) -> bool:
    return any(robot.section != robot.namespace for robot in system.robots)


def parameters(system: System, idioms: Idioms, position: str) -> bool:
    """Each generation has its own ways to give parameters."""
    if system.moveit:
        return False
    if idioms["fleet"] == "shared" and position in ("dictionary", "inline") and not _same_controllers(system):
        return False
    if position == "dictionary":
        untyped = any(not one.typed for robot in system.robots for one in robot.controllers)
        return _real_ros2(system) and idioms["hardware"] == "fixed" and not untyped and not _is_section_wrong(system)
    if position == "written":  # by the launch file, from a template
        made = has_python(system, idioms, "") and idioms["values"] == "perform" and idioms["sections"] == "full name"
        fixed = idioms["hardware"] == "fixed" and not system.is_fleet and idioms["argued"] not in ("controllers", "all")
        return made and fixed and _real_ros2(system)
    if position == "common":  # one file for several robots
        return system.is_fleet and system.generation == 2 and idioms["sections"] == "full name"
    if position == "inline":  # the text of a file that robots share is the same for all of them
        is_same = idioms["fleet"] == "apart" or not any(robot.prefix for robot in system.robots)
        return system.generation == 1 and is_same
    return system.generation == 1 or idioms["sections"] not in ("replaced", "rewritten")


def _same_controllers(system: System) -> bool:
    """Whether a text in a file that robots share is right for all of them, or wrong for all."""
    return all(robot.controllers == system.robots[0].controllers for robot in system.robots)


def _real_ros2(system: System) -> bool:
    return system.generation == 2 and not system.simulator and not system.moveit


LOOPS = ("comprehension", "loop", "function", "listed in a file")
"""How the names of controllers are looped over."""


def spawners(system: System, idioms: Idioms, position: str) -> bool:
    """Loops need Python; each generation has a program of its own."""
    if system.moveit:
        return False
    if position == "listed in a file" and system.is_fleet:
        return False
    if position in LOOPS:
        return has_python(system, idioms, "")
    if position == "command line":
        return system.generation == 2
    return position != "manager program" or system.generation == 1


def manager_option(system: System, idioms: Idioms, position: str) -> bool:
    """The plain one is the absolute name; without any, the spawner looks for controller_manager in its namespace."""
    if system.generation == 1:
        return position == "argument" and idioms["spawners"] != "manager program"
    if system.moveit or position == "argument":
        return False
    if position == "none":
        plain = all(robot.asked == "controller_manager" for robot in system.robots)
        return plain and idioms["spawners"] != "command line"
    return position != "relative" or idioms["spawners"] != "command line"


def timeout(system: System, idioms: Idioms, _position: str) -> bool:
    """An option of the spawner, which argparse knows by its beginning, too."""
    return not system.moveit and idioms["spawners"] not in ("command line", "manager program")


def param_file(system: System, idioms: Idioms, _position: str) -> bool:
    """A file that spawners are given has to name their controllers as they are."""
    if idioms["parameters"] == "written":
        return False
    possible = idioms["spawners"] != "command line" and idioms["sections"] not in ("nested", "replaced", "rewritten")
    return ros2(system, idioms, "") and possible and not _is_section_wrong(system)


def told(system: System, idioms: Idioms, _position: str) -> bool:
    """A text says which arguments the only start of one robot needs."""
    one = idioms["split"] == "one start" and idioms["around"] == "nothing" and not system.is_fleet
    return one and idioms["argued"] != "nothing" and idioms["defaults"] == "written" and not system.moveit


def around(system: System, idioms: Idioms, position: str) -> bool:
    """Another file around one that starts everything; one that is given any file does not know its arguments."""
    if position == "handed on" and idioms["address"] == "required":
        return False
    return not system.moveit and idioms["split"] == "one start"


def event(system: System, idioms: Idioms, position: str) -> bool:
    """What is done later has no namespace of a group, as what is called later."""
    if idioms["namespacing"] != "attribute" or idioms["fleet"] == "shared":
        return False
    if position == "timer":
        return ros2(system, idioms, "")
    if not has_python(system, idioms, "") or idioms["spawners"] in LOOPS:
        return False
    in_a_row = position == "on exit" and idioms["spawners"] in ("each", "command line")
    return in_a_row or waits_for_start(system, idioms, position)


def waits_for_start(system: System, idioms: Idioms, event: str) -> bool:
    """Return whether the first spawner waits for what is started beside it in the same file: by "on exit" for the
    program that puts the robot into the simulator, by "on start" for the manager."""
    beside = idioms["depth"] == "flat" and idioms["split"] in ("one start", "manager apart")
    return beside and system.is_simulated is (event == "on exit")


def condition(system: System, idioms: Idioms, position: str) -> bool:
    """Each language and distro has its own conditions."""
    if position == "python":
        return has_python(system, idioms, "") and idioms["values"] == "perform"
    if position == "substitution":
        return has_python(system, idioms, "") and system.distro != "humble"
    if position == "equals":
        return has_python(system, idioms, "") and system.distro == "humble"
    return not system.moveit


def reduced(system: System, idioms: Idioms, _position: str) -> bool:
    """Another file around the only start of one robot gives another value to the argument of its condition.

    It does not start the hardware in the place of the simulator: no clock runs there for what the parameters want.
    """
    one = around(system, idioms, "") and idioms["around"] == "nothing" and not system.is_fleet
    needs_nothing = idioms["told"] == "nowhere" and idioms["address"] == "none"
    needs_no_clock = idioms["hardware"] == "fixed"
    return one and needs_nothing and needs_no_clock and idioms["depth"] == "flat" and idioms["condition"] != "none"


def manager_description(system: System, idioms: Idioms, position: str) -> bool:
    """Before jazzy the manager reads `~/robot_description`; since kilted it has no such parameter.

    That of Webots is in its driver, which takes the paths of files, as texts.
    """
    if position == "webots":
        robot = system.robots[0]
        is_text = idioms["source"] == "urdf" and idioms["argued"] == "nothing" and has_python(system, idioms, "")
        is_file = idioms["parameters"] in ("one file", "several files")
        as_it_is = is_file and idioms["sections"] not in ("replaced", "rewritten")
        return _real_ros2(system) and not system.is_fleet and not robot.namespace and is_text and as_it_is
    return (
        _real_ros2(system)
        and system.distro in {"topic": ("jazzy", "kilted"), "parameter": ("humble", "jazzy")}[position]
    )


def build(system: System, idioms: Idioms, _position: str) -> bool:
    """A package of Python does not run xacro when it is built."""
    return ros2(system, idioms, "") and idioms["source"] != "built"


def distractor(system: System, idioms: Idioms, position: str) -> bool:
    """A distro that the user names is meant for everything."""
    if position == "namesakes":
        return system.generation == 2
    if position == "started elsewhere":
        return not system.moveit
    return position != "other generation" or idioms["evidence"] != "option"
