"""Steps from ROS 1 to ROS 2: those for robots and controllers, then those for the packages around them."""

from __future__ import annotations

from urdfctl.migrate.ros1.aliases import ALIASES
from urdfctl.migrate.ros1.claimed import CLAIMED
from urdfctl.migrate.ros1.classic_plugins import PLUGINS
from urdfctl.migrate.ros1.controller_names import CONTROLLER_NAMES
from urdfctl.migrate.ros1.controllers_yaml import CONTROLLERS
from urdfctl.migrate.ros1.file_arguments import FILE_ARGUMENTS
from urdfctl.migrate.ros1.inline_controllers import INLINE_CONTROLLERS
from urdfctl.migrate.ros1.joint_gains import JOINT_GAINS
from urdfctl.migrate.ros1.launch_files import LAUNCH_FILES
from urdfctl.migrate.ros1.manifest import MANIFEST
from urdfctl.migrate.ros1.moveit_files import MOVEIT_FILES
from urdfctl.migrate.ros1.moveit_launch import MOVEIT_LAUNCH
from urdfctl.migrate.ros1.nested import NESTED
from urdfctl.migrate.ros1.node_files import NODE_FILES
from urdfctl.migrate.ros1.prefixes import PREFIXES
from urdfctl.migrate.ros1.simulator_plugin import MIMIC_PLUGINS, SIMULATOR_PLUGIN
from urdfctl.migrate.ros1.spawned_namespace import SPAWNED_NAMESPACE
from urdfctl.migrate.ros1.switches import SWITCHES
from urdfctl.migrate.ros1.transmissions import TRANSMISSIONS
from urdfctl.migrate.step import Step

ROBOT_STEPS: tuple[Step, ...] = (
    PREFIXES,
    SWITCHES,
    MIMIC_PLUGINS,
    TRANSMISSIONS,
    NESTED,
    INLINE_CONTROLLERS,
    SIMULATOR_PLUGIN,
    SPAWNED_NAMESPACE,
    PLUGINS,
    CONTROLLER_NAMES,
    MOVEIT_FILES,
    JOINT_GAINS,
    FILE_ARGUMENTS,
    ALIASES,
    CONTROLLERS,
    CLAIMED,
)
PACKAGE_STEPS: tuple[Step, ...] = (MOVEIT_LAUNCH, NODE_FILES, LAUNCH_FILES, MANIFEST)
STEPS: tuple[Step, ...] = (*ROBOT_STEPS, *PACKAGE_STEPS)
