"""UC634."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hosts import CONTROLLER_MANAGER, MANAGER
from urdfctl.model.launch import Launch
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, whole_robot_in
from urdfctl.rules.launch.common import publishers_of_states, state_publishers
from urdfctl.rules.launch_samples import PUBLISHER, launched

_MOVABLE = ("revolute", "continuous", "prismatic")
_VIEWERS = ("rviz", "rviz2")
_RVIZ = """
      <node pkg="rviz2" exec="rviz2"/>"""
_STATES = """
      <node pkg="joint_state_publisher" exec="joint_state_publisher"/>"""


_MARKED = PUBLISHER.replace("<node pkg", "«<node pkg").replace('publisher">', 'publisher">»')
_BESIDE = (
    "robot_state_publisher joint_state_publisher joint_state_publisher_gui controller_manager tf2_ros xacro rqt_gui "
    "rqt_joint_trajectory_controller rqt_robot_steering topic_tools ros_gz_bridge ros_ign_bridge ros_gz_image ros_gz_sim "
    "ros_ign_gazebo gazebo_ros nav2_util twist_mux joy teleop_twist_joy slam_toolbox robot_localization "
    "moveit_ros_move_group moveit_servo"
).split()
"""Packages whose nodes publish no joint states; but the controller manager does."""


def _files(*nodes: str) -> dict[str, str]:
    files = launched(*nodes, robot="")
    more = "<exec_depend>rviz2</exec_depend><exec_depend>joint_state_publisher</exec_depend></package>"
    manifest = files.pop("package.xml").replace("</package>", more)
    files.pop("controllers.yaml")
    return {**files, "package.xml": manifest}


@rule(
    "UC634",
    runtime="misbehaves",
    because="another launch file may start the publisher",
    severity=Severity.INFO,
    whole_robot=True,
    in_library=False,
    authority="robot_state_publisher: transforms of movable joints are published only for positions from joint_states; RViz: "
    "'No transform from [fore] to [base]'",
    bad=[
        _files(_MARKED, _RVIZ),
        {
            "arm.launch": """
                <launch>
                  <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
                  «<node name="publisher" pkg="robot_state_publisher" type="state_publisher"/>»
                  <node name="rviz" pkg="rviz" type="rviz"/>
                </launch>
            """,
            "arm.urdf": """
                <link name="tool"/>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
                <link name="finger"/>
                <joint name="slide" type="prismatic">
                  <parent link="tool"/><child link="finger"/><limit lower="0" upper="1" effort="1" velocity="1"/>
                </joint>
            """,
            "package.xml": "<package><name>arm</name></package>",
        },
        _files(_MARKED, _RVIZ, *(f'<node pkg="{package}" exec="any"/>' for package in _BESIDE)),
    ],
    good=[_files(PUBLISHER, _RVIZ, _STATES)],
)
def joint_states_of_nobody(project: Project) -> Iterator[Finding]:
    """Nobody publishes the states of the joints that RViz shows.

    robot_state_publisher publishes a transform of a movable joint only when it receives the joint's position. RViz
    shows the links in one place and reports missing transforms. Start joint_state_publisher, or a controller manager
    with a broadcaster, unless another launch file does.
    """
    launch, robot = project.launch, whole_robot_in(project)
    if launch is None or robot is None or not _is_viewer_alone(launch):
        return
    moving = [joint.name for joint in robot.joints if joint.type in _MOVABLE and joint.name]
    publisher = next((node for node in state_publishers(launch) if node.sure), None)
    if not moving or publisher is None or publisher.remaps or robot.gazebos:
        return
    joints = f"joint {in_words(moving, 3)}" if len(moving) == 1 else f"joints {in_words(moving, 3)}"
    message = f"no node in this launch file publishes the joint states of {joints}; start joint_state_publisher"
    yield Finding(publisher.at, message)


def _is_viewer_alone(launch: Launch) -> bool:
    """Whether a launch file shows a robot, and starts nothing that may publish joint states."""
    if not launch.complete or launch.spawns or launch.elsewhere or launch.simulations or publishers_of_states(launch):
        return False
    harmless = (*_VIEWERS, *_BESIDE)
    if any(node.package.text not in harmless or node.runs(CONTROLLER_MANAGER, MANAGER) for node in launch.nodes):
        return False
    return any(node.package.text in _VIEWERS for node in launch.nodes)
