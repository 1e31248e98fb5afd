"""UC133."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from urdfctl.control.hardware.behaviour import lacking_joint
from urdfctl.control.hardware.simulator_plugins import (
    control_plugins,
    has_other_hardware,
    loaded_plugins,
    named_joints,
    started_simulator,
    sure_simulator,
)
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.urdf.bodies import Body, inertial_of, vanishing
from urdfctl.rules.urdf.tree import Tree

_GAZEBO = r"(?i)gazebo|ignition|\b(?:ros_)?gz\b|\bgz_|_gz\b"
_SHOWS = r"\brviz2?\b|\brobot_state_publisher\b"
_REFUSED = (
    "the plugin that runs the controllers refuses a robot with a joint that Gazebo does not have: no controller starts"
)


@rule(
    "UC133",
    severity=Severity.WARNING,
    stage=StageDependsOn.LOST_JOINTS,
    runtime="drops",
    because="only Gazebo does, and the robot may not run there",
    authority="sdformat src/parser_urdf.cc CreateSDF(): 'link[...] has no <inertial> block defined', 'parent joint[...] ignored'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="«tool»"/>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="«left»"/>
                <link name="«right»"/>
                <link name="«top»"/>
                <joint name="left_mount" type="fixed"><parent link="fore"/><child link="left"/></joint>
                <joint name="right_mount" type="fixed"><parent link="fore"/><child link="right"/></joint>
                <joint name="top_mount" type="fixed"><parent link="fore"/><child link="top"/></joint>
                <gazebo reference="left_mount"><preserveFixedJoint>true</preserveFixedJoint></gazebo>
                <gazebo reference="right_mount"><disableFixedJointLumping>Yes</disableFixedJointLumping></gazebo>
                <gazebo reference="top_mount"><preserveFixedJoint>1</preserveFixedJoint></gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
                <link name="tip"/>
                <joint name="tip_joint" type="fixed"><parent link="tool"/><child link="tip"/></joint>
            """,
        },
    ],
)
def moving_link_without_inertial(project: Project) -> Iterator[Finding]:
    """Moving link without <inertial>.

    No link that is fixed to it has an <inertial> either. Gazebo drops the link, its joint and everything below it;
    older versions do so silently. Its control plugin then does not know the joint. This is an error if the robot certainly
    runs in Gazebo, and something of what it loses has a shape or is controlled. Real and mocked hardware is not affected:
    this is only worth knowing if the robot has such hardware, or the launch file starts no simulator, and nothing of the
    robot is for Gazebo; or if nothing drives the robot, and the workspace shows it and says nothing of Gazebo. MuJoCo takes masses from its own model, or from shapes.
    """
    robot = whole_robot_in(project)
    if robot is None or not project.may_be_simulated or project.simulator == "mujoco":
        return
    if all(link.inertials for link in robot.links):
        return
    severity = Severity.ERROR if sure_simulator(project) in ("gz", "gazebo-classic") else None
    driven = _driven(project, robot)
    if not robot.gazebos and (_runs_elsewhere(project) or _is_only_shown(project, driven)):
        severity = Severity.INFO
    lost = [body for body in vanishing(robot) if not any(inertial_of(link) for link in body.links)]
    if lost and not any(link.inertials for link in robot.links):
        message = "no link of the robot has an <inertial>; Gazebo drops all moving links"
        yield Finding(robot.at, message, severity=severity)
        return
    tree = Tree(robot)
    for body in lost:
        loss = f"and {body.lost} moving joints" if body.lost > 1 else "and its joint"
        joint = body.joint.name if body.joint else None
        link = f"link '{body.head.name}' of joint '{joint}'" if joint else f"root link '{body.head.name}'"
        message = f"{link} has no <inertial>; Gazebo drops it {loss}"
        is_empty = severity is Severity.ERROR and not _is_missed(body, robot, tree, driven)
        notes = (Note(_REFUSED),) if joint in driven and _is_refused(project) else ()
        yield Finding(body.head.at["name"], message, notes, severity=None if is_empty else severity)


def _runs_elsewhere(project: Project) -> bool:
    """Whether the robot runs without a simulator: its hardware is for none, or the launch file starts none."""
    if started_simulator(project) is not None:
        return False
    return has_other_hardware(project) or (project.launch is not None and project.launch.runs_without_simulator)


def _is_only_shown(project: Project, driven: Collection[str | None]) -> bool:
    """Whether nothing drives the robot, and the workspace shows it in RViz and says nothing of Gazebo."""
    if driven or started_simulator(project) is not None or project.may_mention(_GAZEBO):
        return False
    return project.launch is not None or bool(project.mentioned(_SHOWS))


def _is_refused(project: Project) -> bool:
    """Whether the plugin that runs the controllers gives up if the simulator's model lacks a joint."""
    known = [plugin.any for plugin in control_plugins(project) if plugin.any is not None]
    steps = [lacking_joint(project.catalog, plugin.id, distro) for plugin in known for distro in project.distros]
    return bool(steps) and all(step == "refused" for step in steps)


def _is_missed(body: Body, robot: Robot, tree: Tree, driven: Collection[str | None]) -> bool:
    """Whether anything of what Gazebo drops with a body has a shape, or a joint that is controlled."""
    below = tree.below(body.head.name or "")
    joints = {joint.name for joint in robot.joints if joint.child and joint.child.name in below}
    return not joints.isdisjoint(driven) or any(link.geometries for link in robot.links if link.name in below)


def _driven(project: Project, robot: Robot) -> set[str | None]:
    """The joints that a transmission, a <ros2_control> or a plugin names."""
    transmissions = {end.name for transmission in robot.transmissions for end in transmission.joints}
    parts = {part.name for control in robot.ros2_controls for part in control.parts}
    return {*transmissions, *parts, *(name for plugin in loaded_plugins(project) for name, _ in named_joints(plugin))}
