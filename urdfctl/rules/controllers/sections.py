"""Sections of controller files that are meant for a controller but not read by it."""

from __future__ import annotations

from urdfctl.model.controllers import Controller, Controllers, Section
from urdfctl.names import nearest


def meant_for(controllers: Controllers, controller: Controller) -> Section | None:
    """Return the section meant for a controller that has none: its name in another namespace, or misspelt."""
    if controller.sections or not controllers.others:
        return None
    same = controllers.other(controller.name)
    if same is not None:
        return same
    name = nearest(controller.name, [section.name for section in controllers.others])
    section = controllers.other(name) if name else None
    without_section = [each.name for each in controllers.controllers if not each.sections]
    closest = nearest(section.name, without_section) if section else None
    return section if closest == controller.name else None
