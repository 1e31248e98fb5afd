"""The model of controllers: what controller files configure, their parameters typed and each part with its place."""

from __future__ import annotations

from urdfctl.model.controllers.controllers import (
    Controller,
    Controllers,
    FaultKind,
    FileFault,
    FileReference,
    Key,
    Manager,
    MoveItController,
    MoveItList,
    Section,
)
from urdfctl.model.controllers.parameters import Parameter, Parameters, Value, ValueKind

__all__ = [
    "Controller",
    "Controllers",
    "FaultKind",
    "FileFault",
    "FileReference",
    "Key",
    "Manager",
    "MoveItController",
    "MoveItList",
    "Parameter",
    "Parameters",
    "Section",
    "Value",
    "ValueKind",
]
