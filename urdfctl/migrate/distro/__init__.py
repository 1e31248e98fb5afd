"""Steps from one ROS 2 distro to a later one."""

from __future__ import annotations

from urdfctl.migrate.distro.activation import ACTIVATION
from urdfctl.migrate.distro.controller_commands import CONTROLLER_COMMANDS
from urdfctl.migrate.distro.feedforward import FEEDFORWARD
from urdfctl.migrate.distro.ignition_commands import IGNITION_COMMANDS
from urdfctl.migrate.distro.launch_python import LAUNCH_PYTHON
from urdfctl.migrate.distro.launch_xml import LAUNCH_XML
from urdfctl.migrate.distro.mimic import MIMIC
from urdfctl.migrate.distro.moveit import MOVEIT
from urdfctl.migrate.distro.names import NAMES
from urdfctl.migrate.distro.open_loop import OPEN_LOOP
from urdfctl.migrate.distro.parameters import PARAMETERS
from urdfctl.migrate.distro.prefix import PREFIX
from urdfctl.migrate.distro.spawner_types import SPAWNER_TYPES
from urdfctl.migrate.distro.stamped import STAMPED, STAMPED_TOPICS
from urdfctl.migrate.distro.stamped_nodes import STAMPED_NODES
from urdfctl.migrate.distro.types import DEPENDENCIES, TYPES
from urdfctl.migrate.step import Step

STEPS: tuple[Step, ...] = (
    *NAMES,
    PREFIX,
    MIMIC,
    TYPES,
    DEPENDENCIES,
    ACTIVATION,
    OPEN_LOOP,
    FEEDFORWARD,
    PARAMETERS,
    STAMPED,
    STAMPED_TOPICS,
    STAMPED_NODES,
    SPAWNER_TYPES,
    LAUNCH_PYTHON,
    LAUNCH_XML,
    CONTROLLER_COMMANDS,
    IGNITION_COMMANDS,
    MOVEIT,
)
