"""UC446."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.values import elements
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.rule import Finding, Project, Severity, rule

_PAIRS = (("left_wheel", "right_wheel"), ("left_wheel_names", "right_wheel_names"))


@rule(
    "UC446",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="diff_drive_controller uses the wheels as listed",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: «[right_wheel_joint]»
                    right_wheel_names: [left_wheel_joint]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """
        },
        {
            "options": "--distro=noetic",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                base:
                  type: diff_drive_controller/DiffDriveController
                  left_wheel: «[front_right, rear_right]»
                  right_wheel: [front_left, rear_left]
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: [left_wheel_joint]
                    right_wheel_names: [right_wheel_joint]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """
        },
    ],
)
def wheels_on_wrong_sides(project: Project) -> Iterator[Finding]:
    """Left and right wheels are swapped.

    The controller uses the wheels as listed, so the robot turns to the wrong side.
    """
    return in_each_distro(project, _swapped)


def _swapped(reader: Reader) -> Iterator[Finding]:
    for left, right in _PAIRS:
        given = reader.located.get(left)
        wrong = _all_say(reader.given, left, "right", "left") and _all_say(reader.given, right, "left", "right")
        if given is not None and left in reader.known and wrong:
            message = f"'{left}' lists right wheels, and '{right}' lists left wheels; they are probably swapped"
            yield Finding(given.value.at, message, severity=Severity.WARNING)


def _all_say(values: Mapping[str, object], name: str, word: str, other: str) -> bool:
    wheels = [str(wheel).lower() for wheel in elements(values.get(name))]
    return bool(wheels) and all(word in wheel and other not in wheel for wheel in wheels)
