"""What the rules on controllers' files share."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Controllers, Fault, FaultKind, Section
from urdfctl.rule import Project

NOTHING = Controllers(())


def controllers_in(project: Project) -> Controllers:
    """What the controllers' files say; of a project without any, nothing."""
    return project.controllers or NOTHING


def faults(project: Project, *kinds: FaultKind) -> Iterator[Fault]:
    """What the readers of the controllers' files refuse, of some kinds."""
    for fault in controllers_in(project).faults:
        if fault.kind in kinds:
            yield fault


def sections(project: Project) -> Iterator[Section]:
    """The sections that name a node, each once: those of managers, of controllers, and all others."""
    controllers = controllers_in(project)
    found = {section.path: section for manager in controllers.managers for section in manager.sections}
    found |= {section.path: section for controller in controllers.controllers for section in controller.sections}
    yield from found.values()
    yield from controllers.others
