"""The stage at which an error that lint found in the files stops a controller."""

from __future__ import annotations

from functools import cache

from urdfctl.catalog.values import is_set
from urdfctl.control.gains import Fate, missing_gains
from urdfctl.control.life import STAGES, stage_of_breach
from urdfctl.control.parameter_rules import breaches
from urdfctl.control.session import Configured
from urdfctl.diagnostic import Diagnostic
from urdfctl.model.stage import CONTROLLER_STAGES, Stage, StageDependsOn
from urdfctl.rules import stage_of

_stage_of = cache(stage_of)


def stops_robot(error: Diagnostic) -> bool:
    """Return whether the robot cannot be spawned with an error of lint."""
    return _stage_of(error.code) is Stage.SPAWN


def stops_hardware(error: Diagnostic) -> bool:
    """Return whether the hardware cannot be started with an error of lint."""
    return _stage_of(error.code) is Stage.HARDWARE


def stops_parameters(code: str) -> bool:
    """Return whether an error of a rule keeps a controller file from being read, for all of its controllers."""
    return _stage_of(code) is Stage.PARAMETERS


def found_by_manager(error: Diagnostic) -> bool:
    """Return whether `urdfctl.control.life` finds an error of lint by itself, in the order of starting."""
    return _stage_of(error.code) is StageDependsOn.MANAGER


def loses_joints(error: Diagnostic) -> bool:
    """Return whether an error of lint is about links that Gazebo drops."""
    return _stage_of(error.code) is StageDependsOn.LOST_JOINTS


def stops_controller(error: Diagnostic) -> bool:
    """Return whether an error of lint stops controllers: by itself, and not by what a controller manager works out."""
    return _stage_of(error.code) not in {None, Stage.SPAWN, Stage.HARDWARE, StageDependsOn.MANAGER}


def stage_stopped(error: Diagnostic, configured: Configured, ros: int) -> Stage:
    """Return the stage at which an error of lint stops a controller, in ROS 1 or 2."""
    stage = _stage_of(error.code)
    if ros == 1:
        return _stage_without_gains(configured) if stage is StageDependsOn.GAINS else Stage.LOAD
    if stage is StageDependsOn.PARAMETER_CHECKS:
        return _stage_of_parameter_checks(configured)
    if stage is StageDependsOn.LOST_JOINTS:
        return Stage.ACTIVATE
    return stage if isinstance(stage, Stage) and stage in CONTROLLER_STAGES else Stage.LOAD


def _stage_without_gains(configured: Configured) -> Stage:
    """Without gains some controllers of ROS 1 are not loaded, others crash when they are started."""
    if configured.type is None:
        return Stage.LOAD
    fates = {missing.fate for missing in missing_gains(configured.type, configured.values)}
    return Stage.ACTIVATE if Fate.CRASH in fates and Fate.REFUSED not in fates else Stage.LOAD


def _stage_of_parameter_checks(configured: Configured) -> Stage:
    """A missing parameter with a check of its own fails when it is declared, on load; others when configuring."""
    kind = configured.type
    if kind is None:
        return Stage.LOAD
    required = (name for name, parameter in kind.parameters.items() if parameter.needed and not parameter.is_map)
    if any(not is_set(configured.values.get(name)) for name in required):
        return Stage.LOAD
    broken = [breach.rule for breach in breaches(kind, configured.values) if breach.rule.severity == "error"]
    return min(map(stage_of_breach, broken), key=STAGES.index, default=Stage.CONFIGURE)
