"""UC607."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, components, simulator_of
from urdfctl.control.hosts import CONTROLLER_MANAGER, MANAGER
from urdfctl.model.launch import Launch, Node
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, launch_of, manager_nodes, simulators_managers
from urdfctl.rules.launch_samples import ARM, BROADCASTER, PUBLISHER, ROBOT, SOUND, launched
from urdfctl.source.span import Place

_MANAGER = """
      «<node pkg="controller_manager" exec="ros2_control_node">»
        <param from="$(find-pkg-share arm)/controllers.yaml"/>
        <remap from="~/robot_description" to="/robot_description"/>
      </node>"""
_FIRST_MANAGER = _MANAGER.replace("«", "").replace("»", "")
_OTHER_MANAGER = """
      <node pkg="controller_manager" exec="ros2_control_node" namespace="other"/>
      <node pkg="robot_state_publisher" exec="robot_state_publisher" namespace="other">
        <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/arm.urdf')" type="str"/>
      </node>"""
_SIMULATED = ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")


@rule(
    "UC607",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface resource_manager.cpp: 'According to the loaded plugin descriptions the class "
    "gz_ros2_control/GazeboSimSystem with base class type hardware_interface::SystemInterface does not exist.'",
    bad=[
        launched(PUBLISHER, _MANAGER, BROADCASTER, ARM, robot=_SIMULATED),
        launched(PUBLISHER, _FIRST_MANAGER, _MANAGER, BROADCASTER, ARM),
    ],
    good=[SOUND, launched(PUBLISHER, _FIRST_MANAGER, _OTHER_MANAGER, BROADCASTER, ARM)],
)
def manager_beside_simulator(project: Project) -> Iterator[Finding]:
    """ros2_control_node is started for a robot with simulated hardware, or twice.

    That hardware runs in the simulator's process, and only the controller manager of the simulator's plugin can load
    it. A second manager does not find the class and exits. With other hardware, two managers of one name answer the
    spawners, and both load the hardware. Do not start ros2_control_node in a simulation, and only once elsewhere.
    """
    launch = launch_of(project, ROS_2)
    if launch is None:
        return
    yield from _of_one_name(launch)
    if launch.description is None:
        return
    simulated = [control for control in components(project) if simulator_of(project, control) in IN_GAZEBO]
    if not simulated:
        yield from _second(project, launch)
    if not simulated or not project.complete:  # the hardware may depend on an argument that is not known
        return
    hardware = simulated[0]
    where = IN_GAZEBO[simulator_of(project, hardware) or ""]
    for at in _started(launch, launch.description.namespace or ""):
        message = f"ros2_control_node cannot load '{hardware.plugin}'; {where} runs it in its own controller manager"
        fix = Fix("remove ros2_control_node from this launch file, and start the simulator, which loads the plugin")
        yield Finding(at, message, (Note("the hardware is defined here", hardware.at),), fix)


def _of_one_name(launch: Launch) -> Iterator[Finding]:
    """Yield the managers that have the name of one that is started before them, by the same launch file."""
    for nodes in launch.beside or (launch.nodes,):
        first: dict[str, Node] = {}
        for node in manager_nodes(launch._replace(nodes=nodes)):
            if not node.sure or node.namespace is None:
                continue
            name = f"{node.namespace}/{node.name or CONTROLLER_MANAGER}"
            earlier = first.setdefault(name, node)
            if earlier is not node:
                message = f"two controller managers have the name '{name}'; both load the hardware"
                yield Finding(node.at, message, (Note("the other one is here", earlier.at),))


def _started(launch: Launch, namespace: str) -> Iterator[Place]:
    """Yield the places that start ros2_control_node in a namespace; also the calls of MoveIt that do."""
    nodes = manager_nodes(launch)
    yield from (node.at for node in nodes if node.sure and node.namespace == namespace)
    if not nodes and not launch.waiting:
        yield from (load.at for load in launch.loads if load.node == MANAGER and load.sure and load.of == namespace)


def _second(project: Project, launch: Launch) -> Iterator[Finding]:
    """Yield the manager that has the name of the one which a plugin of the robot starts in the simulator."""
    if not any(simulation.sure for simulation in launch.simulations) or not launch.complete:
        return
    hosted = {running.full_name: running for running in simulators_managers(project) if running.namespace is not None}
    for node in manager_nodes(launch):
        name = f"{node.namespace or ''}/{node.name or CONTROLLER_MANAGER}"
        if node.sure and node.namespace is not None and name in hosted:
            message = f"the simulator's plugin starts '{name}' too; the spawners cannot tell the two apart"
            yield Finding(node.at, message, (Note("the plugin is here", hosted[name].at),), severity=Severity.WARNING)
