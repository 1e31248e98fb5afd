"""UC7: migration to later distros."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.migration.controller_deprecated import controller_deprecated
from urdfctl.rules.migration.controller_gone_soon import controller_gone_soon
from urdfctl.rules.migration.gazebo_classic_gone import gazebo_classic_gone
from urdfctl.rules.migration.hardware_deprecated import hardware_deprecated
from urdfctl.rules.migration.hardware_gone_soon import hardware_gone_soon
from urdfctl.rules.migration.migration_todo_left import migration_todo_left
from urdfctl.rules.migration.plugin_deprecated import plugin_deprecated
from urdfctl.rules.migration.plugin_gone_soon import plugin_gone_soon

FAULTS: tuple[Fault, ...] = (
    gazebo_classic_gone,
    plugin_deprecated,
    hardware_deprecated,
    controller_deprecated,
    plugin_gone_soon,
    hardware_gone_soon,
    controller_gone_soon,
    migration_todo_left,
)
