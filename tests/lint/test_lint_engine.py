"""The engine: which rules are asked, what of their findings is told, merged, suppressed, and in which order."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from folder import Folder

from urdfctl.catalog.distros import ALL, since
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Finding, Location, Severity
from urdfctl.errors import UserError
from urdfctl.lint.engine import lint
from urdfctl.lint.findings.merging import merge, worst
from urdfctl.lint.results import Outcome, TargetResult
from urdfctl.lint.selection import Selection, validate_selection
from urdfctl.lint.serialising import result_from_json, result_to_json
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.rule import Check, Rule, rule
from urdfctl.source.budget import OverBudget

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
LINKS = '<link name="base"/>\n<link name="tip"/>\n'
JOINT = '<joint name="{}" type="continuous"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/></joint>\n'
FIXED = '<joint name="mount" type="fixed"><parent link="base"/><child link="tip"/></joint>\n'
WITHOUT_INTERFACE = (
    '<transmission name="{0}_trans">'
    "<type>transmission_interface/SimpleTransmission</type>\n"
    '<joint name="{0}"/>\n'
    '<actuator name="{0}_motor"><mechanicalReduction>1</mechanicalReduction></actuator>'
    "</transmission>\n"
)
ELBOW = JOINT.format("elbow") + WITHOUT_INTERFACE.format("elbow")
WHEEL = (
    '<xacro:macro name="wheel" params="side">\n'
    + JOINT.format("${side}_joint")
    + WITHOUT_INTERFACE.format("${side}_joint")
    + "</xacro:macro>\n"
)
UC201 = Selection(select=("UC201", "UC099"))


def linted(path: str = "r.xacro", chosen: Selection = UC201, settings: Settings = Settings()) -> TargetResult:  # noqa: B008
    return lint_target(Loader(settings), Target(path), chosen).result


def found(*paths: str, chosen: Selection = UC201) -> list[Diagnostic]:
    return merge([linted(path, chosen).outcome for path in paths or ("r.xacro",)], chosen)


def told(*paths: str, chosen: Selection = UC201) -> list[str]:
    return [f"{d.code} {d.at.line}" for d in found(*paths, chosen=chosen)]


# -- merging ---------------------------------------------------------------------------------------------------------


def test_a_fault_that_several_calls_of_a_macro_show_is_one_with_a_chain_for_each(folder: Folder) -> None:
    folder.write(
        {
            "wheel.xacro": HEAD + WHEEL + "</robot>",
            "r.xacro": HEAD
            + LINKS
            + '<xacro:include filename="wheel.xacro"/>\n'
            + '<xacro:wheel side="left"/>\n<xacro:wheel side="right"/>\n</robot>',
        }
    )
    [one] = found()
    assert (one.code, one.at.file, one.at.line) == ("UC201", str(folder.path / "wheel.xacro"), 5)
    assert [[(step.what, step.line) for step in chain] for chain in one.expanded_from] == [
        [("macro wheel", 5)],
        [("macro wheel", 6)],
    ]
    assert "'left_joint'" in one.message
    assert one.notes[0].message.startswith("likewise: ")
    assert "'right_joint'" in one.notes[0].message


def test_of_many_calls_the_note_names_three_and_counts_the_rest(folder: Folder) -> None:
    calls = "".join(f'<xacro:wheel side="{side}"/>' for side in "abcdefg")
    folder.write({"r.xacro": HEAD + WHEEL + LINKS + calls + "</robot>"})
    [one] = found()
    assert len(one.expanded_from) == 7
    assert one.notes[0].message == "likewise: 'b_joint'; 'c_joint'; 'd_joint'; and 3 more"


def test_a_macro_file_that_several_robots_use_has_its_fault_once(folder: Folder) -> None:
    robot = HEAD + LINKS + '<xacro:include filename="wheel.xacro"/>\n<xacro:wheel side="left"/>\n</robot>'
    folder.write({"wheel.xacro": HEAD + WHEEL + "</robot>", "a.xacro": robot, "b.xacro": robot})
    [one] = found("a.xacro", "b.xacro")
    assert [chain[0].file for chain in one.expanded_from] == [
        str(folder.path / "a.xacro"),
        str(folder.path / "b.xacro"),
    ]
    assert found("b.xacro", "a.xacro") == [one]


def test_a_file_that_several_robots_include_has_its_fault_once(folder: Folder) -> None:
    robot = HEAD + LINKS + '<xacro:include filename="elbow.xacro"/>\n</robot>'
    folder.write({"elbow.xacro": HEAD + ELBOW + "</robot>", "a.xacro": robot, "b.xacro": robot})
    [one] = found("a.xacro", "b.xacro")
    assert one.at.line == 4
    assert not [note for note in one.notes if note.message.startswith("likewise")]


# -- rules made for the tests ----------------------------------------------------------------------------------------


def ruled(
    check: Check,
    code: str,
    severity: Severity = Severity.WARNING,
    distros: tuple[str, ...] = ALL,
    *,
    whole_robot: bool = False,
) -> Rule:
    """A rule with a check, and no examples."""
    declared = rule(
        code,
        severity=severity,
        runtime="ignores",
        authority="this test",
        bad=[],
        good=[],
        distros=distros,
        whole_robot=whole_robot,
    )
    return declared(check)


def made(code: str, *findings: tuple[int, str], whole_robot: bool = False, distros: tuple[str, ...] = ALL) -> Rule:
    """A rule that finds something at links of the robot, by their number from 0."""

    def made_for_a_test(project: Project) -> Iterator[Finding]:
        """It finds what it is told to find."""
        assert project.robot is not None
        for number, message in findings:
            yield Finding(project.robot.links[number].at, message)

    return ruled(made_for_a_test, code, distros=distros, whole_robot=whole_robot)


def broken(code: str) -> Rule:
    """A rule that finds one thing and then crashes."""

    def made_to_crash(project: Project) -> Iterator[Finding]:
        """It crashes."""
        assert project.robot is not None
        yield Finding(project.robot.links[0].at, "before the crash")
        raise ZeroDivisionError("of all things")

    return ruled(made_to_crash, code)


def outcome(*rules: Rule, path: str = "r.xacro", chosen: Selection = Selection()) -> Outcome:  # noqa: B008 (immutable)
    loaded = Loader(Settings()).load(Target(path))
    project = loaded.project
    return lint(project, list(loaded.sources.values()), chosen, rules)


def test_two_faults_of_one_place_stay_two(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + "</robot>"})
    one = outcome(made("UC901", (0, "too long"), (0, "too thin"), (0, "too thin")), made("UC902", (0, "too long")))
    assert [(d.code, d.message) for d in merge([one], Selection())] == [
        ("UC901", "too long"),
        ("UC901", "too thin"),
        ("UC902", "too long"),
    ]


def test_two_faults_that_each_call_shows_at_one_place_stay_two(folder: Folder) -> None:
    macro = '<xacro:macro name="part" params="n"><link name="${n}"/></xacro:macro>'
    folder.write({"r.xacro": HEAD + macro + '\n<xacro:part n="a"/><xacro:part n="b"/></robot>'})
    one = outcome(made("UC901", (0, "a is long"), (0, "a is thin"), (1, "b is long"), (1, "b is thin")))
    assert [(d.message, d.notes[0].message, len(d.expanded_from)) for d in merge([one], Selection())] == [
        ("a is long", "likewise: b is long", 2),
        ("a is thin", "likewise: b is thin", 2),
    ]


def test_one_fault_that_several_variants_of_a_robot_show_through_the_same_call_stays_one(folder: Folder) -> None:
    macro = '<xacro:macro name="part" params="n"><link name="${n}"/></xacro:macro>'
    folder.write({"r.xacro": HEAD + macro + '\n<xacro:part n="a"/></robot>'})
    one, other = outcome(made("UC901", (0, "a is long"))), outcome(made("UC901", (0, "a is long")))
    assert [(d.message, len(d.expanded_from)) for d in merge([one, other], Selection())] == [("a is long", 1)]


def test_the_gravest_of_what_is_merged_is_told(folder: Folder) -> None:
    def made_for_a_test(project: Project) -> Iterator[Finding]:
        """It finds the second call worse than the first."""
        assert project.robot is not None
        for link, severity in zip(project.robot.links, (None, Severity.ERROR), strict=True):
            yield Finding(link.at, f"{link.name} is bad", severity=severity)

    macro = '<xacro:macro name="part" params="n"><link name="${n}"/></xacro:macro>'
    folder.write({"r.xacro": HEAD + macro + '\n<xacro:part n="a"/><xacro:part n="b"/></robot>'})
    rule = ruled(made_for_a_test, "UC901")
    [one] = merge([outcome(rule)], Selection())
    assert (one.severity, one.message) == (Severity.ERROR, "b is bad")


def test_the_order_is_by_file_place_and_code_whatever_the_order_of_rules_and_robots(folder: Folder) -> None:
    folder.write({"a.xacro": HEAD + LINKS + "</robot>", "b.xacro": HEAD + LINKS + "</robot>"})
    rules = made("UC902", (1, "x"), (0, "x")), made("UC901", (1, "y"), (1, "x"))
    a, b = outcome(*rules, path="a.xacro"), outcome(*rules[::-1], path="b.xacro")
    expected = [(0, "UC902", "x"), (1, "UC901", "x"), (1, "UC901", "y"), (1, "UC902", "x")]
    for outcomes in ([a, b], [b, a]):
        order = merge(outcomes, Selection())
        assert [d.at.file for d in order] == [str(folder.path / "a.xacro")] * 4 + [str(folder.path / "b.xacro")] * 4
        assert [(d.at.line - 2, d.code, d.message) for d in order] == expected * 2


# -- a rule that crashes ---------------------------------------------------------------------------------------------


def test_a_rule_that_crashes_is_a_finding_and_the_others_go_on(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + "</robot>"})
    given = outcome(made("UC901", (0, "first")), broken("UC902"), made("UC903", (1, "last")))
    assert given.crashed
    assert [(d.code, d.severity.value) for d in merge([given], Selection())] == [
        ("UC000", "error"),
        ("UC901", "warning"),
        ("UC902", "warning"),
        ("UC903", "warning"),
    ]
    crash = given.diagnostics[2]
    assert crash.message.startswith("rule UC902 made-to-crash crashed: ZeroDivisionError: of all things (made_to_c")
    assert crash.at.file == str(folder.path / "r.xacro")
    assert result_from_json(result_to_json(linted()._replace(outcome=given))).outcome == given


def test_a_robot_that_is_over_its_budget_in_a_rule_is_no_crash_of_the_rule(folder: Folder) -> None:
    def made_to_last(project: Project) -> Iterator[Finding]:
        """It takes too long."""
        raise OverBudget("it takes longer than 20 s")

    folder.write({"r.xacro": HEAD + LINKS + "</robot>"})
    with pytest.raises(OverBudget):
        outcome(ruled(made_to_last, "UC901"))


# -- which rules are asked -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("chosen", "admitted"),
    [
        (Selection(), {"UC101", "UC201", "UC202"}),
        (Selection(select=("UC2",)), {"UC201", "UC202"}),
        (Selection(select=("UC201", "UC1")), {"UC101", "UC201"}),
        (Selection(ignore=("UC2",)), {"UC101"}),
        (Selection(ignore=("UC",)), set()),
        (Selection(select=("UC2",), ignore=("UC201",)), {"UC202"}),
        (Selection(select=("UC201",), ignore=("UC2",)), {"UC201"}),
        (Selection(select=("UC2",), ignore=("UC2",)), set()),
        (Selection(select=("UC1",), extend=("UC202",)), {"UC101", "UC202"}),
        (Selection(extend=("UC201",), ignore=("UC2",)), {"UC101", "UC201"}),
        (Selection(select=("UC201",), ignore=("UC2",), extend=("UC202",)), {"UC201", "UC202"}),
    ],
)
def test_the_longest_beginning_of_a_code_decides(chosen: Selection, admitted: set[str]) -> None:
    assert {code for code in ("UC101", "UC201", "UC202") if chosen.admits(code)} == admitted


def test_a_beginning_that_no_code_has_is_the_users_mistake() -> None:
    made = Selection(("UC2",), ("UC201",), ("UC1",), (("UC1", "off"),))
    assert validate_selection(made) is made
    for mistaken in ("UC87", "201", "transmission-joint-without-interface"):
        with pytest.raises(UserError, match=f"no rule's code begins with '{mistaken}'"):
            validate_selection(Selection(ignore=(mistaken,)))


def test_a_rule_is_asked_only_for_the_distros_it_holds_for(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + ELBOW + "</robot>"})
    for distro, codes in [("hydro", []), ("indigo", ["UC201"]), ("noetic", ["UC201"]), ("jazzy", [])]:
        given = linted(settings=Settings(distro=distro)).outcome
        assert [d.code for d in given.diagnostics] == codes, distro


def test_where_the_distro_is_not_known_a_note_names_those_that_a_finding_holds_for(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + "</robot>"})
    rules = made("UC901", (0, "x"), distros=since("kinetic")), made("UC902", (0, "x"))
    some, all_of_them = outcome(*rules).diagnostics
    assert [note.message for note in some.notes] == ["applies from kinetic to noetic"]
    assert not all_of_them.notes


def test_where_the_distro_is_known_no_note_names_it(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + ELBOW + "</robot>"})
    [one] = linted(settings=Settings(distro="noetic")).outcome.diagnostics
    assert not [note for note in one.notes if "holds for" in note.message]


def test_a_finding_may_be_graver_than_its_rule_where_the_distro_makes_it_so(folder: Folder) -> None:
    def made_for_a_test(project: Project) -> Iterator[Finding]:
        """It is an error in noetic only."""
        assert project.robot is not None
        yield Finding(project.robot.at, "x", severity=Severity.ERROR if project.distro == "noetic" else None)

    folder.write({"r.xacro": HEAD + LINKS + "</robot>"})
    rule = ruled(made_for_a_test, "UC901", severity=Severity.INFO)
    for distro, severity in (("noetic", Severity.ERROR), ("melodic", Severity.INFO)):
        loaded = Loader(Settings(distro=distro)).load(Target("r.xacro"))
        project = loaded.project
        assert [d.severity for d in lint(project, [], Selection(), [rule]).diagnostics] == [severity]


def test_a_rule_that_needs_the_whole_robot_is_silent_where_a_part_is_missing(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + "</robot>", "part.xacro": HEAD + LINKS + "<xacro:unknown/></robot>"})
    rules = made("UC901", (0, "x"), whole_robot=True), made("UC902", (0, "x"))
    assert [d.code for d in outcome(*rules).diagnostics] == ["UC901", "UC902"]
    assert [d.code for d in outcome(*rules, path="part.xacro").diagnostics] == ["UC902"]


def test_the_worst_of_some_findings() -> None:
    def of(severity: Severity) -> Diagnostic:
        return Diagnostic("UC901", "x", severity, "x", Location("x", 1, 1, 1, 1, 0, 0))

    assert worst([]) is None
    assert worst([of(Severity.INFO), of(Severity.WARNING)]) is Severity.WARNING
    assert worst([of(Severity.ERROR), of(Severity.INFO)]) is Severity.ERROR


# -- suppression -----------------------------------------------------------------------------------------------------

IGNORE = "<!-- urdfctl: ignore[UC201] driven by hand -->"


def elbow(before: str = "", behind: str = "") -> str:
    """A robot whose fault stands on line 5, with something on the line before it and behind it."""
    lines = (HEAD + LINKS + ELBOW + "</robot>").splitlines()
    assert lines[5] == '<joint name="elbow"/>'
    lines[5] += behind
    lines[4] += before
    return "\n".join(lines)


def test_a_comment_on_the_line_silences_it(folder: Folder) -> None:
    folder.write({"r.xacro": elbow(behind=IGNORE)})
    assert told() == []


def test_a_comment_on_the_line_before_silences_it(folder: Folder) -> None:
    folder.write({"r.xacro": elbow(before=IGNORE)})
    assert told() == []


def test_a_comment_of_several_lines_speaks_of_the_line_after_its_end(folder: Folder) -> None:
    folder.write({"r.xacro": elbow(before="\n<!-- urdfctl: ignore[UC201]\n because\n of that -->")})
    assert told() == []


def test_a_comment_further_away_does_not_and_is_told_to_be_unused(folder: Folder) -> None:
    folder.write({"r.xacro": elbow(before=IGNORE + "\n\n")})
    assert told() == ["UC099 5", "UC201 8"]


@pytest.mark.parametrize("codes", ["UC2", "UC", "UC101, UC201", "uc201", " UC201 "])
def test_a_comment_may_name_several_codes_or_beginnings(folder: Folder, codes: str) -> None:
    folder.write({"r.xacro": elbow(behind=f"<!-- urdfctl: ignore[{codes}] -->")})
    assert told() == []


def test_a_comment_for_another_code_silences_nothing(folder: Folder) -> None:
    folder.write({"r.xacro": elbow(behind="<!-- urdfctl: ignore[UC202] -->")})
    assert told(chosen=Selection(select=("UC201", "UC202", "UC099"))) == ["UC201 6", "UC099 6"]


WHEELS = '<xacro:wheel side="left"/>\n<xacro:wheel side="right"/>\n'


def test_a_comment_at_the_macros_definition_silences_its_fault_wherever_it_is_called(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + IGNORE + "\n" + WHEEL + WHEELS + "</robot>"})
    assert told() == []


def test_a_comment_at_one_call_silences_that_call_only(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + WHEEL + IGNORE + "\n" + WHEELS + "</robot>"})
    [one] = found()
    assert "'right_joint'" in one.message
    assert len(one.expanded_from) == 1


def test_a_comment_in_an_included_file_silences_there(folder: Folder) -> None:
    folder.write(
        {
            "r.xacro": HEAD + LINKS + '<xacro:include filename="wheel.xacro"/>\n' + WHEELS + "</robot>",
            "wheel.xacro": HEAD + IGNORE + "\n" + WHEEL + "</robot>",
        }
    )
    assert told() == []


def test_a_comment_at_an_include_silences_what_stands_in_the_file(folder: Folder) -> None:
    folder.write(
        {
            "r.xacro": HEAD + LINKS + IGNORE + '\n<xacro:include filename="elbow.xacro"/></robot>',
            "elbow.xacro": HEAD + ELBOW + "</robot>",
        }
    )
    assert told() == []


# -- comments that silence nothing -----------------------------------------------------------------------------------

SOUND = HEAD + '<link name="base"/>{}\n<link name="tip"/>\n' + FIXED + "</robot>"


def test_a_comment_that_silences_nothing_is_told(folder: Folder) -> None:
    folder.write({"r.xacro": SOUND.format(IGNORE)})
    [one] = found()
    assert (one.code, one.at.line, one.excerpt) == ("UC099", 2, '<link name="base"/>' + IGNORE)
    assert one.message == "unused suppression: there is no finding of UC201 on this line or the next"


def test_a_comment_without_a_code_is_told(folder: Folder) -> None:
    folder.write({"r.xacro": SOUND.format("<!-- urdfctl: ignore[] -->")})
    assert told() == ["UC099 2"]


def test_a_comment_with_a_code_of_no_rule_is_told(folder: Folder) -> None:
    folder.write({"r.xacro": SOUND.format("<!-- urdfctl: ignore[UC888] -->")})
    assert told() == ["UC099 2"]


@pytest.mark.parametrize(
    "chosen",
    [
        Selection(ignore=("UC099",)),
        Selection(ignore=("UC201",)),
        Selection(ignore=("UC2",)),
        Selection(select=("UC1", "UC099")),
        Selection(select=("UC201",)),
    ],
)
def test_it_is_not_told_where_it_or_its_rule_was_not_asked_for(folder: Folder, chosen: Selection) -> None:
    folder.write({"r.xacro": SOUND.format(IGNORE)})
    assert told(chosen=chosen) == []


def test_a_comment_for_a_family_is_not_told_where_one_of_its_rules_was_not_asked(folder: Folder) -> None:
    folder.write({"r.xacro": SOUND.format("<!-- urdfctl: ignore[UC2] -->")})
    assert told(chosen=Selection(ignore=("UC225",))) == []
    assert told(chosen=Selection(select=("UC201", "UC099"))) == []


def test_it_is_not_told_for_a_distro_that_the_rule_does_not_hold_for(folder: Folder) -> None:
    folder.write({"r.xacro": SOUND.format(IGNORE)})
    for distro, codes in [("jazzy", []), ("hydro", []), ("noetic", ["UC099"])]:
        given = linted(settings=Settings(distro=distro)).outcome
        assert [d.code for d in merge([given], UC201)] == codes, distro


def test_it_is_not_told_where_a_part_of_the_robot_is_missing(folder: Folder) -> None:
    folder.write({"r.xacro": SOUND.format(IGNORE).replace("</robot>", "<xacro:unknown/></robot>")})
    assert told() == []


def test_it_is_not_told_in_a_macro_that_this_robot_does_not_call(folder: Folder) -> None:
    macro = WHEEL.replace('<joint name="${side}_joint"/>', '<joint name="${side}_joint"/>' + IGNORE)
    folder.write({"r.xacro": HEAD + LINKS + macro + "</robot>"})
    assert told() == []


def test_it_is_not_told_under_a_condition_that_does_not_hold(folder: Folder) -> None:
    guarded = '<xacro:if value="{}">\n<link name="x"/>' + IGNORE + "\n</xacro:if>\n"
    folder.write({"r.xacro": HEAD + LINKS + guarded.format("false") + "</robot>"})
    assert told() == []
    folder.write({"r.xacro": HEAD + LINKS + guarded.format("true") + "</robot>"})
    assert told() == ["UC099 5"]


def test_it_is_not_told_where_another_robot_of_the_run_needs_it(folder: Folder) -> None:
    robot = HEAD + LINKS + '<xacro:include filename="wheel.xacro"/>\n<xacro:wheel side="{}"/></robot>'
    interface = (
        "<xacro:if value=\"${side == 'left'}\"><hardwareInterface>EffortJointInterface</hardwareInterface></xacro:if>"
    )
    macro = WHEEL.replace('<joint name="${side}_joint"/>', f'<joint name="${{side}}_joint">{IGNORE}{interface}</joint>')
    files = {"left.xacro": robot.format("left"), "right.xacro": robot.format("right")}
    folder.write({"wheel.xacro": HEAD + macro + "</robot>", **files})
    assert told("left.xacro") == ["UC099 5"]
    assert told("right.xacro") == []
    assert told("left.xacro", "right.xacro") == []
    assert told("right.xacro", "left.xacro") == []


def test_an_unused_comment_in_a_file_that_several_robots_read_is_told_once(folder: Folder) -> None:
    robot = HEAD + LINKS + '<xacro:include filename="part.xacro"/></robot>'
    part = HEAD + '<link name="part"/>' + IGNORE + "</robot>"
    folder.write({"part.xacro": part, "a.xacro": robot, "b.xacro": robot})
    assert told("a.xacro", "b.xacro") == ["UC099 2"]


# -- the way to a worker and back ------------------------------------------------------------------------------------


def test_what_was_linted_survives_the_way_from_a_worker(folder: Folder) -> None:
    folder.write({"r.xacro": HEAD + LINKS + WHEEL + WHEELS + SOUND.format(IGNORE).removeprefix(HEAD)})
    one = linted(chosen=Selection())
    assert {d.code for d in one.outcome.diagnostics} >= {"UC201"}
    assert result_from_json(json.loads(json.dumps(result_to_json(one)))) == one
