"""A move_group beside a robot: the description is the same file, with another argument where the robot is started, and
with the same arguments where its controllers are spawned."""

from __future__ import annotations

from dataclasses import replace

from systems.render.actions import Description, Node, Param, ParamFile, Share, Value
from systems.render.arguments import Values
from systems.render.parameters import Tree, dumped
from systems.render.places import Places, config_folder
from systems.system import Robot, System

PARAMETERS = "planning.yaml"


def move_group(values: Values, namespace: Value) -> Node:
    """Return the node, in the namespace of its robot."""
    planned = found = values.description
    if values.idioms["planner"] == "other arguments":
        planned = replace(found, mappings=(*found.mappings, ("planning", ("true",))))
    places, folder = values.places, config_folder(values.system)
    semantic = Description((Share((places.description,), (("srdf",), (f"{values.robot.model}.srdf",))),), (), True)
    file = ParamFile((Share((places.control,), ((folder,), (PARAMETERS,))),))
    parameters = (Param("robot_description", planned), Param("robot_description_semantic", semantic), file)
    return Node("moveit_ros_move_group", "move_group", "", namespace, parameters)


def planner_files(system: System, places: Places) -> dict[str, str]:
    """Return what the node reads: the groups of joints, and the planners."""
    (robot,) = system.robots
    plugin = "ompl_interface/OMPLPlanner"
    planners: Tree = {"planning_plugin": plugin} if system.distro == "humble" else {"planning_plugins": [plugin]}
    parameters = {"planning_pipelines": ["ompl"], "ompl": planners}
    return {
        f"{places.description}/srdf/{robot.model}.srdf": _groups(robot),
        f"{places.control}/{config_folder(system)}/{PARAMETERS}": dumped({"/**": {"ros__parameters": parameters}}),
    }


def _groups(robot: Robot) -> str:
    joints = "".join(f'    <joint name="{robot.prefix}{joint.name}"/>\n' for joint in robot.joints)
    return f'<?xml version="1.0"?>\n<robot name="{robot.model}">\n  <group name="all">\n{joints}  </group>\n</robot>\n'
