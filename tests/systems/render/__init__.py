"""Renders a system as a workspace, in the idioms that are chosen."""

from __future__ import annotations

from systems.possible import Idioms
from systems.render.assembly import assembled
from systems.render.distractors import add_distractor
from systems.render.evidence import add_evidence
from systems.render.moveit import assembled_moveit, moveit_places
from systems.render.places import places_of
from systems.render.workspace import ExpectedRobot, Workspace
from systems.system import System

__all__ = ["ExpectedRobot", "Workspace", "render"]


def render(system: System, idioms: Idioms) -> Workspace:
    """Return the workspace of a system."""
    workspace = assembled_moveit(system, idioms) if system.moveit else assembled(system, idioms)
    places = moveit_places(system) if system.moveit else places_of(system, idioms)
    workspace.distros = frozenset({system.distro})
    add_distractor(workspace, places)
    add_evidence(workspace)
    return workspace
