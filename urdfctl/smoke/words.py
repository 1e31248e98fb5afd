"""The words in which the controller managers refuse a controller, so that people recognise what they see in their logs.

ROS 2: controller_manager.cpp, as jazzy says it; ROS 1: controller_manager.cpp and hardware_interface of noetic.
"""

from __future__ import annotations

from urdfctl.control.claims import Claim
from urdfctl.control.hardware import Kind
from urdfctl.control.life import Reason, Stop
from urdfctl.control.session import Configured
from urdfctl.smoke.results import Step

_OF_STEP = {
    1: {
        Step.LOAD: "Initializing controller '{name}' failed",
        Step.ACTIVATE: "Could not start controller with name '{name}'",
    },
    2: {
        Step.LOAD: "Could not initialize the controller named '{name}'",
        Step.CONFIGURE: "After configuring, controller '{name}' is in state 'unconfigured' , expected inactive.",
        Step.ACTIVATE: "After activation, controller '{name}' is in state 'inactive' , expected active",
    },
}


def words_of_step(one: Configured, step: Step, ros: int) -> str:
    """What the manager prints last of a controller that does not get past a step."""
    return _OF_STEP[ros].get(step, _OF_STEP[ros][Step.LOAD]).format(name=one.name)


def words_of(one: Configured, stop: Stop, ros: int) -> str:
    """What the manager prints of a stop."""
    written = one.controller.type.text if one.controller.type else ""
    if stop.reason is Reason.TYPE_UNKNOWN and not written:
        stop = stop._replace(reason=Reason.TYPE_MISSING)
    claim = stop.claim.name if stop.claim else ""
    if ros == 1:
        return _of_ros1(one, stop, written)
    if stop.reason is Reason.TYPE_UNKNOWN:
        return f"Loader for controller '{one.name}' (type '{written}') not found."
    if stop.reason is Reason.TYPE_MISSING:
        return f"The 'type' param was not defined for '{one.name}'."
    if stop.reason is Reason.CLAIMED_TWICE:
        return (
            f"The command interfaces of the controller '{one.name}' are not unique. Please make sure that the command "
            "interfaces are unique"
        )
    if stop.reason is Reason.CONFLICT:
        return _not_taken(one, f"command interface '{claim}' is currently claimed by another controller.")
    if stop.reason in (Reason.NOT_OFFERED, Reason.NOT_EXPORTED):
        return _not_taken(one, f"{stop.kind.value} interface '{claim}' is not available.")
    return words_of_step(one, Step(stop.stage.value), ros)


def _not_taken(one: Configured, why: str) -> str:
    return f"Unable to activate controller '{one.name}' since the {why}"


def _of_ros1(one: Configured, stop: Stop, written: str) -> str:
    if stop.reason is Reason.TYPE_UNKNOWN:
        return f"Could not load controller '{one.name}' because controller type '{written}' does not exist."
    if stop.reason is Reason.TYPE_MISSING:
        return f"Could not load controller '{one.name}' because the type was not specified."
    if stop.reason is Reason.NOT_OFFERED and stop.claim:
        interface = stop.claim.interface.replace("/", "::")
        return f"Could not find resource '{stop.claim.component}' in '{interface}'."
    if stop.reason in (Reason.CONFLICT, Reason.CLAIMED_TWICE):
        return "Could not switch controllers, due to resource conflict"
    return words_of_step(one, Step(stop.stage.value), 1)


def _in_ros1(claim: Claim | None) -> str:
    """A joint and the interface of ROS 1 in which a controller wants it; empty for one of ROS 2."""
    if claim is None or not claim.interface.startswith("hardware_interface/"):
        return ""
    return f"'{claim.component}' in the {claim.interface.partition('/')[2]}"


def told(stop: Stop) -> str:
    """A stop in our words."""
    claim = f"'{stop.claim.name}'" if stop.claim else ""
    other = f"'{stop.other.name}'" if stop.other else "another controller"
    kind = "command" if stop.kind is Kind.COMMAND else "state"
    return {
        Reason.TYPE_MISSING: "its type is not given",
        Reason.TYPE_UNKNOWN: "its type is not known in this distro",
        Reason.PARAMETERS: stop.words,
        Reason.NOT_OFFERED: f"no hardware offers {_in_ros1(stop.claim) or f'the {kind} interface {claim}'}",
        Reason.NOT_EXPORTED: f"controller {other} does not export {claim}",
        Reason.NOT_CHAINABLE: f"it wants {claim} of controller {other}, which exports nothing",
        Reason.CLAIMED_TWICE: f"it claims {claim} twice",
        Reason.CONFLICT: f"controller {other} has claimed {claim} before it",
        Reason.NOT_STARTED: f"it needs {claim} of controller {other}, which is not started before it",
        Reason.CIRCLE: "it and others wait for each other's interfaces in a circle",
    }[stop.reason]
