"""UC442."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.parameters.readers import controllers_in, type_of
from urdfctl.diagnostic import Edit
from urdfctl.model.controllers import Parameter, Value, ValueKind
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label

_TYPE, _JOINTS = "joint_state_controller/JointStateController", "extra_joints"
_NUMBERS = ("position", "velocity", "effort")
_CONTROLLERS = """
    states:
      type: joint_state_controller/JointStateController
      publish_rate: 50
      extra_joints:
        - {name: caster, position: %s}
"""


@rule(
    "UC442",
    severity=Severity.WARNING,
    runtime="warns",
    distros=ROS1[1:],
    authority="ros_controllers joint_state_controller/src/joint_state_controller.cpp: 'Extra joint 'caster' does not specify "
    "a valid default position. Ignoring.', 'Extra joint does not specify name. Ignoring.'",
    options=["--distro=noetic"],
    bad=[
        {"controllers.yaml": _CONTROLLERS % "«0»"},
        {
            "controllers.yaml": """
                states:
                  type: joint_state_controller/JointStateController
                  publish_rate: 50
                  extra_joints:
                    - «{position: 0.0}»
                    - {name: left_caster, position: «none», velocity: «0»}
                    - {name: right_caster, velocity: 0.0, effort: «1»}
            """,
        },
    ],
    good=[{"controllers.yaml": _CONTROLLERS % "0.0"}],
)
def extra_joint_ignored(project: Project) -> Iterator[Finding]:
    """Extra joint without a name or with an integer value.

    joint_state_controller requires a name, and numbers with a decimal point: XML-RPC, which transports parameters in
    ROS 1, distinguishes 0 from 0.0. Other extra joints are left out of the joint states, with an error in the log.
    """
    for controller in controllers_in(project).controllers:
        given = controller.parameters.value(_JOINTS) if type_of(controller) == _TYPE else None
        for joint in given.items if given is not None else ():
            if joint.kind is ValueKind.MAP:
                yield from _faults(joint)


def _faults(joint: Value) -> Iterator[Finding]:
    fields = {field.name: field for field in joint.fields}
    if "name" not in fields:
        yield Finding(joint.at, "extra joint has no name and is ignored; add one, e.g. 'name: caster_joint'")
        return
    for field in (fields[name] for name in _NUMBERS if name in fields):
        if field.value.kind not in (ValueKind.FLOAT, ValueKind.UNKNOWN):
            yield Finding(field.value.at, _message(fields["name"], field), fix=_fix(field.value))


def _message(name: Parameter, field: Parameter) -> str:
    joint = label("extra joint", name.value.text)
    return f"{field.name} of {joint} must be a number with a decimal point; the joint is ignored"


def _fix(value: Value) -> Fix | None:
    if value.kind is not ValueKind.INT:
        return None
    right = f"{value.value}.0"
    return Fix(f"write {right}", (Edit(value.at.span, right),), safe=True)
