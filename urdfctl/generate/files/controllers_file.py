"""Generate the controller file: YAML as rosparam or rcl reads it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.controllers.values import TODO, rate_of, reference
from urdfctl.generate.files.bringup import spawner, takes_param_file
from urdfctl.generate.files.hardware import ANY_NAMESPACE
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.text.scalars import one_line
from urdfctl.generate.text.settings import lines_of
from urdfctl.generate.text.templates import Templates


def controllers_file(
    made: Sequence[GeneratedController], options: GeneratorOptions, templates: Templates, title: str = ""
) -> File:
    """Return the parameter file of the controllers."""
    space, movable = options.namespace.strip("/"), options.distro in ANY_NAMESPACE
    shown = [_shown(controller, space, "/**" if movable else f"/{space}" * bool(space)) for controller in made]
    text = templates.render(
        f"controllers/ros{options.ros}.yaml",
        command=one_line(options.command),
        title=one_line(title or "the robot"),
        distro=options.distro,
        rate=options.rate or max((rate_of(controller.task) for controller in made), default=_USUAL),
        simulated=options.simulated,
        movable=movable,
        manager="/**/controller_manager" if movable else f"/{space}/controller_manager" if space else _MANAGER,
        controllers=shown,
        start=_start(made, options),
        todos=any(TODO in line for values in shown for line in values["lines"]),
    )
    return File(options.controllers_file, text)


def _start(made: Sequence[GeneratedController], options: GeneratorOptions) -> str:
    """The command that starts the controllers."""
    names = [controller.name for controller in made if not controller.waits]
    shown = " ".join(names if len(names) <= _FEW else [*names[:_FEW], "..."])
    space = options.namespace.strip("/")
    if options.ros == 1:
        into, named = (f" /{space}", f" __ns:=/{space}") if space else ("", "")
        return f"rosparam load {options.controllers_file}{into} && rosrun controller_manager spawner {shown}{named}"
    words = [f"ros2 run controller_manager {spawner(options.distro)} {shown}"]
    words += [f"-c /{space}/controller_manager"] if space else []
    words += [f"--param-file {options.controllers_file}"] if takes_param_file(options.distro) else []
    return one_line(" ".join(words))


def _shown(controller: GeneratedController, space: str, above: str) -> dict[str, Any]:
    key = f"/{space}/{controller.name}" if space else controller.name
    return {
        "name": controller.name,
        "key": f"{above}/{controller.name}" if above else controller.name,
        "type": controller.type.type,
        "lines": lines_of(controller.settings),
        "about": one_line(_about(controller, key)),
    }


_FEW = 6
_USUAL = 100
_MANAGER = "controller_manager"
_ABOUT = {
    "effort": "efforts, in N or Nm",
    "velocity": "velocities, in rad/s or m/s",
    "position": "positions, in rad or m",
}
_DOES = {
    "trajectory": "Follows trajectories from the action follow_joint_trajectory or from a topic.",
    "gripper": "Opens and closes a gripper through the action gripper_cmd.",
    "multi_interface": "Accepts values for several interfaces of one joint on its topic commands.",
    "gpio": "Switches outputs and publishes inputs.",
    "filter": "Filters a state and exports it to other controllers.",
    "pid": "Controls joint positions or velocities with a PID loop for each joint.",
    "admittance": "Lets the tool yield to the forces that a sensor measures.",
    "mecanum": "Drives on four mecanum wheels, also sideways.",
    "omni": "Drives on omni wheels around a centre, in any direction.",
    "ackermann": "Drives like a car: two driven and two steered wheels.",
    "bicycle": "Drives like a bicycle: one driven and one steered wheel.",
    "tricycle": "Drives on one wheel that is driven and steered.",
    "tricycle_steering": "Drives like a tricycle: two driven wheels and one steered wheel.",
    "four_wheel_steering": "Drives on four driven and steered wheels.",
}


def _about(controller: GeneratedController, key: str) -> str:
    """A sentence for beginners: what the controller does, and on which topic or action."""
    kind, ros = controller.task.kind, controller.task.options.ros
    if "joint_state" in controller.type.type:
        return "Publishes the joint states on joint_states, for robot_state_publisher and RViz."
    if controller.type.broadcaster:
        return "Publishes the measurements of a sensor. It does not move anything."
    if kind == "diff_drive":
        message = "TwistStamped" if ros == 2 else "Twist"  # noqa: PLR2004
        return f"Drives on a left and a right row of wheels, by {message} on /{key.strip('/')}/cmd_vel."
    if kind in ("effort", "velocity", "position"):
        topic = f"/{key.strip('/')}/{'commands' if ros == 2 else 'command'}"  # noqa: PLR2004
        unit = _ABOUT[reference(controller.task) if kind == "velocity" else kind]
        return f"Accepts {unit}, on {topic}."
    return _DOES.get(kind, f"A controller of type {controller.type.type}.")
