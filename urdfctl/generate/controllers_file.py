"""The controllers' file: YAML as rosparam or rcl reads it."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.generate.bringup import spawner, takes_param_file
from urdfctl.generate.options import File, Options
from urdfctl.generate.parameters import Controller
from urdfctl.generate.scalars import one_line
from urdfctl.generate.settings import lines_of
from urdfctl.generate.templates import Templates
from urdfctl.generate.values import TODO, reference
from urdfctl.hints import Any


def controllers_file(made: Sequence[Controller], options: Options, templates: Templates, title: str = "") -> File:
    """The file of some controllers."""
    space = options.namespace.strip("/")
    shown = [_shown(one, space) for one in made]
    text = templates.render(
        f"controllers/ros{options.ros}.yaml",
        command=one_line(options.command),
        title=one_line(title or "the robot"),
        distro=options.distro,
        rate=options.rate,
        simulated=options.simulated,
        namespace=space,
        indent="  " if space else "",
        manager=f"/{space}/controller_manager" if space else "controller_manager",
        controllers=shown,
        start=_start(made, options),
        todos=any(TODO in line for one in shown for line in one["lines"]),
    )
    return File(options.controllers_file, text)


def _start(made: Sequence[Controller], options: Options) -> str:
    """How to start the controllers by hand."""
    names = [one.name for one in made]
    shown = " ".join(names if len(names) <= _FEW else [*names[:_FEW], "..."])
    space = options.namespace.strip("/")
    if options.ros == 1:
        named = f" __ns:=/{space}" if space else ""
        return f"rosparam load {options.controllers_file} && rosrun controller_manager spawner {shown}{named}"
    words = [f"ros2 run controller_manager {spawner(options.distro)} {shown}"]
    words += [f"-c /{space}/controller_manager"] if space else []
    words += [f"--param-file {options.controllers_file}"] if takes_param_file(options.distro) else []
    return one_line(" ".join(words))


def _shown(one: Controller, space: str) -> dict[str, Any]:
    key = f"/{space}/{one.name}" if space else one.name
    return {
        "name": one.name,
        "key": key,
        "type": one.type.type,
        "lines": lines_of(one.settings),
        "about": one_line(_about(one, key)),
    }


_FEW = 6
_ABOUT = {
    "effort": "efforts, in N or Nm",
    "velocity": "speeds, in rad/s or m/s",
    "position": "positions, in rad or m",
}
_DOES = {
    "trajectory": "Follows trajectories: the action follow_joint_trajectory, or a topic.",
    "gripper": "Opens and closes a gripper: the action gripper_cmd.",
    "multi_interface": "Takes a value for each of several interfaces of one joint, on its topic commands.",
    "gpio": "Switches outputs, and publishes inputs.",
    "filter": "Smooths a state, and offers it to other controllers.",
    "pid": "Keeps joints where, or as fast as, it is told, by what it commands below.",
    "admittance": "Lets the tool give way to the forces that a sensor feels.",
    "mecanum": "Drives on four mecanum wheels, which also go sideways.",
    "omni": "Drives on omni wheels around a centre, in any direction.",
    "ackermann": "Drives like a car: two wheels push, two steer.",
    "bicycle": "Drives like a bicycle: one wheel pushes, one steers.",
    "tricycle": "Drives on a wheel that both pushes and steers.",
    "tricycle_steering": "Drives like a tricycle: two wheels push, one steers.",
    "four_wheel_steering": "Drives on four wheels that all steer.",
}


def _about(one: Controller, key: str) -> str:
    """What a beginner wants to know of a controller: what it takes, and where."""
    kind, ros = one.task.kind, one.task.options.ros
    if "joint_state" in one.type.type:
        return "Publishes the joints' states on joint_states: needed by robot_state_publisher and rviz."
    if one.type.broadcaster:
        return "Publishes what a sensor measures; it moves nothing."
    if kind == "diff_drive":
        message = "TwistStamped" if ros == 2 else "Twist"  # noqa: PLR2004
        return f"Drives on two rows of wheels, by {message} on /{key.strip('/')}/cmd_vel."
    if kind in ("effort", "velocity", "position"):
        topic = f"/{key.strip('/')}/{'commands' if ros == 2 else 'command'}"  # noqa: PLR2004
        unit = _ABOUT[reference(one.task) if kind == "velocity" else kind]
        return f"Takes {unit}, on {topic}."
    return _DOES.get(kind, f"A controller of the type {one.type.type}.")
