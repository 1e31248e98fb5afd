"""The task of each controller: the one that its parameters give, or one of the user."""

from __future__ import annotations

from urdfctl.smoke.tasks.controller_tasks import tasks_of
from urdfctl.smoke.tasks.goals import (
    CRUISE,
    FREELY,
    MOTION,
    PART_OF_SPEED,
    TURN,
    Goal,
    effort_of,
    fastest,
    goal_of,
    speed_of,
    turning_of,
)
from urdfctl.smoke.tasks.inferred_drives import with_inferred_drives
from urdfctl.smoke.tasks.suspension import suspended_wheels
from urdfctl.smoke.tasks.task import FREE, ControllerTask, Drive, MotionFamily, PidGains
from urdfctl.smoke.tasks.task_file import TaskFile, UserTask, read_tasks
from urdfctl.smoke.tasks.task_file_check import Misfit, misfits

__all__ = [
    "CRUISE",
    "FREE",
    "FREELY",
    "MOTION",
    "PART_OF_SPEED",
    "TURN",
    "ControllerTask",
    "Drive",
    "Goal",
    "Misfit",
    "MotionFamily",
    "PidGains",
    "TaskFile",
    "UserTask",
    "effort_of",
    "fastest",
    "goal_of",
    "misfits",
    "read_tasks",
    "speed_of",
    "suspended_wheels",
    "tasks_of",
    "turning_of",
    "with_inferred_drives",
]
