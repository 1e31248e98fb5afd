"""Sections of controllers' files that a controller does not read, though they were meant for it."""

from __future__ import annotations

from urdfctl.model.controllers import Controller, Controllers, Section
from urdfctl.suggest import nearest


def meant_for(controllers: Controllers, controller: Controller) -> Section | None:
    """The section that a controller without one does not read: under its name in another namespace, or misspelt."""
    if controller.sections or not controllers.others:
        return None
    same = controllers.other(controller.name)
    if same is not None:
        return same
    name = nearest(controller.name, [section.name for section in controllers.others])
    section = controllers.other(name) if name else None
    alike = [one for one in controllers.controllers if not one.sections]
    closest = nearest(section.name, [one.name for one in alike]) if section else None
    return section if closest == controller.name else None
