"""UC970."""

from __future__ import annotations

from urdfctl.fault import Severity, Stage, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER

_COMMANDED_MIMIC = GRIPPER.replace(
    '<joint name="finger">\n          <command',
    '<joint name="thumb">\n          «<command_interface name="position"/>»<state_interface name="position"/>\n'
    '        </joint>\n        <joint name="finger">\n          <command',
)


@fault(
    "UC970",
    stage=Stage.ACTIVATE,
    severity=Severity.WARNING,
    runtime="refuses",
    because="some of the possible distros accept the controller",
    authority="the controllers, parameters and parsers of each distro, as the catalogue holds them",
    bad=[{"robot.urdf": _COMMANDED_MIMIC, "controllers.yaml": GRIPPER_CONTROLLER}],
    good=[{"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER}],
)
def verdict_depends_on_distro(controller: str, verdicts: str) -> str:
    """Verdict depends on an unknown ROS distro.

    Neither an option nor a file names the distro, and the controller becomes active in some distros only. The verdict
    of each possible distro is listed, without those whose support ended before 2020, such as indigo and jade. Name
    yours with `--distro`, or in urdfctl.toml.
    """
    return f"controller '{controller}' depends on the ROS distro, which is unknown: {verdicts}"
