"""Literal findings for the tests of the report formats."""

from __future__ import annotations

from folder import Folder

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.results import Outcome, Report, TargetResult


def of_a_macro(folder: Folder) -> Diagnostic:
    """Return an error in a macro that is called twice, with notes and a fix."""
    file, robot = str(folder.path / "urdf/große wheel.xacro"), str(folder.path / "r.xacro")
    return Diagnostic(
        "UC201",
        "transmission-joint-without-interface",
        Severity.ERROR,
        "joint 'größe' has no <hardwareInterface>",
        Location(file, 12, 7, 12, 28, 310, 333),
        (
            (
                CallStep(file, 4, 3, "macro wheel"),
                CallStep(robot, 6, 3, "macro axle"),
                CallStep("/out.xacro", 1, 1, "include r"),
            ),
            (CallStep(robot, 7, 3, "macro wheel"),),
        ),
        (Remark("so it is", Location(file, 14, 1, 14, 3, 400, 402)), Remark("for noetic")),
        Repair("add it", safe=True, edits=(ShownEdit(Location(file, 12, 26, 12, 28, 331, 333), "><x/></joint>"),)),
        '      <joint name="größe"/>',
    )


def bare(severity: Severity, message: str = "it is so", file: str = "/elsewhere/r.urdf") -> Diagnostic:
    """Return a finding with nothing but a place, which spans two lines."""
    return Diagnostic("UC105", "several-root-links", severity, message, Location(file, 1, 2, 3, 4, 1, 40))


def report(folder: Folder, *findings: Diagnostic, fail_on: Severity = Severity.ERROR) -> Report:
    """Return a report on the robot r.xacro."""
    path = str(folder.path / "r.xacro")
    robot = TargetResult(path, 1, "noetic", "--distro", None, True, False, "r", 2, (path,), Outcome(list(findings), []))
    return Report((robot,), findings, fail_on=fail_on)
