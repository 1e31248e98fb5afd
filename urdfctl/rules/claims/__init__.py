"""UC4: what a controller manager refuses of a robot's controllers together: claims, chains and conflicts."""

from __future__ import annotations

from urdfctl.rule import Rule
from urdfctl.rules.claims.command_interface_not_exported import command_interface_not_exported
from urdfctl.rules.claims.state_interface_not_exported import state_interface_not_exported

RULES: tuple[Rule, ...] = (
    command_interface_not_exported,
    state_interface_not_exported,
)
