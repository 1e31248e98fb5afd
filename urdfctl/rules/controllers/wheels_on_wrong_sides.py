"""UC446."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.values import elements
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.readers import Reader, in_each_distro

_PAIRS = (("left_wheel", "right_wheel"), ("left_wheel_names", "right_wheel_names"))


@rule(
    "UC446",
    severity=Severity.WARNING,
    authority="diff_drive_controller takes the wheels as they are named",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def wheels_on_wrong_sides(project: Project) -> Iterator[Finding]:
    """The left wheels of a drive are called right, and its right ones left.

    The controller takes them as they are given, and the robot turns to the other side.
    """
    return in_each_distro(project, _swapped)


def _swapped(reader: Reader) -> Iterator[Finding]:
    for left, right in _PAIRS:
        given = reader.located.get(left)
        wrong = _all_say(reader.given, left, "right", "left") and _all_say(reader.given, right, "left", "right")
        if given is not None and left in reader.known and wrong:
            message = f"the wheels of '{left}' are called right, and those of '{right}' left; are they exchanged?"
            yield Finding(given.value.at, message, severity=Severity.WARNING)


def _all_say(values: Mapping[str, object], name: str, word: str, other: str) -> bool:
    names = [str(one).lower() for one in elements(values.get(name))]
    return bool(names) and all(word in one and other not in one for one in names)
