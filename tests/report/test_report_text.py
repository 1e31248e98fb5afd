"""The text and concise reports: what stands where, on a terminal and off it."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from collections.abc import Mapping

import pytest
from folder import Folder, environment

from urdfctl.diagnostic import CallStep, Diagnostic, Finding, Location, Remark, Repair, Severity, ShownEdit, diagnosed
from urdfctl.lint.findings.causes import EXPLAINS
from urdfctl.lint.findings.ranking import causes_first
from urdfctl.lint.results import Outcome, Report, TargetResult
from urdfctl.lint.serialising import diagnostic_from_json, diagnostic_to_json
from urdfctl.output.printing import visible
from urdfctl.report import concise, text
from urdfctl.report.common import shown
from urdfctl.report.text import wrapped
from urdfctl.source.span import Place, SourceText


def at(folder: Folder, name: str, start: tuple[int, int], end: tuple[int, int] | None = None) -> Location:
    return Location(str(folder.path / name), *start, *(end or start), 0, 0)


def fault(where: Location, excerpt: str = "", message: str = "it is wrong") -> Diagnostic:
    return Diagnostic("UC901", "wrong", Severity.ERROR, message, where, excerpt=excerpt)


def robot(
    folder: Folder, name: str = "r.xacro", distro: str | None = "noetic", source: str | None = "--distro"
) -> TargetResult:
    path = str(folder.path / name)
    nothing = Outcome([], [])
    return TargetResult(path, 1 if distro else None, distro, source, None, True, False, "r", 2, (path,), nothing)


def test_a_finding_shows_its_line_its_way_its_notes_and_its_fix(folder: Folder) -> None:
    one = Diagnostic(
        "UC901",
        "wrong",
        Severity.WARNING,
        "joint 'elbow' is wrong",
        at(folder, "urdf/wheel.xacro", (12, 7), (12, 26)),
        (
            (
                CallStep(str(folder.path / "urdf/axle.xacro"), 4, 3, "macro wheel"),
                CallStep(str(folder.path / "r.xacro"), 9, 1, "include axle.xacro"),
            ),
            (CallStep(str(folder.path / "r.xacro"), 20, 5, "block"),),
        ),
        (
            Remark("it was said here", at(folder, "urdf/wheel.xacro", (3, 1))),
            Remark("or there", at(folder, "b", (1, 2))),
        ),
        Repair("make it right", safe=True),
        '      <joint name="elbow"/>  <!-- x -->',
    )
    assert text.render(Report((robot(folder),), (one,))) == (
        "urdf/wheel.xacro:12:7: warning UC901 joint 'elbow' is wrong\n"
        '  12 |       <joint name="elbow"/>  <!-- x -->\n'
        "     |       ^^^^^^^^^^^^^^^^^^^\n"
        "  note: in the call of macro 'wheel' at urdf/axle.xacro:4:3, included at r.xacro:9:1\n"
        "  note: inserted as a block at r.xacro:20:5\n"
        "  note: it was said here (line 3)\n"
        "  note: or there (b:1:2)\n"
        "  fix: make it right (by hand)\n"
        "\n"
        "1 warning in r.xacro (noetic)\n"
    )
    assert concise.render(Report((robot(folder),), (one,))) == (
        "urdf/wheel.xacro:12:7: warning UC901 joint 'elbow' is wrong\n"
    )


def test_of_many_chains_three_are_shown(folder: Folder) -> None:
    chains = tuple((CallStep("/r.xacro", line, 1, "macro m"),) for line in range(1, 8))
    told = text.render(Report((), (fault(at(folder, "r.xacro", (1, 1)))._replace(expanded_from=chains),)))
    assert told.count("in the call of") == 3
    assert "  note: and in 4 more calls\n" in told


def caret(told: str) -> tuple[str, str]:
    """The part of the source line that the carets stand under, and the carets."""
    lines = told.splitlines()
    marks = lines[2]
    start = marks.index("^")
    return lines[1][start : len(marks)], marks[start:]


def test_of_a_way_without_end_the_two_ends_are_shown(folder: Folder) -> None:
    way = tuple(CallStep(str(folder.path / "r.xacro"), line, 1, "macro wheel") for line in range(1, 251))
    said = text.render(Report((), (fault(at(folder, "r.xacro", (1, 1)))._replace(expanded_from=(way,)),)))
    said = said.replace("\n    ", " ")
    calls = [f"in the call of macro 'wheel' at r.xacro:{line}:1" for line in (*range(1, 8), 250)]
    assert ", ".join([*calls[:7], "and 242 more calls", calls[7]]) in said


@pytest.mark.parametrize(
    ("line", "columns", "under"),
    [
        ('<joint name="é"/> x', (1, 18), '<joint name="é"/>'),
        ('\t\t<joint name="a"/>', (3, 20), '<joint name="a"/>'),
        ('<link name="腕" x="y"/>', (12, 17), '"腕" x'),
        ("<joint>", (3, 3), "o"),
        ("", (1, 1), ""),
    ],
)
def test_the_caret_stands_under_what_is_meant(folder: Folder, line: str, columns: tuple[int, int], under: str) -> None:
    where = at(folder, "r.xacro", (1, columns[0]), (1, columns[1]))
    told = text.render(Report((), (fault(where, line),)))
    if not under:
        assert told.splitlines()[1:] == ["", "1 error in 0 robots"]
        return
    assert caret(told) == (under, "^" * len(under))


def test_an_element_of_several_lines_is_underlined_to_the_end_of_its_first(folder: Folder) -> None:
    where = at(folder, "r.xacro", (4, 3), (5, 20))
    assert caret(text.render(Report((), (fault(where, '  <joint name="a"   '),))))[0] == '<joint name="a"'


@pytest.mark.parametrize("start", [1, 80, 400, 995])
def test_of_a_long_line_the_part_around_the_fault_is_shown(folder: Folder, start: int) -> None:
    line = "".join(chr(ord("a") + number % 26) for number in range(1000))
    where = at(folder, "r.xacro", (1, start), (1, start + 5))
    told = text.render(Report((), (fault(where, line),)))
    assert len(told.splitlines()[1]) <= 170
    assert caret(told) == (line[start - 1 : start + 4], "^^^^^")


def test_of_a_long_line_only_the_part_around_the_fault_is_kept(folder: Folder) -> None:
    line = "".join(chr(ord("a") + number % 26) for number in range(100_000))
    source = SourceText(str(folder.path / "r.xacro"), line.encode())
    for start in (0, 50_000, 99_990):
        finding = Finding(Place(source, start, end=start + 5), "it is wrong")
        one = diagnosed("UC901", "wrong", Severity.ERROR, finding)
        assert len(one.excerpt) <= 400
        assert caret(text.render(Report((), (one,)))) == (line[start : start + 5], "^^^^^")
        assert diagnostic_from_json(diagnostic_to_json(one)) == one


def test_what_a_file_writes_does_not_speak_to_the_terminal(folder: Folder) -> None:
    line = '<joint name="\x1b[31m\x07\u202e\x9b"/>'
    one = fault(at(folder, "a\x1b[2J\nb.xacro", (1, 1), (1, 8)), line, "joint '\x1b[31m\n' is wrong")
    one = one._replace(notes=(Remark("\x1b]0;x\x07"),), fix=Repair("\x1b", safe=False))
    for told in (text.render(Report((), (one,))), concise.render(Report((), (one,)))):
        assert not set(told) & set("\x1b\x07\u202e\x9b")
        assert told.splitlines()[0] == r"a\x1b[2J\nb.xacro:1:1: error UC901 joint '\x1b[31m\n' is wrong"
    assert caret(text.render(Report((), (one,))))[0] == "<joint "


def test_plain_words_stay_as_they_are() -> None:
    assert visible("größer als 腕 🦾") == "größer als 腕 🦾"


def test_paths_are_relative_to_the_current_folder_and_absolute_outside_it(folder: Folder) -> None:
    assert shown(str(folder.path / "urdf/r.xacro")) == "urdf/r.xacro"
    assert shown("/elsewhere/r.xacro") == "/elsewhere/r.xacro"
    assert shown(f"{folder.path}-other/r.xacro") == f"{folder.path}-other/r.xacro"
    os.chdir("/")
    assert shown("/elsewhere/r.xacro") == "elsewhere/r.xacro"


def test_paths_in_messages_are_shown_in_the_same_way(folder: Folder) -> None:
    where = at(folder, "r.xacro", (1, 1))
    one = fault(
        where, message=f"file '{folder.path}/a b.xacro' does not exist, nor {folder.path}/c:3, nor x{folder.path}/d"
    )
    told = concise.render(Report((), (one,)))
    assert told == f"r.xacro:1:1: error UC901 file 'a b.xacro' does not exist, nor c:3, nor x{folder.path}/d\n"


def test_a_path_in_an_address_of_a_file_is_shown_in_the_same_way(folder: Folder) -> None:
    one = fault(
        at(folder, "r.xacro", (1, 1)), message=f"no mesh 'file://{folder.path}/a.stl', nor 'x://{folder.path}/b'"
    )
    told = concise.render(Report((), (one,)))
    assert told == f"r.xacro:1:1: error UC901 no mesh 'file://a.stl', nor 'x://{folder.path}/b'\n"


@pytest.mark.parametrize(
    ("severities", "counted"),
    [
        ("", "no findings"),
        ("e", "1 error"),
        ("eew", "2 errors, 1 warning"),
        ("wwi", "2 warnings, 1 info (--verbose shows it)"),
        ("iii", "3 info"),
    ],
)
def test_the_summary_counts(folder: Folder, severities: str, counted: str) -> None:
    by_letter = {"e": Severity.ERROR, "w": Severity.WARNING, "i": Severity.INFO}
    found = tuple(fault(at(folder, "r.xacro", (1, 1)))._replace(severity=by_letter[letter]) for letter in severities)
    assert text.render(Report((robot(folder),), found)).splitlines()[-1] == f"{counted} in r.xacro (noetic)"


def test_the_summary_says_what_the_distro_was_told_by(folder: Folder) -> None:
    def summary(*robots: TargetResult) -> str:
        return text.render(Report(robots, ()))

    assert summary(robot(folder, source="$ROS_DISTRO")) == "no findings in r.xacro (noetic, from $ROS_DISTRO)\n"
    assert summary(robot(folder, distro=None, source=None)) == "no findings in r.xacro\n"
    generation = robot(folder, distro=None, source="package.xml")._replace(ros=2)
    assert summary(generation) == "no findings in r.xacro (ROS 2, from package.xml)\n"
    partly = robot(folder)._replace(complete=False)
    assert summary(partly) == "no findings in r.xacro (noetic; some parts are not known)\n"
    assert summary(robot(folder, "a"), robot(folder, "b")) == "no findings in 2 robots\n"
    assert text.render(Report((robot(folder),), (), unused=("a.yaml", "b.xacro", "c.launch", "d.yaml"))) == (
        "4 files not used by any robot: a.yaml, b.xacro, c.launch and 1 more\nno findings in r.xacro (noetic)\n"
    )


# -- as a process ----------------------------------------------------------------------------------------------------

FAULTY = '<robot name="r"><link name="a"/><joint name="größe [bold]" type="sideways"/></robot>\n'


def on_a_terminal(folder: Folder, *words: str, environ: Mapping[str, str | None] | None = None) -> str:
    """What `urdfctl` writes when its output is a terminal."""
    ours, theirs = pty.openpty()
    changes = {"TERM": "xterm-256color", **(environ or {})}
    process = subprocess.Popen(
        [sys.executable, "-m", "urdfctl", *words], cwd=folder.path, env=environment(changes), stdout=theirs
    )
    os.close(theirs)
    written = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:  # Linux tells the end of a terminal so
            break
        if not piece:
            break
        written += piece
    os.close(ours)
    process.wait(60)
    return written.decode().replace("\r\n", "\n")


def without_colours(written: str) -> str:
    import re

    return re.sub(r"\x1b\[[0-9;]*m|\x1b\]8;[^\x1b]*\x1b\\", "", written)


def test_a_terminal_gets_colours_and_the_same_words(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    coloured = on_a_terminal(folder, "lint", "r.urdf")
    plain = folder.run("lint", "r.urdf").stdout
    assert "\x1b[1;31merror" in coloured
    assert "größe [bold]" in plain
    assert without_colours(coloured) == plain


@pytest.mark.parametrize("environ", [{"NO_COLOR": "1"}, {"TERM": "dumb"}])
def test_a_terminal_gets_none_where_they_are_not_wanted(folder: Folder, environ: dict[str, str]) -> None:
    folder.write({"r.urdf": FAULTY})
    assert on_a_terminal(folder, "lint", "r.urdf", environ=environ) == folder.run("lint", "r.urdf").stdout


def test_a_pipe_and_a_file_get_none(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    assert "\x1b" not in folder.run("lint", "r.urdf", environ={"TERM": "xterm-256color"}).stdout
    on_a_terminal(folder, "lint", "r.urdf", "--format", "text=report.txt")
    assert "\x1b" not in (folder.path / "report.txt").read_text()


def test_a_terminal_gets_the_other_formats_plain(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    for name in ("concise", "json"):
        assert "\x1b" not in on_a_terminal(folder, "lint", "r.urdf", "--format", name)


def test_lines_are_as_wide_as_the_terminal_and_elsewhere_120_columns(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY.replace("größe", "x" * 90)})
    coloured = without_colours(on_a_terminal(folder, "lint", "r.urdf", environ={"COLUMNS": "80"}))
    plain = folder.run("lint", "r.urdf").stdout
    for told, width in ((coloured, 80), (plain, 120)):
        assert width - 30 < max(map(len, told.splitlines())) <= width


@pytest.mark.parametrize(
    ("line", "before", "lines"),
    [
        ("  note: a bb ccc dddd", 0, ["  note: a bb", "    ccc dddd"]),
        (" ten and eleven", 8, [" ten", "    and", "    eleven"]),
        (" thirteenchars", 8, ["", "    thirteen", "    chars"]),
        (" fits", 7, [" fits"]),
    ],
)
def test_a_long_line_goes_on_in_indented_lines(line: str, before: int, lines: list[str]) -> None:
    assert wrapped(line, 12, before=before).splitlines() == lines


def test_a_file_name_that_is_no_text_is_told_as_well_as_can_be(folder: Folder) -> None:
    name = os.fsdecode(b"r\xff.urdf")
    (folder.path / name).write_text(FAULTY)
    assert folder.run("lint", name).stdout.startswith(f"{name}:1:")
    assert "r\ufffd.urdf:1:" in without_colours(on_a_terminal(folder, "lint", name))


def test_statistics_count_the_findings_of_each_rule_the_most_frequent_first(folder: Folder) -> None:
    one, other = fault(at(folder, "r.xacro", (1, 1))), fault(at(folder, "r.xacro", (1, 1)))._replace(code="UC900")
    warned = other._replace(severity=Severity.WARNING, name="odd")
    found = (one, *[warned] * 11, other)
    told = text.render(Report((robot(folder),), found, statistics=True)).splitlines()
    assert told[26:] == [
        "    11  warning UC900 odd",
        "     1  error   UC900 wrong",
        "     1  error   UC901 wrong",
        "2 errors, 11 warnings in r.xacro (noetic)",
    ]
    assert told[:13] == text.render(Report((robot(folder),), found)).splitlines()[:13]


def test_what_the_baseline_hides_is_counted(folder: Folder) -> None:
    assert (
        text.render(Report((robot(folder),), (), known=3))
        == "no findings in r.xacro (noetic); 3 hidden by the baseline\n"
    )


def test_the_last_line_counts_what_can_be_fixed(folder: Folder) -> None:
    where = at(folder, "r.xacro", (1, 1))
    edit = (ShownEdit(where, "x"),)
    fixes = [Repair("a", safe=True, edits=edit), Repair("b", safe=False, edits=edit), Repair("c", safe=False)]
    safe, unsafe, by_hand = (
        fault(where, message=f"{n}!")._replace(fix=fix) for n, fix in zip("abc", fixes, strict=True)
    )

    def last(*found: Diagnostic) -> str:
        return text.render(Report((robot(folder),), found)).splitlines()[-1].partition("; ")[2]

    assert last(safe, unsafe, by_hand) == "1 fixable with --fix, 1 more with --unsafe-fixes"
    assert last(safe) == "1 fixable with --fix"
    assert last(unsafe, by_hand) == "1 fixable with --unsafe-fixes"
    assert last(by_hand) == ""


# -- order, blank lines, and what is folded --------------------------------------------------------------------------


def found(folder: Folder, *lines: tuple[str, str, str, int]) -> Report:
    by_letter = {"e": Severity.ERROR, "w": Severity.WARNING, "i": Severity.INFO}
    findings = [
        fault(at(folder, name, (line, 1)), message=f"{code} is wrong")._replace(code=code, severity=by_letter[letter])
        for letter, code, name, line in lines
    ]
    return Report((robot(folder),), tuple(causes_first(findings)))


def test_errors_come_first_and_what_the_runtime_meets_first_before_the_rest(folder: Folder) -> None:
    told = text.render(
        found(
            folder,
            ("w", "UC156", "a.xacro", 1),
            ("e", "UC450", "b.yaml", 2),
            ("e", "UC508", "c.xacro", 3),
            ("e", "UC201", "c.xacro", 1),
            ("e", "UC002", "d.xacro", 4),
        )
    )
    assert told.splitlines() == [
        "d.xacro:4:1: error UC002 UC002 is wrong",
        "",
        "c.xacro:1:1: error UC201 UC201 is wrong",
        "",
        "c.xacro:3:1: error UC508 UC508 is wrong",
        "",
        "b.yaml:2:1: error UC450 UC450 is wrong",
        "",
        "a.xacro:1:1: warning UC156 UC156 is wrong",
        "",
        "4 errors, 1 warning in r.xacro (noetic)",
    ]


def test_of_one_severity_what_explains_others_comes_first(folder: Folder) -> None:
    first, second = found(folder, ("e", "UC101", "a", 1), ("e", "UC601", "b", 1)).findings
    cause = second._replace(notes=(Remark(f"{EXPLAINS}2 findings of UC603, not shown"),))
    assert causes_first([first, cause]) == [cause, first]


def test_info_is_a_count_beside_anything_worse(folder: Folder) -> None:
    report = found(folder, ("i", "UC616", "a", 1), ("w", "UC156", "b", 1), ("i", "UC616", "c", 1))
    assert text.render(report).splitlines() == [
        "b:1:1: warning UC156 UC156 is wrong",
        "",
        "1 warning, 2 info (--verbose shows it) in r.xacro (noetic)",
    ]
    for shown_all in (report._replace(verbose=True), report._replace(fail_on=Severity.INFO)):
        assert text.render(shown_all).count("info UC616") == 2
    assert concise.render(report).count("info UC616") == 2
    alone = found(folder, ("i", "UC616", "a", 1))
    assert text.render(alone).splitlines()[0] == "a:1:1: info UC616 UC616 is wrong"
    assert text.render(alone).splitlines()[-1] == "1 info in r.xacro (noetic)"


def test_what_holds_for_all_is_said_once_at_the_end(folder: Folder) -> None:
    same, own = Remark("applies to ROS 1"), Remark("see there")
    report = found(folder, ("e", "UC201", "a", 1), ("w", "UC156", "b", 1), ("w", "UC157", "c", 1))
    first, second, third = report.findings
    noted = (first._replace(notes=(same,)), second._replace(notes=(own, same)), third._replace(notes=(same,)))
    said = text.render(report._replace(findings=noted[1:]))
    assert (said.count("applies to ROS 1"), "all of these: applies to ROS 1\n" in said, "note: see there" in said) == (
        1,
        True,
        True,
    )
    assert "all warnings: applies to ROS 1\n" in text.render(report._replace(findings=(first, *noted[1:])))
    assert "note: applies to ROS 1" in text.render(report._replace(findings=noted))  # of the only error


@pytest.mark.parametrize(("start", "cut"), [(1, "abcdefg"), (500, "…"), (995, "…")])
def test_where_a_long_line_goes_on_stands_an_ellipsis(folder: Folder, start: int, cut: str) -> None:
    line = "".join(chr(ord("a") + number % 26) for number in range(1000))
    told = text.render(Report((), (fault(at(folder, "r.xacro", (1, start), (1, start + 5)), line),)))
    shown_line = told.splitlines()[1].removeprefix("  1 | ")
    assert shown_line.startswith(cut)
    assert shown_line.endswith("…") is (start < 900)
