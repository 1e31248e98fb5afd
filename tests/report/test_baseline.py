"""`--baseline`: known findings are hidden, wherever they move; new ones are reported, and fixed ones are counted."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from folder import Folder
from hypothesis import given, settings
from hypothesis import strategies as st
from reported import bare
from sampling import examples

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Severity
from urdfctl.errors import UserError
from urdfctl.report.baseline import KnownFinding, baseline_text, compare, read_baseline

FAULTY = """\
<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="odd"><parent link="a"/><child link="b"/></joint>
</robot>
"""
SECOND = '  <joint name="k" type="odder"><parent link="a"/><child link="b"/></joint>\n</robot>'
ONLY = ("--select", "UC121", "--format", "concise")


def test_a_baseline_is_sorted_and_readable(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    ran = folder.run("lint", "r.urdf", "--select", "UC121", "--write-baseline", "known.json")
    assert (ran.returncode, ran.stderr) == (0, "urdfctl: 1 finding written to 'known.json'\n")
    assert ran.stdout == "no findings in r.urdf; 1 hidden by the baseline\n"
    text = (folder.path / "known.json").read_text()
    assert text.startswith('{"version": 1, "tool": "urdfctl", "findings": [\n  {"code": "UC121", "file": "r.urdf", ')
    [finding] = json.loads(text)["findings"]
    assert ("'odd'" in finding["message"], len(finding["mark"]), finding["times"]) == (True, 32, 1)
    folder.run("lint", "r.urdf", "--select", "UC121", "--write-baseline", "known.json", "--baseline", "known.json")
    assert (folder.path / "known.json").read_text() == text


def test_what_is_known_is_hidden_although_it_moves_and_what_is_new_is_told(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    folder.run("lint", "r.urdf", "--write-baseline", "known.json")
    moved = FAULTY.replace('  <link name="a"/>', '\n\n<!-- -->\n\t<link name="a"/>').replace("  <joint", "      <joint")
    folder.write({"r.urdf": moved})
    ran = folder.run("lint", "r.urdf", *ONLY, "--baseline", "known.json")
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")
    folder.write({"r.urdf": moved.replace("</robot>", SECOND)})
    ran = folder.run("lint", "r.urdf", *ONLY, "--baseline", "known.json")
    assert (ran.returncode, ran.stdout.count("\n")) == (1, 1)
    assert ran.stdout.startswith("r.urdf:8:")


def test_of_alike_findings_as_many_are_hidden_as_are_known(folder: Folder) -> None:
    twice = FAULTY.replace("</robot>", FAULTY.splitlines()[3] + "\n</robot>")
    folder.write({"r.urdf": FAULTY})
    folder.run("lint", "r.urdf", *ONLY, "--write-baseline", "known.json")
    folder.write({"r.urdf": twice})
    ran = folder.run("lint", "r.urdf", *ONLY, "--baseline", "known.json")
    assert [line.split(":")[1] for line in ran.stdout.splitlines()] == ["5"]


def test_fixed_findings_are_reported_on_standard_error(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY.replace("</robot>", SECOND)})
    folder.run("lint", "r.urdf", *ONLY, "--write-baseline", "known.json")
    folder.write({"r.urdf": FAULTY})
    ran = folder.run("lint", "r.urdf", *ONLY, "--baseline", "known.json")
    assert (ran.returncode, ran.stdout) == (0, "")
    assert ran.stderr == (
        "urdfctl: fixed: 1 finding in baseline 'known.json'; --write-baseline known.json removes what is fixed\n"
    )


def test_findings_in_files_that_this_run_did_not_check_are_not_fixed(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY, "s.urdf": FAULTY})
    folder.run("lint", "r.urdf", "s.urdf", "--write-baseline", "known.json")
    assert folder.run("lint", "r.urdf", "--baseline", "known.json").stderr == ""
    assert folder.run("lint", "r.urdf", "s.urdf", "--select", "UC2", "--baseline", "known.json").stderr == ""
    (folder.path / "s.urdf").unlink()
    assert "fixed: 1 finding" in folder.run("lint", "r.urdf", *ONLY, "--baseline", "known.json").stderr


def test_paths_count_from_the_folder_of_the_file(folder: Folder) -> None:
    folder.write({"one/urdf/r.urdf": FAULTY, "one/config/x": ""})
    folder.run("lint", "urdf", "--write-baseline", "config/known.json", cwd=folder.path / "one")
    shutil.move("one", "two")
    ran = folder.run("lint", "r.urdf", "--baseline", "../config/known.json", cwd=folder.path / "two/urdf")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "hidden by the baseline" in ran.stdout


def test_a_finding_in_a_macro_is_known_whichever_robot_calls_it_first(folder: Folder) -> None:
    head = '<robot name="{}" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="m.xacro"/>'
    macro = head.format("m").split("<xacro:include")[0] + (
        '<xacro:macro name="m" params="n"><link name="${n}"/><link name="${n}2"/>\n'
        '<joint name="${n}j" type="odd"><parent link="${n}"/><child link="${n}2"/></joint></xacro:macro></robot>'
    )
    robots = {f"{name}.xacro": f'{head.format(name)}<xacro:m n="{name}"/></robot>' for name in ("a", "b")}
    folder.write({"m.xacro": macro, **robots})
    folder.run("lint", "a.xacro", "b.xacro", "--write-baseline", "known.json")
    ran = folder.run("lint", "b.xacro", "--baseline", "known.json")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert folder.run("lint", "b.xacro").returncode == 1


def test_a_fault_of_ours_is_never_known(folder: Folder) -> None:
    ours = bare(Severity.ERROR)._replace(code="UC000")
    assert read_of(folder, baseline_text([ours], "known.json")) == []
    known = [KnownFinding("UC000", "../elsewhere/r.urdf", "it is so", "", 9)]
    assert compare([ours], known, "known.json", lambda *_: False).new == [ours]


def read_of(folder: Folder, text: str) -> list[KnownFinding]:
    folder.write({"known.json": text})
    return read_baseline("known.json")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "invalid JSON: Expecting value: line 1 column 1 (char 0)"),
        ('{"version": 1', "invalid JSON: Expecting ',' delimiter: line 1 column 14 (char 13)"),
        (b"\xff\xfe\xfd\xfc", None),
        ("[" * 100_000, None),
        ("[]", "it has no version or no findings"),
        ('{"version": 2, "findings": []}', "its version is 2, not 1"),
        ('{"version": 1, "findings": {}}', None),
        ('{"version": 1, "findings": [7]}', "finding 1 has a missing or malformed field"),
        (
            '{"version": 1, "findings": [{"code": "UC1", "file": "f", "message": "m", "mark": "x", "times": 0}]}',
            "finding 1 has a missing or malformed field",
        ),
        ('{"version": 1, "findings": [{"code": "UC1", "file": "f", "message": "m", "mark": 3}]}', None),
    ],
)
def test_a_broken_file_is_one_line_and_status_2(folder: Folder, text: str | bytes, told: str | None) -> None:
    folder.write({"r.urdf": FAULTY, "known.json": text})
    ran = folder.run("lint", "r.urdf", "--baseline", "known.json")
    assert (ran.returncode, ran.stdout, ran.stderr.count("\n")) == (2, "", 1)
    assert ran.stderr.startswith("urdfctl: 'known.json' is not a baseline")
    assert told is None or ran.stderr.endswith(f": {told}\n")


def test_a_file_that_is_not_there_says_how_to_make_it(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    ran = folder.run("lint", "r.urdf", "--baseline", "known.json")
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: baseline 'known.json' does not exist; --write-baseline known.json creates it\n",
    )
    ran = folder.run("lint", "r.urdf", "--write-baseline", "nowhere/known.json")
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: 'nowhere/known.json' cannot be written: No such file or directory\n",
    )


def test_the_reports_tell_how_many_are_hidden(folder: Folder) -> None:
    folder.write({"r.urdf": FAULTY})
    folder.run("lint", "r.urdf", "--write-baseline", "known.json")
    whole = json.loads(folder.run("lint", "r.urdf", "--baseline", "known.json", "--format", "json").stdout)
    assert (whole["findings"], whole["summary"]["known"] > 0, whole["summary"]["error"]) == ([], True, 0)


TEXTS = st.text(st.characters(exclude_categories=()))
FINDINGS = st.builds(
    Diagnostic,
    st.sampled_from(["UC105", "UC201"]),
    st.just("a-fault"),
    st.just(Severity.ERROR),
    TEXTS,
    st.builds(Location, st.just("/a/r.urdf"), *[st.integers(1, 9)] * 6),
    st.sampled_from([(), ((CallStep("/r", 1, 1, "macro m"),),)]),
    excerpt=TEXTS,
)


@settings(max_examples=examples(25))
@given(st.lists(FINDINGS, max_size=8), st.lists(FINDINGS, max_size=3))
def test_a_baseline_contains_exactly_the_findings_of_its_run(
    tmp_path_factory: pytest.TempPathFactory, findings: list[Diagnostic], more: list[Diagnostic]
) -> None:
    path = str(tmp_path_factory.getbasetemp() / "known.json")
    Path(path).write_text(baseline_text(findings, path))
    known = read_baseline(path)
    assert sum(one.times for one in known) == len(findings)
    assert compare(findings, known, path, lambda *_: True) == ([], len(findings), [])
    comparison = compare([*findings, *more], known, path, lambda *_: True)
    assert (len(comparison.new), comparison.known, comparison.fixed) == (len(more), len(findings), [])
    fewer = compare(findings[1:], known, path, lambda *_: True)
    assert sum(finding.times for finding in fewer.fixed) == min(len(findings), 1)


def test_text_that_is_not_utf_8_is_told(folder: Folder) -> None:
    folder.write({"known.json": b'{"version": "\xff"}'})
    with pytest.raises(UserError, match="is not a baseline: invalid JSON"):
        read_baseline("known.json")


# -- the key of the configuration --------------------------------------------------------------------------------------

NAMED = {"r.urdf": FAULTY, "urdfctl.toml": 'baseline = "ci/known.json"\n', "ci/README": ""}


def test_the_baseline_of_the_configuration_is_used_wherever_lint_runs(folder: Folder) -> None:
    folder.write(NAMED)
    ran = folder.run("lint", "r.urdf")
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: baseline 'ci/known.json' does not exist; --write-baseline ci/known.json creates it\n",
    )
    folder.run("lint", "r.urdf", "--write-baseline", "ci/known.json")
    for cwd, path in ((folder.path, "r.urdf"), (folder.path / "ci", "../r.urdf")):
        ran = folder.run("lint", path, *ONLY, cwd=cwd)
        assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")
    folder.write({"none.json": '{"version": 1, "findings": []}'})
    assert folder.run("lint", "r.urdf", *ONLY, "--baseline", "none.json").returncode == 1
    assert 'baseline = "ci/known.json"' in folder.run("lint", "--show-settings").stdout


def test_lint_and_smoke_share_one_baseline_and_neither_touches_what_the_other_found(folder: Folder) -> None:
    folder.write(NAMED)
    folder.run("lint", "r.urdf", "--select", "UC121", "--write-baseline", "ci/known.json")
    data = json.loads((folder.path / "ci/known.json").read_text())
    data["findings"].append({"code": "UC916", "file": "r.urdf", "message": "it shakes", "mark": "0" * 32, "times": 1})
    folder.write({"ci/known.json": json.dumps(data)})
    folder.write({"r.urdf": FAULTY.replace("odd", "fixed")})
    assert folder.run("lint", "r.urdf").stderr.startswith("urdfctl: fixed: 1 finding in baseline")
    folder.run("lint", "r.urdf", "--select", "UC121", "--write-baseline", "ci/known.json")
    left = json.loads((folder.path / "ci/known.json").read_text())["findings"]
    assert [finding["code"] for finding in left] == ["UC916"]


def test_a_configuration_of_the_project_names_no_baseline_outside_of_it(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "r.urdf": FAULTY, "urdfctl.toml": 'baseline = "../known.json"\n'})
    ran = folder.run("lint", "r.urdf")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr == (
        "urdfctl: urdfctl.toml: baseline: file '../known.json' is outside the workspace; name it with --baseline\n"
    )
