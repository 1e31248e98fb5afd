"""Helpers shared by the rules on controller files."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import FaultKind, FileFault, Section
from urdfctl.rule import Project


def faults(project: Project, *kinds: FaultKind) -> Iterator[FileFault]:
    """Yield the faults of the given kinds for which ROS rejects a controller file."""
    controllers = controllers_in(project)
    for fault in controllers.faults:
        if fault.kind in kinds and is_judged(project, fault.at.source.path):
            yield fault


def is_judged(project: Project, path: str) -> bool:
    """Return whether a file certainly is a controller file for this generation of ROS.

    Its contents show it, or the robot names it as one. Files of MoveIt and other nodes may be listed beside it, and a
    launch file of ROS 1 loads such for any node. UC401 and UC402 report files for the other generation.
    """
    controllers = controllers_in(project)
    file = next((file for file in controllers.files if file.path == path), None)
    if file is None or file.form is None:
        launch = project.launch if project.ros == 2 else None  # noqa: PLR2004 (the generation)
        loads = {load.file.at for load in launch.loads} if launch is not None and launch.ros == 1 else set()
        return any(one.path == path and one.at not in loads for one in controllers.references)
    return project.ros in (None, file.form)


def sections(project: Project) -> Iterator[Section]:
    """Yield each section that names a node once: first those of managers and controllers, then all others."""
    controllers = controllers_in(project)
    by_path = {section.path: section for manager in controllers.managers for section in manager.sections}
    by_path |= {section.path: section for controller in controllers.controllers for section in controller.sections}
    yield from by_path.values()
    yield from controllers.others
