"""What to do after files were written: include them, build, launch, and command each controller once."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence

from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.files.bringup import launch_name, planning_launch_name
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import JointFacts

_PART = 0.1
"""An example moves a joint by this part of its range."""


def steps_after(
    command: str, made: Sequence[GeneratedController], options: GeneratorOptions, output: str, *, can_smoke: bool
) -> Iterator[str]:
    """Yield commands and lines for the user, for files that a generator wrote to an output.

    can_smoke: whether an engine is installed.
    """
    package = options.package or "my_robot_control"
    if command == "convert":
        yield f"gz sim -r {output}" if options.to == "sdf" else f"python -m mujoco.viewer --mjcf={output}"
        return
    if command in ("gen-transmissions", "gen-ros2-control", "gen-gazebo"):
        yield f'include it in the robot: <xacro:include filename="$(find {package})/urdf/{os.path.basename(output)}"/>'
        return
    launch = os.path.basename(output) if command == "gen-launch" else launch_name(options)
    if options.moveit:
        launch = planning_launch_name(options)
    if command != "gen-controllers":
        build = "colcon build --packages-select" if options.ros == 2 else "catkin build"  # noqa: PLR2004
        setup = "install/setup.bash" if options.ros == 2 else "devel/setup.bash"  # noqa: PLR2004
        yield f"{build} {package} && source {setup}"
        yield f"{'ros2 launch' if options.ros == 2 else 'roslaunch'} {package} {launch}"  # noqa: PLR2004
    for controller in made:
        line = example_of(controller)
        if line:
            yield line
    if command in ("gen-all", "gen-moveit"):
        needs = "" if can_smoke else "  # needs: pip install 'urdfctl[smoke]'"
        yield f"urdfctl lint {output} && urdfctl smoke {output}{needs}"


def example_of(controller: GeneratedController) -> str | None:
    """Return a command that moves what a controller commands a little. None if there is no such command."""
    task, options = controller.task, controller.task.options
    if controller.reports or controller.waits or task.below:
        return None
    space = f"/{options.namespace}" if options.namespace else ""
    examples = _ROS2 if options.ros == 2 else _ROS1  # noqa: PLR2004
    make = examples.get(controller.type.type.rpartition("/")[2])
    return make(f"{space}/{controller.name}", controller) if make else None


def _target(joint: JointFacts) -> float:
    """A position a little way from zero, within the limits."""
    if joint.type == "continuous" or joint.lower is None or joint.upper is None:
        return 0.1
    start = min(max(0.0, joint.lower), joint.upper)
    far = _PART * (joint.upper - joint.lower)
    return float(f"{(start + far if start + far <= joint.upper else start - far):.3g}")


def _values(controller: GeneratedController) -> list[float]:
    reference: Mapping[str, Callable[[JointFacts], float]] = {
        "position": _target,
        "velocity": lambda _: 0.1,
        "effort": lambda _: 0.0,
    }
    kind = controller.task.kind if controller.task.kind in reference else controller.task.interface
    return [reference.get(kind, _target)(joint) for joint in controller.task.joints]


def _names(controller: GeneratedController) -> str:
    return ", ".join(joint.name for joint in controller.task.joints)


def _trajectory(controller: GeneratedController) -> tuple[str, str]:
    return _names(controller), str([_target(joint) for joint in controller.task.joints])


def _action(name: str, controller: GeneratedController) -> str:
    joints, positions = _trajectory(controller)
    goal = f"{{joint_names: [{joints}], points: [{{positions: {positions}, time_from_start: {{sec: 2}}}}]}}"
    kind = "control_msgs/action/FollowJointTrajectory"
    return f'ros2 action send_goal {name}/follow_joint_trajectory {kind} "{{trajectory: {goal}}}"'


def _array(name: str, controller: GeneratedController) -> str:
    data = _values(controller) * max(1, len(controller.task.interfaces) if controller.task.kind.startswith("m") else 1)
    return f'ros2 topic pub --once {name}/commands std_msgs/msg/Float64MultiArray "{{data: {data}}}"'


def _gripper(name: str, controller: GeneratedController) -> str:
    joint = controller.task.joints[0]
    if controller.type.package == "parallel_gripper_controller" or "parallel" in controller.type.type:
        goal = f"{{command: {{name: [{joint.name}], position: [{_target(joint)}]}}}}"
        return f'ros2 action send_goal {name}/gripper_cmd control_msgs/action/ParallelGripperCommand "{goal}"'
    goal = f"{{command: {{position: {_target(joint)}, max_effort: {joint.effort or 10.0}}}}}"
    return f'ros2 action send_goal {name}/gripper_cmd control_msgs/action/GripperCommand "{goal}"'


def _drive(topic: str) -> Callable[[str, GeneratedController], str]:
    def made(name: str, controller: GeneratedController) -> str:
        del controller
        twist = "{twist: {linear: {x: 0.2}, angular: {z: 0.0}}}"
        return f'ros2 topic pub -r 10 {name}/{topic} geometry_msgs/msg/TwistStamped "{twist}"'

    return made


def _gpio(name: str, controller: GeneratedController) -> str | None:
    """All outputs of the first gpio that has any; None if it only publishes inputs."""
    for joint in controller.task.joints:
        outputs = controller.values.get(f"command_interfaces.{joint.name}.interfaces")
        if isinstance(outputs, list) and outputs:
            values = f"{{interface_names: [{', '.join(outputs)}], values: {[1.0] * len(outputs)}}}"
            value = f"{{interface_groups: [{joint.name}], interface_values: [{values}]}}"
            return f'ros2 topic pub --once {name}/commands control_msgs/msg/DynamicInterfaceGroupValues "{value}"'
    return None


def _admittance(name: str, controller: GeneratedController) -> str:
    positions = [_target(joint) for joint in controller.task.joints]
    value = f"{{positions: {positions}, velocities: {[0.0] * len(positions)}}}"
    return f'ros2 topic pub --once {name}/joint_references trajectory_msgs/msg/JointTrajectoryPoint "{value}"'


def _pid(name: str, controller: GeneratedController) -> str:
    value = f"{{dof_names: [{_names(controller)}], values: {_values(controller)}}}"
    return f'ros2 topic pub --once {name}/reference control_msgs/msg/MultiDOFCommand "{value}"'


def _number(name: str, controller: GeneratedController) -> str:
    return f'rostopic pub -1 {name}/command std_msgs/Float64 "data: {_values(controller)[0]}"'


def _array1(name: str, controller: GeneratedController) -> str:
    return f'rostopic pub -1 {name}/command std_msgs/Float64MultiArray "{{data: {_values(controller)}}}"'


def _trajectory1(name: str, controller: GeneratedController) -> str:
    joints, positions = _trajectory(controller)
    goal = f"{{joint_names: [{joints}], points: [{{positions: {positions}, time_from_start: {{secs: 2}}}}]}}"
    return f'rostopic pub -1 {name}/command trajectory_msgs/JointTrajectory "{goal}"'


def _gripper1(name: str, controller: GeneratedController) -> str:
    joint = controller.task.joints[0]
    goal = f"{{goal: {{command: {{position: {_target(joint)}, max_effort: {joint.effort or 10.0}}}}}}}"
    return f'rostopic pub -1 {name}/gripper_cmd/goal control_msgs/GripperCommandActionGoal "{goal}"'


def _drive1(name: str, controller: GeneratedController) -> str:
    del controller
    return f'rostopic pub -r 10 {name}/cmd_vel geometry_msgs/Twist "{{linear: {{x: 0.2}}}}"'


_Example = Callable[[str, GeneratedController], str | None]
_ROS2: Mapping[str, _Example] = {
    "JointTrajectoryController": _action,
    **dict.fromkeys(("ForwardCommandController", "MultiInterfaceForwardCommandController"), _array),
    **{f"JointGroup{kind}Controller": _array for kind in ("Position", "Velocity", "Effort")},
    "GripperActionController": _gripper,
    **dict.fromkeys(("DiffDriveController", "TricycleController", "OmniWheelDriveController"), _drive("cmd_vel")),
    **{f"{kind}SteeringController": _drive("reference") for kind in ("Ackermann", "Bicycle", "Tricycle")},
    "MecanumDriveController": _drive("reference"),
    "PidController": _pid,
    "GpioCommandController": _gpio,
    "AdmittanceController": _admittance,
}
_ROS1: Mapping[str, _Example] = {
    "JointTrajectoryController": _trajectory1,
    **{f"Joint{kind}Controller": _number for kind in ("Position", "Velocity", "Effort")},
    **{f"JointGroup{kind}Controller": _array1 for kind in ("Position", "Velocity", "Effort")},
    "GripperActionController": _gripper1,
    **dict.fromkeys(("DiffDriveController", "AckermannSteeringController", "FourWheelSteeringController"), _drive1),
}
