"""The stages of a robot's lifecycle under a controller manager."""

from __future__ import annotations

from enum import Enum


class Stage(Enum):
    """The stages that a robot and then each of its controllers pass, in order."""

    SPAWN = "spawn"
    """The robot description is accepted."""
    HARDWARE = "hardware"
    """The hardware components, or the transmissions in ROS 1, are started."""
    PARAMETERS = "parameters"
    """The controllers' parameter files are read."""
    LOAD = "load"
    """A controller is created and declares its parameters. In ROS 1 it also claims its joints."""
    CONFIGURE = "configure"
    """A controller checks its parameters. ROS 1 has no such stage."""
    ACTIVATE = "activate"
    """A controller claims its interfaces. ROS 1 calls this starting."""
    MOVE = "move"
    """A controller moves its joints."""
    DEACTIVATE = "deactivate"
    """A controller releases its interfaces."""


CONTROLLER_STAGES = (Stage.LOAD, Stage.CONFIGURE, Stage.ACTIVATE, Stage.MOVE, Stage.DEACTIVATE)
"""The stages that each controller passes by itself."""


class StageDependsOn(Enum):
    """The fact that decides at which stage a faulty controller stops, if the rule alone does not decide it."""

    PARAMETER_CHECKS = "parameter checks"
    """A parameter does not arrive: the controller stops where it checks that parameter."""
    GAINS = "gains"
    """Gains are missing: some controllers of ROS 1 are not loaded, others crash when they are started."""
    MANAGER = "manager"
    """The fault depends on the other controllers: `urdfctl.control.lifecycle` finds it and its stage."""
    SPAWNER = "spawner"
    """Controllers do not reach a manager: those of the spawner at the place of the fault, or all that are spawned."""
    LOST_JOINTS = "lost joints"
    """Gazebo drops links with their joints: the controllers of these joints stop, or the robot if none is left."""
