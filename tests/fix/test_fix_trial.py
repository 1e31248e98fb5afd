"""What a trial of edits says of a robot before and after them, and what a run of trials makes of the files."""

from __future__ import annotations

import os
from typing import Any

import pytest
from folder import Folder

from urdfctl.commands.running import run_words
from urdfctl.config.settings import Settings
from urdfctl.fix.edits import Splice, edited
from urdfctl.fix.rounds import FixOptions, fixed
from urdfctl.fix.trial import TrialResult, trial_work
from urdfctl.lint.job import job_for, perform_alone, run_on_targets
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

MACRO = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="turning" params="name type">
    <link name="${name}_link">
      <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    </link>
    <joint name="${name}" type="${type}">
      <parent link="world"/><child link="${name}_link"/><limit lower="1" upper="-1" effort="1" velocity="1"/>
    </joint>
  </xacro:macro>
  <link name="world"/>
  <xacro:turning name="elbow" type="revolute"/>
</robot>
"""
SECOND = '  <xacro:turning name="wheel" type="TYPE"/>\n</robot>'
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
arm:
  ros__parameters:
    joints: [elbow]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
    constraints:
      goal_time: 1
"""
SETTINGS = Settings(distro="jazzy", simulator="none")


Written = tuple[str, str, str]
"""A text that stands before what is edited, what stands there, and what is written for it."""


def tried(folder: Folder, before: str, edits: list[Written], name: str = "arm.xacro") -> TrialResult:
    """What a trial says of some edits."""
    folder.write({name: before})
    path = str(folder.path / name)
    splices = []
    for ahead, old, new in edits:
        start = before.index(ahead + old) + len(ahead)
        splices.append(Splice(path, start, start + len(old), new))
    states = {"before": {path: before}, "after": {path: edited(before.encode(), splices).decode()}}
    details = {**states, "splices": [list(splice) for splice in splices]}
    return TrialResult.from_json(perform_alone(job_for(trial_work, Target(path), SETTINGS, details=details)))


HEAVY = MACRO.replace('value="1"', 'value="${m}"').replace("  <link", '  <xacro:property name="m" value="1"/>\n  <link')
LIMITS = 'lower="1" upper="-1"', 'lower="-1" upper="1"'
BOTH = [('lower="', "1", "-1"), ('upper="', "-1", "1")]


def test_edits_that_a_finding_asks_for_are_asked_for_and_leave_it_gone(folder: Folder) -> None:
    verdict = tried(folder, MACRO, BOTH)
    assert verdict.objections == ()
    assert len(verdict.asked_for) == 2
    assert verdict.linted is not None
    assert "UC125" not in [one.code for one in verdict.linted.outcome.diagnostics]


def test_what_is_only_worth_knowing_may_come_in_the_place_of_a_warning_and_is_told(folder: Folder) -> None:
    verdict = tried(folder, MACRO, [*BOTH, ('xacro">\n', "", '<xacro:arg name="spare" default="1"/>\n')])
    assert [one for one in verdict.objections if "would cause" in one] == []
    assert any("a warning is fixed; left is UC019: argument 'spare'" in one for one in verdict.remarks), verdict.remarks


def test_edits_that_nothing_asks_for_are_not(folder: Folder) -> None:
    assert tried(folder, MACRO, [("", "world", "earth")]).asked_for == frozenset()


@pytest.mark.parametrize(
    ("before", "edits", "objection"),
    [
        (MACRO, [*BOTH, ("", "<mass ", "<masse ")], "the fix would cause UC154 (<masse>"),
        (MACRO, [*BOTH, ("", "<parent ", "<child "), ("", "<limit ", "<parent ")], "the fix would cause"),
        (MACRO, [('name="elbow" ', 'type="revolute"', 'kind="revolute"')], "the fix would cause"),
        (HEAVY, [*BOTH, ('"m" value="', "1", "2")], "other parts of the robot would also change"),
        (MACRO, [*BOTH, ('name="world"', "/>", ">")], "other parts of the robot would also change"),
        (MACRO.replace("</robot>", SECOND.replace("TYPE", "continuous")), BOTH, "the call of macro 'turning' at "),
    ],
)
def test_what_speaks_against_edits_is_told(folder: Folder, before: str, edits: list[Written], objection: str) -> None:
    told = tried(folder, before, edits).objections
    assert any(objection in one for one in told), told


def test_a_comment_must_not_be_left_with_nothing_to_silence(folder: Folder) -> None:
    ignored = MACRO.replace("      <parent", "      <!-- urdfctl: ignore[UC125] for now -->\n      <parent")
    told = tried(folder, ignored, BOTH).objections
    assert any("would be unused" in one for one in told)


def test_yaml_is_compared_by_its_nodes(folder: Folder) -> None:
    assert tried(folder, CONTROLLERS, [("goal_time: ", "1", "1.0")], "arm.yaml").objections == ()
    told = tried(
        folder, CONTROLLERS, [("goal_time: ", "1", "1.0"), ("joints: ", "[elbow]", "[]")], "arm.yaml"
    ).objections
    assert told


def test_all_findings_of_a_run_are_mended_together_and_nothing_is_written(folder: Folder) -> None:
    folder.write({"arm.xacro": MACRO.replace("</robot>", SECOND.replace("TYPE", "prismatic")), "arm.yaml": CONTROLLERS})
    targets = [Target("arm.xacro"), Target("arm.yaml")]
    loader = Loader(SETTINGS)
    result = fixed(
        [(target, lint_target(loader, target, Selection()).result) for target in targets],
        SETTINGS,
        FixOptions(unsafe=True),
        1,
    )
    assert result.refused == ()
    assert [os.path.basename(change.file) for change in result.changes] == ["arm.xacro", "arm.yaml"]
    assert b'lower="-1" upper="1"' in result.changes[0].after
    assert b"goal_time: 1.0" in result.changes[1].after
    assert b'lower="1" upper="-1"' in (folder.path / "arm.xacro").read_bytes()


def test_what_is_not_wanted_is_not_mended(folder: Folder) -> None:
    folder.write({"arm.xacro": MACRO})
    linted = [(Target("arm.xacro"), lint_target(Loader(SETTINGS), Target("arm.xacro"), Selection()).result)]
    assert fixed(linted, SETTINGS, FixOptions(), 1).changes == ()
    assert fixed(linted, SETTINGS, FixOptions(Selection(ignore=("UC125",)), unsafe=True), 1).changes == ()
    assert fixed(linted, SETTINGS, FixOptions(ignores=lambda _, code: code == "UC125", unsafe=True), 1).changes == ()


@pytest.mark.parametrize("now", [MACRO.replace("<robot", "<!-- new --><robot"), "<robot/>"])
def test_a_file_that_has_changed_since_it_was_linted_is_left(folder: Folder, now: str) -> None:
    folder.write({"arm.xacro": MACRO})
    linted = [(Target("arm.xacro"), lint_target(Loader(SETTINGS), Target("arm.xacro"), Selection()).result)]
    folder.write({"arm.xacro": now})
    result = fixed(linted, SETTINGS, FixOptions(unsafe=True), 1)
    assert result.changes == ()
    assert len(result.refused) == 1


def test_the_command_mends_and_tells_how_much(folder: Folder, capsys: pytest.CaptureFixture[str]) -> None:
    folder.write({"arm.xacro": MACRO, "urdfctl.toml": "distro = 'jazzy'\n[[robot]]\npath = 'arm.xacro'\n"})
    assert run_words(["lint", "--diff", "--unsafe-fixes"]) == 1
    assert (
        '+      <parent link="world"/><child link="${name}_link"/><limit lower="-1" upper="1"'
        in capsys.readouterr().out
    )
    assert run_words(["lint", ".", "--unsafe-fixes", "--jobs", "1"]) == 0
    assert capsys.readouterr().err == "urdfctl: fixed 1 of 1 finding in 1 file\n"
    assert LIMITS[1] in (folder.path / "arm.xacro").read_text()
    assert run_words(["lint", "arm.xacro", "--show-settings", "--distro", "iron"]) == 0
    assert 'distro = "iron"                           # --distro' in capsys.readouterr().out
    assert run_words(["lint", ".", "--shard", "1/2", "--exit-zero"]) == 0


@pytest.mark.parametrize(
    ("text", "mode", "workspace", "why"),
    [
        (
            "<!-- This document was autogenerated by xacro from a.xacro -->\n" + MACRO,
            0o644,
            ".",
            "was generated by xacro",
        ),
        (MACRO, 0o444, ".", "is read-only"),
        (MACRO, 0o644, "other", "is outside the workspace"),
    ],
)
def test_some_files_are_never_edited(folder: Folder, text: str, mode: int, workspace: str, why: str) -> None:
    folder.write({"arm.xacro": text, "other/package.xml": ""})
    os.chmod("arm.xacro", mode)
    settings = SETTINGS._replace(workspace=workspace, trust=True)
    linted = [(Target("arm.xacro"), lint_target(Loader(settings), Target("arm.xacro"), Selection()).result)]
    [refused] = fixed(linted, settings, FixOptions(unsafe=True), 1).refused
    assert why in refused


def test_a_file_that_is_gone_since_it_was_linted_is_told_of(folder: Folder) -> None:
    folder.write({"arm.xacro": MACRO})
    linted = [(Target("arm.xacro"), lint_target(Loader(SETTINGS), Target("arm.xacro"), Selection()).result)]
    os.unlink("arm.xacro")
    [refused] = fixed(linted, SETTINGS, FixOptions(unsafe=True), 1).refused
    assert "UC125 is not fixed: " in refused


def test_many_fixes_of_a_rule_that_are_refused_for_one_reason_are_not_all_tried_alone(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each fix would give another link the name `world`; the good one after them is made all the same."""
    links = '  <link naname="world"/>\n' * 100
    hinge = MACRO[MACRO.index("    <joint") : MACRO.index("  </xacro:macro>")].replace("${name}", "a")
    last = hinge.replace("${type}", "revolute") + '<link name="a_link"/>'
    folder.write({"arm.urdf": f'<robot name="arm">\n  <link name="world"/>\n{links}{last}</robot>\n'})
    target = Target("arm.urdf")
    linted = lint_target(Loader(SETTINGS), target, Selection()).result
    tried_on: list[int] = []

    def counted(*arguments: Any, **named: Any) -> Any:
        tried_on.append(1)
        return run_on_targets(*arguments, **named)

    monkeypatch.setattr("urdfctl.fix.rounds.run_on_targets", counted)
    result = fixed([(target, linted)], SETTINGS, FixOptions(unsafe=True), 1)
    assert len(result.refused) == 100
    assert {message.partition(": ")[2] for message in result.refused} == {
        "UC155 is not fixed: the fix would cause UC110 (link 'world' is already defined; rename or remove one)"
    }
    assert b'lower="-1" upper="1"' in result.changes[0].after
    assert len(tried_on) < 60
