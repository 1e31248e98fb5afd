"""Equal findings of one file are one finding with the places of the others."""

from __future__ import annotations

from pathlib import Path

from urdfctl.diagnostic import Diagnostic, Location, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.findings.grouping import grouped
from urdfctl.lint.findings.likeness import difference
from urdfctl.report.words import likewise


def found(
    message: str, line: int, *, severity: Severity = Severity.WARNING, code: str = "UC901", file: str = "/r.urdf"
) -> Diagnostic:
    return Diagnostic(code, "wrong", severity, message, Location(file, line, 1, line, 5, 10 * line, 10 * line + 4))


def fixed(finding: Diagnostic, text: str, *, at: Location | None = None, safe: bool = True) -> Diagnostic:
    return finding._replace(fix=Repair(f"write {text}", safe, (ShownEdit(at or finding.at, text),)))


def test_findings_that_differ_in_names_and_numbers_are_one_with_the_names_and_lines_of_the_others() -> None:
    [one] = grouped(found(f"link '{name}' weighs {line} kg", line) for line, name in enumerate("abcdef", 1))
    assert one.message == "link 'a' weighs 1 kg"
    assert [remark.at.line for remark in one.also if remark.at] == [2, 3, 4, 5, 6]
    assert likewise(one) == "also 'b' (line 2), 'c' (line 3), 'd' (line 4) and 2 more"


def test_findings_in_the_same_words_are_listed_by_line() -> None:
    [one] = grouped(found("attribute 'x' is ignored", line) for line in range(1, 15))
    assert likewise(one) == "also in lines 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 and 3 more"


def test_findings_at_one_place_are_listed_by_name() -> None:
    [one] = grouped(found(f"package '{name}' is not declared", 1) for name in "abcde")
    assert likewise(one) == "also 'b', 'c', 'd' and 'e'"


def test_the_worst_of_equal_findings_at_one_place_is_shown() -> None:
    severities = {"a": Severity.INFO, "b": Severity.WARNING, "c": Severity.INFO}
    [one] = grouped(found(f"package '{name}' is not declared", 1, severity=kind) for name, kind in severities.items())
    assert (one.severity, one.message, likewise(one)) == (
        Severity.WARNING,
        "package 'b' is not declared",
        "also 'a' and 'c'",
    )


def test_one_piece_of_advice_for_several_names_joins_them() -> None:
    [one] = grouped(
        found(f"no parameter 'limits.{name}'; did you mean '{name}'?", line) for line, name in enumerate("ab", 1)
    )
    assert likewise(one) == "also 'limits.b' (line 2)"


def test_other_rules_files_severities_words_and_advice_stay_apart() -> None:
    apart = [
        found("link 'a' is wrong", 1),
        found("link 'a' is wrong", 2, code="UC902"),
        found("link 'a' is wrong", 3, file="/s.urdf"),
        found("link 'a' is wrong", 4, severity=Severity.INFO),
        found("link 'a' is thin", 5),
        found("link 'a' is wrong; did you mean 'b'?", 6),
        found("link 'a' is wrong; did you mean 'c'?", 7),
    ]
    assert grouped(apart) == sorted(apart, key=lambda finding: finding.order)


def test_up_to_three_equal_errors_are_shown_one_by_one() -> None:
    errors = [found("joint has no limit", line, severity=Severity.ERROR) for line in range(1, 5)]
    assert len(grouped(errors[:3])) == 3
    assert len(grouped(errors)) == 1


def test_of_a_rule_with_more_than_ten_findings_in_a_file_all_are_one() -> None:
    many = [found(f"'{name}' is unknown; did you mean '{name}s'?", line) for line, name in enumerate("abcdefghijk", 1)]
    [one] = grouped(many)
    assert len(one.also) == 10
    assert len(grouped(many[:10])) == 10


def test_a_package_that_is_missing_in_several_files_is_one_fault() -> None:
    [one] = grouped(found("package 'x' was not found", 1, code="UC003", file=f"/{name}.urdf") for name in "ab")
    assert likewise(one) == "also in /b.urdf:1"


def test_equal_findings_on_the_same_line_of_copied_files_are_one_with_the_files_of_the_others() -> None:
    copies = [
        found("setting 'a' is ignored", line, file=f"/{name}.xacro")._replace(excerpt=f"{' ' * line}<a/>")
        for line, name in enumerate("abcdefg", 1)
    ]
    [one] = grouped(copies)
    assert likewise(one) == "also in /b.xacro:2, /c.xacro:3, /d.xacro:4, /e.xacro:5 and 2 more"
    assert [remark.at.file for remark in one.also if remark.at] == [f"/{name}.xacro" for name in "bcdefg"]


def test_findings_of_copied_files_are_listed_after_those_of_the_first_file() -> None:
    several = [
        found(f"setting '{name}' is ignored", line, file=file)._replace(excerpt=f"<{name}/>")
        for file in ("/one.xacro", "/two.xacro")
        for line, name in enumerate("ab", 1)
    ]
    [one] = grouped(several)
    assert likewise(one) == "also 'b' (line 2), and in /two.xacro:1"


def test_errors_of_copied_files_and_findings_on_other_lines_of_text_stay_apart() -> None:
    def in_file(name: str, text: str, severity: Severity) -> Diagnostic:
        finding = found("setting 'a' is ignored", 1, severity=severity, file=f"/{name}.xacro")
        return finding._replace(excerpt=text)

    assert len(grouped([in_file(name, "<a/>", Severity.ERROR) for name in "ab"])) == 2
    assert len(grouped([in_file(name, f"<a b='{name}'/>", Severity.WARNING) for name in "ab"])) == 2
    assert len(grouped([in_file(name, "", Severity.WARNING) for name in "ab"])) == 2


def test_what_a_fix_repairs_stays_apart_for_each_file(tmp_path: Path) -> None:
    one, other = (
        found("setting 'a' is ignored", 1, file=f"{tmp_path}/{name}")._replace(excerpt="<a/>") for name in "ab"
    )
    assert len(grouped([fixed(one, "b"), fixed(other, "b")])) == 2
    assert len(grouped([one, other])) == 1


def test_meshes_that_are_missing_in_one_folder_are_one_fault_and_in_two_folders_two() -> None:
    def missing(mesh: str, line: int, file: str) -> Diagnostic:
        message = f"mesh of link 'l{line}' does not exist: 'package://arm/{mesh}.stl'; did you mean 'x/{line}.stl'?"
        return found(message, line, code="UC149", file=file)

    same = [missing("meshes/a", 1, "/r.urdf"), missing("meshes/b", 2, "/r.urdf"), missing("meshes/a", 3, "/s.urdf")]
    one, other = grouped([*same, missing("visual/a", 4, "/s.urdf")])
    assert likewise(one) == "also 'l2' (line 2), and in /s.urdf:3"
    assert not other.also


def test_files_that_one_package_does_not_install_are_one_fault() -> None:
    def missing(line: int, file: str, package: str) -> Diagnostic:
        note = Remark("the package's manifest is here", Location(f"/{package}/package.xml", 1, 1, 1, 1, 0, 0))
        message = f"'f{line}' is not installed: CMakeLists.txt does not list it"
        return found(message, line, code="UC615", file=file)._replace(notes=(note,))

    one, other = grouped([missing(1, "/a.launch", "p"), missing(2, "/b.launch", "p"), missing(3, "/c.launch", "q")])
    assert likewise(one) == "also in /b.launch:2"
    assert not other.also


def test_the_fixes_of_equal_findings_are_one_fix() -> None:
    one, other = fixed(found("tag 'a' has no prefix", 1), "x"), fixed(found("tag 'b' has no prefix", 2), "x")
    [both] = grouped([one, other])
    assert both.fix == Repair("write x in 2 places", True, (ShownEdit(one.at, "x"), ShownEdit(other.at, "x")))


def test_insertions_at_one_place_are_made_one_after_the_other() -> None:
    at = Location("/package.xml", 9, 1, 9, 1, 90, 90)
    several = [fixed(found(f"package '{name}' is not declared", 1), f"<{name}/>", at=at) for name in "ab"]
    [one] = grouped(several)
    assert one.fix == Repair("write <a/>, and 1 more like it", True, (ShownEdit(at, "<a/><b/>"),))


def test_a_finding_with_an_unsafe_fix_is_not_joined_with_a_safe_one() -> None:
    safe = fixed(found("tag 'a' has no prefix", 1), "x")
    assert len(grouped([safe, fixed(found("tag 'b' has no prefix", 2), "x", safe=False)])) == 2


def test_the_difference_of_two_messages_is_the_first_name_that_differs() -> None:
    assert difference("link 'a' of 'r' weighs 1 kg", "link 'b' of 's' weighs 2 kg") == "'b'"
    assert difference("<box> of 'a'", "<sphere> of 'a'") == "<sphere>"
    assert difference("read only in foxy to iron", "read only in humble") == "read only in humble"
    assert difference("not read in rolling", "not read in jazzy") == ""
    assert difference("link 'a' is heavy", "link 'a' is light") == "link 'a' is light"
    assert difference("no link 'a'; did you mean 'aa'?", "no link 'b'; did you mean 'bb'?") == "'b'"
    assert difference("no link 'a'; did you mean 'aa'?", "no link 'b'") == "'b'"
    assert difference("no link 'a'; did you mean 'aa'?", "two links 'b'") == "two links 'b'"


def test_a_repeated_name_is_listed_by_its_line() -> None:
    [one] = grouped(found(f"setting '{name}' is ignored", line) for line, name in enumerate("aab", 1))
    assert likewise(one) == "also line 2 and 'b' (line 3)"


def test_a_remark_without_a_place_is_listed_by_its_name() -> None:
    one = found("link 'a' is wrong", 1)._replace(also=(Remark("link 'b' is wrong"),))
    assert likewise(one) == "also 'b'"


def test_warnings_that_depend_on_an_unknown_distro_are_one_from_three_in_a_file_on() -> None:
    def dependent(name: str, line: int, applies: str, severity: Severity = Severity.WARNING) -> Diagnostic:
        message = f"no parameter '{name}'; replacement: {name}_{line}"
        return found(message, line, severity=severity)._replace(notes=(Remark(f"applies to {applies}"),))

    names = list(enumerate("abc", 1))
    [one] = grouped(dependent(name, line, "jazzy") for line, name in names)
    assert (one.message, likewise(one)) == ("no parameter 'a'; replacement: a_1", "also 'b' (line 2) and 'c' (line 3)")
    assert [note.message for note in one.notes] == ["applies to jazzy"]
    [one] = grouped(dependent(name, line, "jazzy" if line > 1 else "kilted") for line, name in names)
    assert one.notes == ()
    assert len(grouped(dependent(name, line, "jazzy") for line, name in names[:2])) == 2
    assert len(grouped(dependent(name, line, "jazzy", Severity.ERROR) for line, name in names)) == 3
    assert len(grouped(dependent(name, line, "jazzy")._replace(notes=()) for line, name in names)) == 3


def test_an_old_way_to_write_in_several_files_is_one_matter_but_not_where_it_is_an_error() -> None:
    def bare(file: str, severity: Severity = Severity.WARNING) -> Diagnostic:
        return fixed(found("interface has no prefix", 1, severity=severity, code="UC018", file=file), "x")

    [one] = grouped([bare("/left.xacro"), bare("/right.xacro")])
    assert likewise(one) == "also in /right.xacro:1"
    assert one.fix is not None
    assert [edit.at.file for edit in one.fix.edits] == ["/left.xacro", "/right.xacro"]
    assert len(grouped([bare("/left.xacro", Severity.ERROR), bare("/right.xacro", Severity.ERROR)])) == 2
