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
    controllers = controllers_in(project)
    for fault in controllers.faults:
        if fault.kind in kinds and is_judged(project, fault.at.source.path):
            yield fault


def is_judged(project: Project, path: str) -> bool:
    """Whether a file is surely one of controllers for this generation of ROS: by what it holds, or because the robot
    names it as one. Files of MoveIt and of other nodes may be named beside it; UC401 tells those of the other."""
    controllers = controllers_in(project)
    file = next((file for file in controllers.files if file.path == path), None)
    if file is None or file.form is None:
        return any(reference.path == path for reference in controllers.references)
    return project.ros in (None, file.form)


def sections(project: Project) -> Iterator[Section]:
    """The sections that name a node, each once: those of managers, of controllers, and all others."""
    controllers = controllers_in(project)
    found = {section.path: section for manager in controllers.managers for section in manager.sections}
    found |= {section.path: section for controller in controllers.controllers for section in controller.sections}
    yield from found.values()
    yield from controllers.others
