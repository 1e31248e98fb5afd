"""The lines with which the controller managers reject a controller, so that people recognise them from their logs.

ROS 2: controller_manager.cpp of jazzy. ROS 1: controller_manager.cpp and hardware_interface of noetic.
"""

from __future__ import annotations

from urdfctl.control.claims import Claim
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.lifecycle import Reason, Stop
from urdfctl.control.session import Configured
from urdfctl.model.stage import Stage

_LINE_OF_STAGE = {
    1: {
        Stage.LOAD: "Initializing controller '{name}' failed",
        Stage.ACTIVATE: "Could not start controller with name '{name}'",
    },
    2: {
        Stage.LOAD: "Could not initialize the controller named '{name}'",
        Stage.CONFIGURE: "After configuring, controller '{name}' is in state 'unconfigured' , expected inactive.",
        Stage.ACTIVATE: "After activation, controller '{name}' is in state 'inactive' , expected active",
    },
}


def line_of_stage(configured: Configured, stage: Stage, ros: int) -> str:
    """Return the last line that the manager prints about a controller that does not pass a stage."""
    lines = _LINE_OF_STAGE[ros]
    return lines.get(stage, lines[Stage.LOAD]).format(name=configured.name)


def line_of_stop(configured: Configured, stop: Stop, ros: int) -> str:
    """Return the line that the manager prints when it rejects a controller."""
    name = configured.name
    type_name = configured.controller.type.text if configured.controller.type else ""
    if stop.reason is Reason.TYPE_UNKNOWN and not type_name:
        stop = stop._replace(reason=Reason.TYPE_MISSING)
    claim = stop.claim.name if stop.claim else ""
    if ros == 1:
        return _line_of_ros1(configured, stop, type_name)
    if stop.reason is Reason.TYPE_UNKNOWN:
        return f"Loader for controller '{name}' (type '{type_name}') not found."
    if stop.reason is Reason.TYPE_MISSING:
        return f"The 'type' param was not defined for '{name}'."
    if stop.reason is Reason.CLAIMED_TWICE:
        return (
            f"The command interfaces of the controller '{name}' are not unique. Please make sure that the command "
            "interfaces are unique"
        )
    if stop.reason is Reason.CONFLICT:
        return _not_activated(name, f"command interface '{claim}' is currently claimed by another controller.")
    if stop.reason in (Reason.NOT_OFFERED, Reason.NOT_EXPORTED):
        return _not_activated(name, f"{stop.kind.value} interface '{claim}' is not available.")
    return line_of_stage(configured, stop.stage, ros)


def _not_activated(name: str, why: str) -> str:
    return f"Unable to activate controller '{name}' since the {why}"


def _line_of_ros1(configured: Configured, stop: Stop, type_name: str) -> str:
    name = configured.name
    if stop.reason is Reason.TYPE_UNKNOWN:
        return f"Could not load controller '{name}' because controller type '{type_name}' does not exist."
    if stop.reason is Reason.TYPE_MISSING:
        return f"Could not load controller '{name}' because the type was not specified."
    if stop.reason is Reason.NOT_OFFERED and stop.claim:
        interface = stop.claim.interface.replace("/", "::")
        return f"Could not find resource '{stop.claim.component}' in '{interface}'."
    if stop.reason in (Reason.CONFLICT, Reason.CLAIMED_TWICE):
        return "Could not switch controllers, due to resource conflict"
    return line_of_stage(configured, stop.stage, 1)


def _resource_of_ros1(claim: Claim | None) -> str:
    """A joint and its interface in ROS 1, empty for a claim in ROS 2."""
    if claim is None or not claim.interface.startswith("hardware_interface/"):
        return ""
    return f"joint '{claim.component}' in the {claim.interface.partition('/')[2]}"


def reason_of(stop: Stop) -> str:
    """Return why a controller is stopped, in urdfctl's words."""
    claim = f"'{stop.claim.name}'" if stop.claim else ""
    other = f"controller '{stop.other.name}'" if stop.other else "another controller"
    kind = "command" if stop.kind is ClaimKind.COMMAND else "state"
    return {
        Reason.TYPE_MISSING: "its type is missing",
        Reason.TYPE_UNKNOWN: "its type does not exist in this ROS distro",
        Reason.PARAMETERS: stop.words,
        Reason.NOT_ACTIVE: stop.words,
        Reason.NOT_OFFERED: f"no hardware offers {_resource_of_ros1(stop.claim) or f'the {kind} interface {claim}'}",
        Reason.NOT_EXPORTED: f"{other} does not export {claim}",
        Reason.NOT_CHAINABLE: f"it claims {claim} of {other}, which exports no interfaces",
        Reason.NOTHING_TO_CLAIM: "the hardware exports no interface that it could claim",
        Reason.CLAIMED_TWICE: f"it claims {claim} twice",
        Reason.CONFLICT: f"{other} has already claimed {claim}",
        Reason.NOT_STARTED: f"it needs {claim} of {other}, which is not started before it",
        Reason.CIRCLE: "it and other controllers wait for each other's interfaces in a loop",
    }[stop.reason]
