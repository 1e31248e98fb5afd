"""UC613."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.simulator_plugins import control_plugins, namespace_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.launch.common import launch_of


def _robot(namespace: str) -> str:
    return f"""
        <gazebo>
          <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
            <robotNamespace>{namespace}</robotNamespace>
          </plugin>
        </gazebo>
    """


def _files(namespace: str) -> dict[str, str]:
    return {
        "arm.launch": """
            <launch>
              <group ns="arm">
                «<param name="robot_description" textfile="$(find arm)/arm.urdf"/>»
              </group>
            </launch>
        """,
        "arm.urdf": _robot(namespace),
        "package.xml": "<package><name>arm</name><run_depend>gazebo_ros_control</run_depend></package>",
    }


@rule(
    "UC613",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="gazebo_ros_control gazebo_ros_control_plugin.cpp getURDF(): searchParam() from robotNamespace upwards: "
    "'gazebo_ros_control plugin is waiting for model URDF in parameter [robot_description] on the ROS param server.'",
    bad=[_files("/left")],
    good=[{name: text.replace("«", "").replace("»", "") for name, text in _files("/arm").items()}],
)
def description_of_other_namespace(project: Project) -> Iterator[Finding]:
    """Robot description is in a different namespace than the simulated robot.

    gazebo_ros_control looks for the description in `<robotNamespace>` and the namespaces above it. It waits until it
    finds one.
    """
    launch = launch_of(project, 1)
    plugins = [plugin for plugin in control_plugins(project) if plugin.library == "gazebo_ros_control"]
    setting = plugins[0].setting("robotNamespace") if len(plugins) == 1 else None
    if launch is None or setting is None or not is_known(setting.text) or plugins[0].setting("robotParam"):
        return
    ours = namespace_of(setting.text)
    parameters = [description for description in launch.descriptions if description.node is None]
    described = [description for description in parameters if description.sure and description.namespace is not None]
    if not launch.complete or not described or len(described) < len(parameters):
        return
    if not any(f"{ours}/".startswith(f"{namespace_of(description.namespace or '')}/") for description in described):
        theirs = namespace_of(described[0].namespace or "")
        message = f"the robot description is in '{theirs}', but the controller manager looks for it in '{ours or '/'}'"
        yield Finding(described[0].at, message, (Note("the plugin's namespace is set here", setting.at),))
