"""UC524."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.simulator_plugins import control_plugins, namespace_of
from urdfctl.model.robot import Tag
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_known


@rule(
    "UC524",
    runtime="refuses",
    because="other files may configure the controllers",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="gazebo_ros_control src/gazebo_ros_control_plugin.cpp: the manager's node handle is robotNamespace; "
    "controller_manager src/controller_manager.cpp: 'Could not load controller 'x' because the type was not "
    "specified. Did you load the controller configuration on the parameter server'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    «<robotNamespace>»/left_arm</robotNamespace>
                  </plugin>
                </gazebo>
            """,
            "controllers.yaml": """
                arm:
                  joint_state_controller:
                    type: joint_state_controller/JointStateController
                    publish_rate: 50
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotNamespace>/arm</robotNamespace>
                  </plugin>
                </gazebo>
            """,
            "controllers.yaml": """
                arm:
                  joint_state_controller:
                    type: joint_state_controller/JointStateController
                    publish_rate: 50
            """,
        },
    ],
)
def controllers_of_other_namespace(project: Project) -> Iterator[Finding]:
    """Controllers are configured outside the namespace of the simulated robot.

    The plugin's controller manager runs in `<robotNamespace>` and looks there for the parameters of each controller. It
    finds no type and loads no controller.
    """
    hosts = [sim_plugin for sim_plugin in control_plugins(project) if sim_plugin.library == "gazebo_ros_control"]
    setting = hosts[0].setting("robotNamespace") if len(hosts) == 1 else None
    if project.controllers is None or setting is None or not is_known(setting.text):
        return
    ours = namespace_of(setting.text)
    placed = [
        (controller, controller.namespace)
        for controller in project.controllers.controllers
        if controller.declared_at and controller.namespace is not None
    ]
    loaded = project.launch is not None and bool(project.launch.loads)
    if not placed or any(_may_be_in(ours, namespace, loaded) for _, namespace in placed):
        return
    controller, theirs = placed[0]
    message = (
        f"the simulated robot expects its controllers in namespace '{ours or '/'}', "
        f"but they are configured in '{theirs or '/'}'"
    )
    notes = [Note(f"controller '{controller.name}' is configured here", controller.declared_at)]
    only = len({namespace for _, namespace in placed}) == 1
    yield Finding(setting.at, message, tuple(notes), _namespace(setting, theirs or "/") if only else None)


def _namespace(setting: Tag, name: str) -> Fix:
    """Write the namespace in which all controllers are configured; without edits where it is calculated."""
    content = setting.at.content.span
    edits = (Edit(content, name),) if content.text.strip() == setting.text.strip() else ()
    return Fix(f"write '{name}'", edits)


def _may_be_in(ours: str, theirs: str, loaded: bool) -> bool:  # noqa: FBT001 (private)
    """Whether a manager may find the controllers of a namespace: in its own namespace, or in one below it.

    Without a launch file that loads them, another launch file may load them below a further namespace.
    """
    return theirs == ours or theirs.startswith(f"{ours}/") or (not loaded and ours.endswith(theirs))
