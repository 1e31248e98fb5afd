"""The model of controllers: what controller files configure, their parameters typed and each part with its place."""

from __future__ import annotations

from urdfctl.model.controllers.controllers import (
    Controller,
    Controllers,
    Fault,
    FaultKind,
    FileReference,
    Key,
    Manager,
    MoveItController,
    MoveItList,
    Section,
)
from urdfctl.model.controllers.parameters import Kind, Parameter, Parameters, Value

__all__ = [
    "Controller",
    "Controllers",
    "Fault",
    "FaultKind",
    "FileReference",
    "Key",
    "Kind",
    "Manager",
    "MoveItController",
    "MoveItList",
    "Parameter",
    "Parameters",
    "Section",
    "Value",
]
