"""The model of launch files: what they are known to do with robots and controllers, and the package around them."""

from __future__ import annotations

from urdfctl.model.launch.launch import Launch
from urdfctl.model.launch.package import LeftOut, Package
from urdfctl.model.launch.parts import (
    UNCHANGED,
    Description,
    GivenParameters,
    InlineParameters,
    LaunchedFile,
    Node,
    ParameterLoad,
    ProgramOption,
    Rewriting,
    Simulation,
    Spawn,
    Started,
    Waiting,
    Word,
    joined,
)

__all__ = [
    "UNCHANGED",
    "Description",
    "GivenParameters",
    "InlineParameters",
    "Launch",
    "LaunchedFile",
    "LeftOut",
    "Node",
    "Package",
    "ParameterLoad",
    "ProgramOption",
    "Rewriting",
    "Simulation",
    "Spawn",
    "Started",
    "Waiting",
    "Word",
    "joined",
]
