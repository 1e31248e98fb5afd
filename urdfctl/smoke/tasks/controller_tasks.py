"""The task of each controller, from its claims in the catalogue: joints, gains and wheels."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from urdfctl.catalog.values import elements, is_known
from urdfctl.control.claims import Claim
from urdfctl.control.parameters.values import Values
from urdfctl.control.session import Configured
from urdfctl.smoke.tasks.task import FREE, ControllerTask, Drive, MotionFamily, PidGains
from urdfctl.startup.records import NamedTuple

_BY_CLASS = {
    "ForwardCommandController": MotionFamily.FORWARD,
    "MultiInterfaceForwardCommandController": MotionFamily.FORWARD,
    "JointGroupPositionController": MotionFamily.FORWARD,
    "JointGroupVelocityController": MotionFamily.FORWARD,
    "JointGroupEffortController": MotionFamily.FORWARD,
    "JointPositionController": MotionFamily.FORWARD,
    "JointVelocityController": MotionFamily.FORWARD,
    "JointEffortController": MotionFamily.FORWARD,
    "JointTrajectoryController": MotionFamily.TRAJECTORY,
    "ScaledJointTrajectoryController": MotionFamily.TRAJECTORY,
    "GripperActionController": MotionFamily.TRAJECTORY,
    "PidController": MotionFamily.POSITION_PID,
    "AdmittanceController": MotionFamily.FORWARD,
    "PassthroughController": MotionFamily.FORWARD,
    "DiffDriveController": MotionFamily.DIFFERENTIAL,
    "AckermannSteeringController": MotionFamily.STEERED,
    "BicycleSteeringController": MotionFamily.STEERED,
    "TricycleSteeringController": MotionFamily.STEERED,
    "TricycleController": MotionFamily.STEERED,
}
"""The way each class moves its joints; other classes are not simulated."""
_ROLLING = ("MecanumDriveController", "OmniWheelDriveController")
_ROLES = (("front_left", 1, 1), ("front_right", 1, -1), ("rear_left", -1, 1), ("rear_right", -1, -1))
_COMMANDED = {
    "PositionJointInterface": "position",
    "VelocityJointInterface": "velocity",
    "EffortJointInterface": "effort",
}
_QUANTITIES = ("position", "velocity", "effort")
_ADMITTANCE = "AdmittanceController"
_LIMITING = ("max_effort_interface", "max_velocity_interface", "speed_scaling.command_interface")
"""The parameters that name interfaces by which a controller limits the motion of its joints."""
_PASSED_ON = (MotionFamily.FORWARD, MotionFamily.POSITION_PID, MotionFamily.VELOCITY_PID)
"""The controllers through which others can be followed to the joints."""


class ClaimEnd(NamedTuple):
    """The end of a claim: the joint and the interface that it reaches, through other controllers or directly.

    `loop` is the family of the control loop of these controllers, with its `gains`, or None. `through` holds the names
    of the controllers.
    """

    joint: str
    interface: str
    loop: MotionFamily | None = None
    gains: PidGains = PidGains()
    through: tuple[str, ...] = ()


def tasks_of(controllers: Sequence[Configured]) -> tuple[ControllerTask, ...]:
    """Return what some controllers should move. One that commands another controller moves the joints of that one."""
    below: dict[str, ControllerTask] = {}
    chained = {each.name: each for each in controllers if each.exports.reference}

    def task(configured: Configured, above: tuple[str, ...] = ()) -> ControllerTask:
        for name in {claim.name.partition("/")[0] for claim in configured.claims.command} & chained.keys():
            if name not in below and name not in above:
                below[name] = task(chained[name], (*above, configured.name))
        return _task_of(configured, {name: (below[name], chained[name]) for name in below})

    return tuple(task(configured) for configured in controllers)


def _task_of(configured: Configured, below: Mapping[str, tuple[ControllerTask, Configured]]) -> ControllerTask:
    name, kind = configured.name, configured.type
    if kind is None or kind.claims is None:
        is_declared = configured.controller.declared_at is not None
        return _not_simulated(
            name,
            _why_unknown(configured) if is_declared else "no known file declares it; name the file with --controllers",
        )
    claims = configured.claims.command
    if not claims:
        broadcasts = kind.broadcaster or not kind.claims.command
        return ControllerTask(name, MotionFamily.NOTHING) if broadcasts else _not_simulated(name, "it claims no joint")
    class_name = kind.type.rpartition("/")[2]
    family = _BY_CLASS.get(class_name)
    if class_name in _ROLLING:
        return _rolling(configured, class_name)
    if family is None:
        return _not_simulated(name, f"urdfctl cannot simulate a {class_name}")
    if not configured.claims.complete:
        return _not_simulated(name, "not all of its parameters are known")
    moving = [claim for claim in claims if claim.parameter not in _LIMITING]
    ends: dict[str, ClaimEnd | None] = {}
    for claim in moving:
        known = ends.get(claim.component)
        if known is None or known.interface != "position":  # other interfaces only accompany a commanded position
            ends[claim.component] = _end_of(claim, below)
    if why := _why_not(ends):
        return _not_simulated(name, why)
    return _moving(configured, family, class_name, {component: end for component, end in ends.items() if end})


def _why_unknown(configured: Configured) -> str:
    """That it is not known what a controller moves, and how to say it."""
    given = configured.controller.type
    kind = f"of type '{given.text}' " if given is not None else ""
    return f"what it moves is unknown: describe controllers {kind}in urdfctl.toml, [[controllers]]"


def _why_not(ends: Mapping[str, ClaimEnd | None]) -> str:
    """Why a controller with claims that end there is not simulated, or an empty text."""
    known = [end for end in ends.values() if end]
    if len(known) < len(ends) or not all(end.interface in _QUANTITIES for end in known):
        return "it commands other controllers or devices, not joints"
    alike = {(end.interface, end.loop) for end in known if end.through or any(other.through for other in known)}
    return "it commands joints in different ways" if len(alike) > 1 else ""


def _end_of(claim: Claim, below: Mapping[str, tuple[ControllerTask, Configured]]) -> ClaimEnd | None:
    """The joint at the end of a claim, or None if it ends at another device or cannot be followed."""
    first, _, rest = claim.name.partition("/")
    if first not in below:
        return None if "/" in claim.component else ClaimEnd(claim.component, _quantity(claim.interface))
    task, configured = below[first]
    prefix = f"{first}/"
    offered = dict.fromkeys(
        export.name.removeprefix(prefix).rpartition("/")[0] for export in configured.exports.reference
    )
    wanted = rest.rpartition("/")[0]
    if wanted not in offered or len(offered) != len(task.joints) or task.family not in _PASSED_ON:
        return None
    index = list(offered).index(wanted)
    loop = None if task.family is MotionFamily.FORWARD else task.family
    gains = task.gains[index] if loop else PidGains()
    return ClaimEnd(task.joints[index], task.interface, loop, gains, (first, *task.through))


def _moving(
    configured: Configured, family: MotionFamily, class_name: str, ends: Mapping[str, ClaimEnd]
) -> ControllerTask:
    """The task of a controller of joints, through the controllers that it commands."""
    name, type_name = configured.name, configured.type.type if configured.type else ""
    values = Values(configured.type, configured.values) if configured.type else configured.values
    joints = tuple(dict.fromkeys(end.joint for end in ends.values()))
    first = next(iter(ends.values()))
    through = tuple(dict.fromkeys(step for end in ends.values() for step in end.through))
    left_out = (("compliance", "no force acts on its sensor"),) if class_name == _ADMITTANCE else ()
    task = ControllerTask(name, family, joints, first.interface, through=through, left_out=left_out)
    looped = tuple({end.joint: end.gains for end in ends.values()}.values()) if first.loop else ()
    if family in (MotionFamily.DIFFERENTIAL, MotionFamily.STEERED):
        names = {component: end.joint for component, end in ends.items()}
        return _of_base(task._replace(gains=looped, drive=_renamed(drive_of(family, values), names)))
    family = loop_of(family, class_name, type_name, first.interface, values) if not looped else family
    if looped and family is MotionFamily.POSITION_PID:
        return _not_simulated(name, "it closes a control loop around another one")
    if looped and family is MotionFamily.FORWARD:
        family = first.loop or family
    return task._replace(family=family, gains=looped or tuple(gains_of(configured.values, joint) for joint in joints))


def _renamed(drive: Drive, names: Mapping[str, str]) -> Drive:
    """A drive whose wheels and pivots are named by the controllers that it commands, with the names of the joints."""

    def renamed(wheels: Sequence[str]) -> tuple[str, ...]:
        return tuple(names.get(name, name) for name in wheels)

    return drive._replace(
        left=renamed(drive.left),
        right=renamed(drive.right),
        driven=renamed(drive.driven),
        steered=renamed(drive.steered),
    )


def _rolling(configured: Configured, class_name: str) -> ControllerTask:
    """A controller of wheels with rollers: what they make of the base is computed, not simulated."""
    joints = tuple(dict.fromkeys(claim.component for claim in configured.claims.command))
    kind = configured.type
    values = Values(kind, configured.values) if kind else configured.values
    base = _text(values.get("base_frame_id"))
    if class_name.startswith("Omni"):
        count, offset = max(1, len(joints)), _float(values.get("wheel_offset"))
        angles = tuple(offset + 2 * math.pi * n / count for n in range(count))
        radius, arm = _float(values.get("wheel_radius")), _float(values.get("robot_radius"))
        drive = Drive(driven=joints, base=base, radius=radius, arm=arm, angles=angles)
    else:
        named = [(values.get(f"{role}_wheel_command_joint_name"), ahead, aside) for role, ahead, aside in _ROLES]
        drive = Drive(
            driven=joints,
            base=base,
            radius=_float(values.get("kinematics.wheels_radius")),
            reach=_float(values.get("kinematics.sum_of_robot_center_projection_on_X_Y_axis")),
            roles=tuple((_text(name), ahead, aside) for name, ahead, aside in named if _text(name)),
        )
    offset = any(_float(values.get(f"kinematics.base_frame_offset.{name}")) for name in ("x", "y", "theta"))
    known = drive.radius and (drive.arm or drive.reach) and len(drive.roles or drive.angles) == len(joints)
    why = "its base_frame_offset is not modelled" if offset else "" if known else "its measures are unknown"
    family = MotionFamily.STRUCTURAL if why else MotionFamily.ROLLERS
    return ControllerTask(configured.name, family, joints, "velocity", why=why, rolling=drive)


def _not_simulated(name: str, why: str) -> ControllerTask:
    return ControllerTask(name, MotionFamily.STRUCTURAL, why=why)


def _quantity(interface: str) -> str:
    return _COMMANDED.get(interface.rpartition("/")[2], interface)


def loop_of(
    family: MotionFamily, class_name: str, type_name: str, interface: str, values: Mapping[str, object]
) -> MotionFamily:
    """Return the family of a controller. It closes a loop if it holds another quantity than it commands."""
    if class_name == "PidController":
        held = elements(values.get("reference_and_state_interfaces"))
        return MotionFamily.VELOCITY_PID if held[:1] == ("velocity",) else MotionFamily.POSITION_PID
    if family is MotionFamily.FORWARD and not type_name.startswith("forward_command"):
        if "Position" in class_name and interface != "position":
            return MotionFamily.POSITION_PID
        if "Velocity" in class_name and interface != "velocity":
            return MotionFamily.VELOCITY_PID
    return family


def gains_of(given: Mapping[str, object], joint: str) -> PidGains:
    """Return the gains of a joint, from any place where controllers read them: per joint, or for their only joint."""
    feeds = (given.get(f"gains.{joint}.{name}") for name in ("ff_velocity_scale", "feedforward_gain"))
    feed = next((_float(value) for value in (*feeds, given.get(f"velocity_ff.{joint}")) if _float(value)), 0.0)
    for place in (f"gains.{joint}.", f"{joint}.pid.", "pid.", "gains.", ""):
        if any(isinstance(given.get(f"{place}{name}"), int | float) for name in "pid"):
            p, i, d = (_float(given.get(f"{place}{name}")) for name in "pid")
            clamps = (given.get(f"{place}{name}") for name in ("i_clamp", "i_clamp_max"))
            clamp = next((abs(_float(value)) for value in clamps if _float(value)), math.inf)
            return PidGains(p, i, d, clamp=clamp, feed=feed, prefix=place)
    return PidGains(feed=feed)


def _of_base(task: ControllerTask) -> ControllerTask:
    if task.base and task.base.wheels:
        return task
    return _not_simulated(task.controller, "its parameters name no wheels that it drives")


def drive_of(family: MotionFamily, values: Mapping[str, object]) -> Drive:
    """Return how a base is driven, from the parameters of its controller."""
    return _differential(values) if family is MotionFamily.DIFFERENTIAL else _steered(values)


def _differential(values: Mapping[str, object]) -> Drive:
    scale = _multiplier(values, "wheel_separation_multiplier")
    return Drive(
        _names(values, "left_wheel_names", "left_wheel"),
        _names(values, "right_wheel_names", "right_wheel"),
        radius=_float(values.get("wheel_radius")),
        separation=_float(values.get("wheel_separation")) * scale,
        base=_text(values.get("base_frame_id")),
        left_scale=_scale(values, "left_wheel_radius_multiplier"),
        right_scale=_scale(values, "right_wheel_radius_multiplier"),
        speed=limit_of(values, "linear.x", "velocity"),
        turning=limit_of(values, "angular.z", "velocity"),
        acceleration=limit_of(values, "linear.x", "acceleration"),
        is_folded=scale == 0,
    )


def _steered(values: Mapping[str, object]) -> Drive:
    front = bool(values.get("front_steering", True))
    driven = _names(
        values,
        "traction_joints_names",
        "traction_joint_name",
        "rear_wheels_names" if front else "front_wheels_names",
        "rear_wheel",
    )
    steered = _names(
        values,
        "steering_joints_names",
        "steering_joint_name",
        "front_wheels_names" if front else "rear_wheels_names",
        "front_steer",
    )
    radius = (
        "traction_wheels_radius",
        "traction_wheel_radius",
        "rear_wheels_radius" if front else "front_wheels_radius",
        "wheel_radius",
    )
    return Drive(
        driven=driven,
        steered=steered,
        radius=_first(values, *radius),
        wheelbase=_first(values, "wheelbase", "wheel_separation_h"),
        base=_text(values.get("base_frame_id")),
        track=_first(
            values, "traction_track_width", "wheel_track", "rear_wheel_track" if front else "front_wheel_track"
        ),
        steering_track=_first(values, "steering_track_width", "front_wheel_track" if front else "rear_wheel_track"),
        speed=limit_of(values, "linear", "velocity"),
    )


def _first(values: Mapping[str, object], *names: str) -> float:
    """The first of some parameters that is not 0."""
    return next((number for name in names if (number := _float(values.get(name)))), 0.0)


def _scale(values: Mapping[str, object], *names: str) -> float:
    return _multiplier(values, *names, "wheel_radius_multiplier")


def _multiplier(values: Mapping[str, object], *names: str) -> float:
    """The first of some parameters that is given, also if it is 0; 1 if none is."""
    numbers = (value for name in names if (value := values.get(name)) is not None)
    return next((_float(value) for value in numbers if isinstance(value, int | float)), 1.0)


def limit_of(values: Mapping[str, object], way: str, quantity: str) -> float:
    """Return a limit of a controller on its own command; a flag says in older releases whether it is used."""
    if values.get(f"{way}.has_{quantity}_limits") is False:
        return FREE
    limit = abs(_float(values.get(f"{way}.max_{quantity}")))
    return limit if 0 < limit < FREE else FREE


def _names(values: Mapping[str, object], *names: str) -> tuple[str, ...]:
    lists = (elements(values.get(name)) for name in names)
    return next((tuple(map(str, joints)) for joints in lists if joints), ())


def _text(value: object) -> str:
    return value if isinstance(value, str) and is_known(value) else ""


def _float(value: object) -> float:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else 0.0
