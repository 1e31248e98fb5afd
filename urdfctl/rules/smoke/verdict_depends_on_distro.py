"""UC970."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, found_by_smoke_test

_COMMANDED_MIMIC = GRIPPER.replace(
    '<joint name="finger">\n          <command',
    '<joint name="thumb">\n          «<command_interface name="position"/>»<state_interface name="position"/>\n'
    '        </joint>\n        <joint name="finger">\n          <command',
)


@rule(
    "UC970",
    stage=Stage.ACTIVATE,
    severity=Severity.WARNING,
    runtime="refuses",
    because="some of the possible distros accept the controller",
    message="controller '{controller}' depends on the ROS distro, which is unknown: {verdicts}",
    authority="the controllers, parameters and parsers of each distro, as the catalogue holds them",
    bad={"robot.urdf": _COMMANDED_MIMIC, "controllers.yaml": GRIPPER_CONTROLLER},
    good={"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER},
)
def verdict_depends_on_distro(project: Project) -> Iterator[Finding]:
    """Verdict depends on an unknown ROS distro.

    Neither an option nor a file names the distro, and the controller becomes active in some distros only. The verdict
    of each possible distro is listed. Name yours with `--distro`, or in urdfctl.toml.
    """
    return found_by_smoke_test(project)
