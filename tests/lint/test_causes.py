"""A fault that several rules see is reported once, by its cause."""

from __future__ import annotations

import json

import pytest
from folder import Folder

from urdfctl.diagnostic import Diagnostic, Location, Remark, Severity
from urdfctl.lint.findings.causes import LINKS, without_consequences
from urdfctl.lint.findings.merging import merge
from urdfctl.lint.results import Outcome
from urdfctl.lint.selection import Selection
from urdfctl.rules import all_faults

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
BODY = (
    '<inertial><mass value="1"/><inertia ixx="{0}" ixy="0" ixz="0" iyy="{0}" iyz="0" izz="{0}"/></inertial>'
    '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
)
ARM = (
    '<robot name="r"><link name="base"/><link name="fore">{body}</link>'
    '<joint name="elbow" type="revolute"><parent link="base"/><child link="fore"/><axis xyz="0 0 1"/>'
    '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>{more}</robot>'
)
PACKAGE = '<package format="3"><name>{}</name></package>'


def arm(more: str = "", body: str = BODY.format(0.002)) -> str:
    return ARM.format(body=body, more=more)


def control(joint: str, kind: str = "system", hardware: str = "gz_ros2_control/GazeboSimSystem") -> str:
    given = f"<hardware><plugin>{hardware}</plugin></hardware>" if hardware else ""
    return f'<ros2_control name="arm" type="{kind}">{given}<joint name="elbow">{joint}</joint></ros2_control>'


STATE = '<state_interface name="position"/>'


CASES: dict[tuple[str, str], dict[str, str]] = {
    ("UC003", "UC150"): {
        "r.xacro": f'<robot name="r" {XACRO}><xacro:include filename="$(find gone)/m.xacro"/><link name="a"><visual>'
        '<geometry><mesh filename="package://gone/a.stl"/></geometry></visual></link></robot>'
    },
    ("UC023", "UC002"): {
        "body/r.xacro": f'<robot name="r" {XACRO}><xacro:include filename="$(find body)/urdf/m.xacro"/>'
        '<link name="a"/></robot>'
    },
    ("UC028", "UC004"): {
        "r.xacro": f'<robot name="r" {XACRO}><xacro:arg name="tool" default=""/>\n'
        '<xacro:include filename="$(arg tool)"/>\n<link name="$(arg side)_a"/></robot>'
    },
    ("UC117", "UC315"): {
        "r.urdf": arm(
            '<link name="tip"/><joint name="finger" type="revolute"><parent link="fore"/><child link="tip"/>'
            '<limit lower="0" upper="1" effort="1" velocity="1"/><mimic joint="elbw"/></joint>'
            + control(
                '<state_interface name="position"/></joint><joint name="finger"><state_interface name="position"/>'
            )
        )
    },
    ("UC136", "UC137"): {"r.urdf": arm(body=BODY.format(9).replace('izz="9"', 'izz="90"'))},
    ("UC151", "UC149"): {
        "r.urdf": '<robot name="r"><link name="a"><visual><geometry><mesh filename="FOLDER/a.stl"/></geometry>'
        "</visual></link></robot>"
    },
    ("UC303", "UC305"): {"r.urdf": arm(control('<state_interface name="position"/>', "System", ""))},
    ("UC310", "UC337"): {"r.urdf": arm(2 * control(STATE, hardware="mock_components/GenericSystem"))},
    ("UC345", "UC355"): {
        "r.urdf": arm(control('<command_interface name="positon"/><state_interface name="position"/>'))
    },
    ("UC361", "UC513"): {
        "r.urdf": arm(
            '<gazebo><plugin filename="gz_ros2_control-system" '
            'name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>'
        )
    },
}
"""Files in which both of two rules find something, and one fault is behind it."""


@pytest.mark.parametrize("codes", CASES, ids="-".join)
def test_one_fault_is_reported_by_its_cause(folder: Folder, codes: tuple[str, str]) -> None:
    cause, consequence = codes
    folder.write({name: text.replace("FOLDER", str(folder.path)) for name, text in CASES[codes].items()})
    arguments = ("side:=left",) if cause == "UC028" else ()

    def found(selected: str) -> list[str]:
        options = ("--select", selected, "--distro", "jazzy", "--format", "json", "--exit-zero")
        return [
            one["code"]
            for one in json.loads(folder.run("lint", next(iter(CASES[codes])), *arguments, *options).stdout)["findings"]
        ]

    assert set(found(consequence)) == {consequence}
    assert set(found(f"{cause},{consequence}")) == {cause}


def found(code: str, message: str, line: int, severity: Severity = Severity.WARNING, excerpt: str = "") -> Diagnostic:
    at = Location("/r.urdf", line, 1, line, 5, 10 * line, 10 * line + 4)
    return Diagnostic(code, "wrong", severity, message, at, excerpt=excerpt)


def test_the_cause_is_as_severe_as_what_it_explains_and_counts_it() -> None:
    cause = found("UC524", "the robot is in namespace 'a', the controllers are in '/'", 1)
    error = found("UC525", "spawner asks in '/'", 9, Severity.ERROR)
    [one] = without_consequences([error, cause])
    assert (one.code, one.severity) == ("UC524", Severity.ERROR)
    assert one.notes[-1].message == "this explains 1 finding of UC525, not shown"


def test_what_follows_at_the_same_place_needs_no_note() -> None:
    [one] = without_consequences(
        [found("UC136", "<inertia> is impossible", 1), found("UC137", "<inertia> fits 9 m", 1)]
    )
    assert one == found("UC136", "<inertia> is impossible", 1)


def test_a_finding_that_has_another_cause_stays() -> None:
    both = [found("UC136", "<inertia> is impossible", 1), found("UC137", "<inertia> fits 9 m", 2)]
    assert without_consequences(both) == both
    unrelated = [found("UC028", "argument 'tool' is empty", 1), found("UC007", "no 'side'", 2, excerpt="$(arg side)")]
    assert without_consequences(unrelated) == unrelated
    owners = "joint 'j' in component 'b' declares 'j/position', as component 'a' already does; it is dropped here"
    components = [found("UC310", "component name 'a' is already used", 1), found("UC337", owners, 2)]
    assert without_consequences(components) == components
    packages = [found("UC003", "package 'a' was not found", 1), found("UC150", "mesh package 'b' was not found", 2)]
    assert without_consequences(packages) == packages


@pytest.mark.parametrize(
    ("cause", "wrong", "consequence", "missing", "other"),
    [
        (
            "UC345",
            "command interface 'postion' of joint 'elbow' is unknown in ROS 2; did you mean 'position'?",
            "UC450",
            "'elbow' has no 'position' command interface, which controller 'arm' claims",
            "'wrist' has no 'position' command interface, which controller 'arm' claims",
        ),
        (
            "UC312",
            "component 'arm' names joint 'elbw', which the robot does not have; did you mean 'elbow'?",
            "UC450",
            "joint 'elbow' is in the robot, but not in <ros2_control>",
            "joint 'wrist' is in the robot, but not in <ros2_control>",
        ),
        (
            "UC206",
            "transmission 't' names joint 'elbw', which the robot does not have; did you mean 'elbow'?",
            "UC462",
            "joint 'elbow' has no <transmission>",
            "joint 'wrist' has no <transmission>",
        ),
        (
            "UC440",
            "controller 'arm' names joint 'elbw', which the robot does not have; did you mean 'elbow'?",
            "UC467",
            "joint 'elbow' is not commanded by any controller in these files",
            "joint 'wrist' is not commanded by any controller in these files",
        ),
    ],
)
def test_a_misspelt_name_explains_that_the_right_one_is_missing(
    cause: str, wrong: str, consequence: str, missing: str, other: str
) -> None:
    misspelt, unrelated = found(cause, wrong, 1, Severity.ERROR), found(consequence, other, 7)
    left = without_consequences([misspelt, found(consequence, missing, 5), unrelated])
    assert [(one.code, one.message) for one in left] == [(cause, wrong), (consequence, other)]


def test_interfaces_are_missing_because_a_transmission_stands_for_the_joint() -> None:
    cause = found("UC324", "transmission 't' in component 'c' uses the ROS 1 format", 1, Severity.ERROR)
    cause = cause._replace(notes=(Remark('write <joint name="elbow"><command_interface name="position"/></joint>'),))
    of_it, other = (found("UC450", f"no hardware exports '{name}'", 5) for name in ("elbow", "wrist"))
    left = without_consequences([of_it, other, cause])
    assert [one.message for one in left] == [other.message, cause.message]


def test_variants_of_a_robot_share_the_cause_at_a_place() -> None:
    cause, consequence = found("UC436", "'x' is not read", 1), found("UC435", "'x' is deprecated", 1)
    assert [one.code for one in merge([Outcome([cause], []), Outcome([consequence], [])], Selection())] == ["UC436"]


def test_causes_and_consequences_are_rules() -> None:
    codes = {rule.code for rule in all_faults()}
    assert {code for link in LINKS for code in (link.cause, *link.consequences)} <= codes
