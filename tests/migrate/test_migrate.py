"""`urdfctl migrate` as a user meets it: what it shows, writes and refuses to write."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from folder import Folder, environment
from migrated_packages import FILES, MANIFEST, MIGRATED, ROBOT, content

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Edit
from urdfctl.migrate.engine import Migration, migrate
from urdfctl.migrate.options import MigrationOptions, Part
from urdfctl.migrate.packages import Linted, MigratedPackages
from urdfctl.migrate.report import ReportLine, as_json, as_markdown
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.migrate.trial.linting import Lint
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.output.change import Change
from urdfctl.output.journal import restore_unfinished
from urdfctl.output.writing_all import write_all
from urdfctl.source.disk.gate import reading_within
from urdfctl.source.span import Place, SourceSpan


def test_without_further_options_migrate_prints_a_diff_that_git_applies_and_writes_nothing(folder: Folder) -> None:
    folder.write(FILES)
    before = content(folder)
    ran = folder.run("migrate", "arm", "--to", "jazzy")
    assert (ran.returncode, content(folder)) == (1, before)
    subprocess.run(["git", "apply"], cwd=folder.path, input=ran.stdout, encoding="utf-8", check=True)
    assert content(folder) == {**before, "urdf/arm.urdf.xacro": MIGRATED.encode()}


def test_a_diff_of_files_elsewhere_has_the_paths_of_their_repository(folder: Folder) -> None:
    folder.write({f"work/{name}": text for name, text in FILES.items()})
    subprocess.run(["git", "init", "-q", "work"], cwd=folder.path, check=True)
    (folder.path / "here").mkdir()
    ran = folder.run("migrate", "../work/arm", "--to", "jazzy", cwd=folder.path / "here")
    assert ran.returncode == 1, ran.stderr
    subprocess.run(["git", "apply"], cwd=folder.path / "work", input=ran.stdout, text=True, check=True)
    assert (folder.path / "work/arm/urdf/arm.urdf.xacro").read_text() == MIGRATED


def test_the_order_of_the_packages_does_not_matter(folder: Folder) -> None:
    first = ROBOT.replace("ign_ros2_control/IgnitionSystem", "fake_components/GenericSystem")
    more = {"more/package.xml": MANIFEST.replace("arm", "more"), "more/urdf/more.urdf.xacro": first}
    folder.write({**FILES, **more})
    there, back = (folder.run("migrate", *names, "--to", "jazzy") for names in (("arm", "more"), ("more", "arm")))
    assert there.returncode == 1
    assert (there.stdout, there.stderr) == (back.stdout, back.stderr)


def test_in_place_changes_only_the_bytes_that_it_must_and_writes_a_report(folder: Folder) -> None:
    folder.write(FILES)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    assert (ran.returncode, ran.stdout) == (0, "")
    assert (folder.path / "arm/urdf/arm.urdf.xacro").read_text() == MIGRATED
    report = (folder.path / "arm/MIGRATION.md").read_text()
    assert "`urdf/arm.urdf.xacro:10`: 'ign_ros2_control/IgnitionSystem' was renamed" in report


def test_a_migrated_package_is_not_changed_again_and_gets_no_second_report(folder: Folder) -> None:
    folder.write(FILES)
    folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    (folder.path / "arm/MIGRATION.md").unlink()
    once = content(folder)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    assert (ran.returncode, content(folder)) == (0, once)


def test_output_gets_the_whole_package_and_the_report_as_json(folder: Folder) -> None:
    folder.write(FILES)
    before = content(folder)
    folder.run("migrate", "arm", "--to", "jazzy", "-o", "new", "--report", "new.json")
    assert content(folder) == before
    assert content(folder, "new") == {**before, "urdf/arm.urdf.xacro": MIGRATED.encode()}
    [done] = json.loads((folder.path / "new.json").read_text())["done"]
    assert (done["file"], done["line"]) == ("urdf/arm.urdf.xacro", 10)


def test_changes_that_are_not_committed_are_not_overwritten_without_force(folder: Folder) -> None:
    folder.write(FILES)
    subprocess.run(["git", "init", "-q"], cwd=folder.path / "arm", check=True)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    assert ran.returncode == 2
    assert "not committed" in ran.stderr
    assert content(folder)["urdf/arm.urdf.xacro"] == ROBOT.encode()
    assert folder.run("migrate", "arm", "--to", "jazzy", "--in-place", "--force").returncode == 0


def test_files_that_git_ignores_are_left_alone(folder: Folder) -> None:
    folder.write({**FILES, "arm/.gitignore": "made\n", "arm/made/urdf/arm.urdf": ROBOT})
    subprocess.run(["git", "init", "-q"], cwd=folder.path / "arm", check=True)
    folder.run("migrate", "arm", "--to", "jazzy", "--in-place", "--force")
    after = content(folder)
    assert after["made/urdf/arm.urdf"] == ROBOT.encode()
    assert after["urdf/arm.urdf.xacro"] == MIGRATED.encode()


@pytest.mark.parametrize("hidden", [".catkin_tools/profiles/default/packages", ".cache"])
def test_packages_in_hidden_folders_are_left_alone(folder: Folder, hidden: str) -> None:
    """Tools keep copies of packages there, which neither colcon nor catkin builds."""
    copy = {f"arm/{hidden}/{name}": text for name, text in FILES.items()}
    folder.write({**FILES, **copy})
    folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    after = content(folder)
    assert after[f"{hidden}/arm/urdf/arm.urdf.xacro"] == ROBOT.encode()
    assert after["urdf/arm.urdf.xacro"] == MIGRATED.encode()


def test_the_report_names_files_in_messages_as_at_their_places() -> None:
    lost = ReportLine(
        EntryKind.FOR_YOU, "it would cause UC615 at /ws/arm/setup.py:3", file="/ws/arm/launch/a.launch.py"
    )
    for render in (as_markdown, as_json):
        report = render([lost], None, "jazzy", "/ws")
        assert "it would cause UC615 at arm/setup.py:3" in report
        assert "/ws" not in report


def test_a_package_of_the_same_name_elsewhere_in_the_workspace_is_not_taken_for_it(folder: Folder) -> None:
    named = {f"{name}/package.xml": MANIFEST.replace("arm", name) for name in ("base", "hand")}
    folder.write({**FILES, **named, "old/package.xml": MANIFEST, ".git/HEAD": ""})
    scratch = Scratch([str(folder.path / "arm")])
    scratch.close()
    assert sorted(Path(other).name for other in scratch.others) == ["base", "hand"]


def test_only_the_parts_that_are_named_are_migrated(folder: Folder) -> None:
    folder.write(FILES)
    assert folder.run("migrate", "arm", "--to", "jazzy", "--only", "yaml,launch").returncode == 0
    assert folder.run("migrate", "arm", "--to", "jazzy", "--only", "urdf").returncode == 1


def test_a_file_that_a_program_changed_meanwhile_stops_the_whole_write(folder: Folder) -> None:
    folder.write({"a": "1", "b": "changed"})
    files = [str(folder.path / name) for name in ("a", "b", "c")]
    changes = [Change(files[0], b"1", b"2"), Change(files[1], b"1", b"2"), Change(files[2], None, b"2")]
    [problem] = write_all(changes)
    assert "was changed by another program" in problem
    assert content(folder, ".") == {"a": b"1", "b": b"changed"}


KILLED = """\
import os, signal, sys
left = int(sys.argv[1])
def killing(real):
    def call(*paths):
        global left
        left -= ".urdfctl-cache" not in str(paths[0])
        if left < 0:
            os.kill(os.getpid(), signal.SIGKILL)
        real(*paths)
    return call
os.replace, os.unlink = killing(os.replace), killing(os.unlink)
from urdfctl.output.writing_all import write_all
from urdfctl.output.change import Change
wanted = [("a", b"1", b"2"), ("b", b"1", None), ("c", None, b"2"), ("d", b"1", b"2")]
write_all([Change(os.path.abspath(name), before, after) for name, before, after in wanted])
os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")
@pytest.mark.parametrize("renames", range(5))
def test_what_a_run_left_that_was_killed_at_a_rename_is_restored_by_the_next_one(
    folder: Folder, renames: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    cache = folder.path / ".urdfctl-cache"
    monkeypatch.setenv("XDG_CACHE_HOME", str(cache))
    before = {"a": b"1", "b": b"1", "d": b"1"}
    folder.write(before)
    ran = subprocess.run([sys.executable, "-c", KILLED, str(renames)], env=dict(os.environ), check=False)
    assert ran.returncode == -signal.SIGKILL
    is_finished = renames == 4
    after = {"a": b"2", "c": b"2", "d": b"2"}
    told = restore_unfinished()
    assert not [path for path in cache.rglob("*") if path.is_file()]
    assert content(folder, ".") == (after if is_finished else before)
    assert ["before a run that was killed" in line for line in told] == [True] * (0 if is_finished else renames)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")
def test_what_several_runs_left_is_restored_with_its_rights(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder.path / ".urdfctl-cache"))
    before = {f"{root}/{name}": b"1" for root in ("one", "two", "three") for name in "abd"}
    folder.write(before)
    for root in ("one", "two", "three"):
        (folder.path / root / "b").chmod(0o750)
        subprocess.run([sys.executable, "-c", KILLED, "3"], cwd=folder.path / root, env=dict(os.environ), check=False)
        assert not (folder.path / root / "b").exists()
    os.rename("three", "moved")
    os.symlink("moved", "three")  # what is at another place now is left alone
    restore_unfinished()
    after = {"moved/a": b"2", "moved/c": b"2", "moved/d": b"1"}
    assert content(folder, ".") == {**{name: b"1" for name in before if name[:5] != "three"}, **after}
    assert {(folder.path / root / "b").stat().st_mode & 0o777 for root in ("one", "two")} == {0o750}


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")
@pytest.mark.parametrize("after", [0.2, 0.6, 1.0, 1.4])
def test_a_run_that_is_killed_leaves_all_files_as_they_were_or_as_they_should_be(folder: Folder, after: float) -> None:
    folder.write({**FILES, **{f"arm/urdf/other_{n}.urdf": ROBOT for n in range(6)}})
    before = content(folder)
    command = [sys.executable, "-m", "urdfctl", "migrate", "arm", "--to", "jazzy", "--in-place"]
    running = subprocess.Popen(command, cwd=folder.path, env=environment({}), stderr=subprocess.DEVNULL)
    time.sleep(after)
    running.send_signal(signal.SIGKILL)
    running.wait()
    now = content(folder)
    after_all = {**dict.fromkeys(before, MIGRATED.encode()), "package.xml": MANIFEST.encode()}
    assert {name: now.get(name) for name in before} in (before, after_all)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["arm"], "--to requires the distro"),
        (["arm", "--to", "jazy"], "did you mean 'jazzy'"),
        (["arm", "--to", "noetic"], "--to: 'noetic' is a distro of ROS 1"),
        (["arm", "--to", "jazzy", "--only", "yml"], "unknown part 'yml'"),
        (["arm", "--to", "jazzy", "--in-place", "-o", "x"], "exclude each other"),
        (["leg", "--to", "jazzy"], "does not exist"),
        (["arm", "--from", "jazzy", "--to", "humble"], "'humble' is earlier than 'jazzy'"),
    ],
)
def test_what_migrate_cannot_do_is_said_in_one_line(folder: Folder, words: list[str], told: str) -> None:
    folder.write(FILES)
    ran = folder.run("migrate", *words)
    assert (ran.returncode, ran.stderr.count("\n")) == (2, 1)
    assert told in ran.stderr


def test_errors_that_only_the_target_has_are_in_the_report(folder: Folder) -> None:
    unknown = ROBOT.replace(
        "</ros2_control>", '<joint name="ghost"><state_interface name="position"/></joint></ros2_control>'
    )
    folder.write({**FILES, "arm/urdf/arm.urdf.xacro": unknown})
    folder.run("migrate", "arm", "--from", "humble", "--to", "jazzy", "--report", "report.json")
    left = json.loads((folder.path / "report.json").read_text())["for_you"]
    assert [entry["message"] for entry in left if "ghost" in entry["message"]]


Propose = Callable[[MigratedPackages], Iterator[Proposal]]


def result_of(
    folder: Path,
    *steps: tuple[str, Propose],
    lint: Callable[[Scratch], Any] = Lint,
    distro: str = "jazzy",
    is_needed: bool = False,
) -> Migration:
    """The migration of the package arm by some steps, given by name and function."""
    scratch = Scratch([str(folder / "arm")])
    own = [Step(name, Part.URDF, "a change", propose, is_needed=is_needed) for name, propose in steps]
    result = migrate(scratch, MigrationOptions(distro), Settings(workspace=scratch.root), lint(scratch), own)
    scratch.close()
    return result


def replacing(*pairs: tuple[str, str], only_with: str = "", apart: bool = True) -> Propose:
    """Return a function that proposes to replace texts in descriptions that contain another one: each, or all at once.

    An empty text is inserted before the next one.
    """

    def propose(packages: MigratedPackages) -> Iterator[Proposal]:
        for path in packages.files(".xacro", ".urdf"):
            source = packages.read(path)
            found = [source.data.find((old or pairs[-1][0]).encode()) for old, _ in pairs]
            if min(found) < 0 or only_with.encode() not in source.data:
                continue
            spans = (SourceSpan(source, at, at + len(old)) for at, (old, _) in zip(found, pairs, strict=True))
            edits = [Edit(span, new) for span, (_, new) in zip(spans, pairs, strict=True)]
            yield from (Proposal(edits=(edit,)) for edit in edits) if apart else [Proposal(edits=tuple(edits))]

    return propose


BREAKING = replacing(('<joint name="elbow"><', '<joint name="gone"><'))
RENAMING = replacing(("ign_ros2_control/IgnitionSystem", "gz_ros2_control/GazeboSimSystem"))


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        (
            '<link name="tip"/>',
            '<link name="tip"/><xacro:include filename="gone.xacro"/>',
            "not be expanded any more",
        ),
        ("</ros2_control>", "</ros2_control>\n  {}", "not changed by step"),
    ],
)
def test_a_step_after_which_the_robot_is_no_whole_one_is_left_out_and_named(
    tmp_path: Path, old: str, new: str, why: str
) -> None:
    second = ROBOT[ROBOT.index("<ros2_control") : ROBOT.index("</ros2_control>")].replace('name="arm"', 'name="b"')
    text = new.format(f"{second}</ros2_control>")
    broken = ROBOT.replace(old, text).replace("ign_ros2_control/IgnitionSystem", "gz_ros2_control/GazeboSimSystem")
    Folder(tmp_path).write({**FILES, "arm/urdf/has_it_already.urdf.xacro": broken})
    doing = replacing((old, text), only_with="ign_ros2_control")
    result = result_of(tmp_path, ("spoil", doing), ("rename", RENAMING))
    assert [change.after for change in result.changes] == [MIGRATED.encode()]
    assert [line.step for line in result.lines if why in line.message] == ["spoil"]


def test_a_change_that_would_cause_a_finding_of_a_new_kind_is_left_out_and_reported(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)
    result = result_of(tmp_path, ("breaking", BREAKING))
    assert result.changes == ()
    assert "not changed by step 'breaking'" in result.lines[0].message


def test_what_lint_finds_in_a_file_that_must_change_is_reported_and_does_not_keep_its_old_form(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)
    result = result_of(tmp_path, ("breaking", BREAKING), is_needed=True)
    [change] = result.changes
    assert b'"gone"' in (change.after or b"")
    found = [line for line in result.lines if "'gone'" in line.message]
    assert found
    assert {line.kind for line in found} == {EntryKind.FOR_YOU}


def test_the_steps_that_must_be_left_out_of_many_files_are_found_at_once(tmp_path: Path) -> None:
    Folder(tmp_path).write({**FILES, **{f"arm/urdf/other_{n}.urdf": ROBOT for n in range(6)}})
    runs = []

    class Counting(Lint):
        def __call__(self, settings: Settings) -> Linted:
            runs.append(settings.distro)
            return super().__call__(settings)

    result = result_of(tmp_path, ("breaking", BREAKING), ("renaming", RENAMING), lint=Counting)
    assert [change.after for change in result.changes] == [MIGRATED.encode()] * 7
    assert sum("step 'breaking'" in line.message for line in result.lines) == 7
    assert runs.count("jazzy") <= 20  # each attempt lints three times, of which two are known


def test_a_step_that_was_left_out_is_reported_although_it_proposes_nothing_later(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)
    breaking = replacing(('<joint name="elbow"><', '<joint name="gone"><'), only_with="ign_ros2_control/Ignition")
    result = result_of(tmp_path, ("breaking", breaking), ("renaming", RENAMING))
    assert [change.after for change in result.changes] == [MIGRATED.encode()]
    assert "not changed by step 'breaking'" in result.lines[0].message


def test_edits_of_one_change_that_touch_are_all_made(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)
    result = result_of(tmp_path, ("both", replacing(("", "<!-- new -->"), ("<!-- the hardware -->", ""), apart=False)))
    assert [change.after for change in result.changes] == [ROBOT.replace("<!-- the hardware", "<!-- new").encode()]


def test_changes_that_touch_each_other_are_made_one_after_the_other(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)
    result = result_of(tmp_path, ("both", replacing(("the hardware", "it"), ("hardware -->", "-->"))))
    assert [change.after for change in result.changes] == [ROBOT.replace("the hardware", "it").encode()]


def test_a_change_that_cannot_be_made_because_its_edits_overlap_is_reported(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)
    overlapping = replacing(("the hardware", "it"), ("hardware -->", "-->"), apart=False)
    result = result_of(tmp_path, ("both", overlapping))
    assert [line.message for line in result.lines] == ["not changed by step 'both': its changes overlap"]


def test_what_is_left_to_a_person_is_a_todo_at_its_line_and_at_the_line_of_a_new_file(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)

    def asking(packages: MigratedPackages) -> Iterator[Proposal]:
        for path in packages.files(".xacro"):
            source = packages.read(path)
            at = source.data.find(b"<ros2_control")
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, "think", Place(source, at, end=at + 1)),))
        new = str(Path(packages.scratch.folders[0]) / "new.yaml")
        if not Path(new).exists():
            text = "a: 1\n# TODO(urdfctl): look\n"
            yield Proposal(created=((new, text),), entries=(ReportEntry(EntryKind.FOR_YOU, "look", file=new),))

    result = result_of(tmp_path, ("asking", asking))
    todo = "  <!-- TODO(urdfctl): think -->\n  <ros2_control name="
    assert result.changes[1].after == ROBOT.replace("  <ros2_control name=", todo).encode()
    assert [(line.message, line.line) for line in result.lines] == [("think", 10), ("look", 2)]


def test_the_report_says_once_what_is_the_same_in_several_places() -> None:
    lines = [ReportLine(EntryKind.DONE, "it changed", file=f"/w/{name}", line=3) for name in ("a", "b")]
    report = as_markdown([*lines, ReportLine(EntryKind.DONE, "more", file="/w/a")], "humble", "jazzy", "/w")
    assert "- it changed.\n  - `a:3`\n  - `b:3`\n" in report
    assert "- `a`: more.\n" in report


def test_the_report_says_once_what_differs_in_one_name() -> None:
    def line(name: str, number: int) -> ReportLine:
        message = f"parameter 'joint' of '{name}' became dof_names"
        return ReportLine(EntryKind.DONE, message, file="/w/c.yaml", line=number)

    lines = [line(name, number) for number, name in enumerate(("a", "b", "c", "d", "e", "f", "g", "h", "i"), 1)]
    shown = as_markdown(lines, None, "jazzy", "/w")
    assert "- parameter 'joint' of 'a', 'b', 'c', 'd' and 5 more became dof_names.\n" in shown
    assert shown.count("c.yaml:") == 6
    assert "  - and 3 more places\n" in shown
    assert as_markdown(lines[:2], None, "jazzy", "/w").count("became dof_names") == 2


def test_what_lint_fixes_for_the_target_alone_does_not_keep_a_step_from_being_applied(folder: Folder) -> None:
    classic = ROBOT.replace("ign_ros2_control/IgnitionSystem", "gazebo_ros2_control/GazeboSystem")
    text = classic.replace("<!-- the hardware -->", "<!-- the hardware: simulated -->")
    plugin = '<plugin name="a" filename="libgazebo_own.so"><parameters>/opt/arm/c.yaml</parameters></plugin>'
    folder.write({**FILES, "arm/urdf/arm.urdf.xacro": text.replace("</robot>", f"<gazebo>{plugin}</gazebo></robot>")})

    def loading(packages: MigratedPackages) -> Iterator[Proposal]:
        for path in packages.files(".xacro"):
            source = packages.read(path)
            at = source.data.find(plugin.encode())
            new = plugin.replace("libgazebo_own.so", "libgazebo_ros2_control.so")
            if at >= 0:
                yield Proposal(edits=(Edit(SourceSpan(source, at, at + len(plugin)), new),))

    result = result_of(folder.path, ("loading", loading), distro="humble")
    [change] = result.changes
    assert b"libgazebo_ros2_control.so" in (change.after or b"")
    assert b"<!-- the hardware - simulated -->" in (change.after or b"")
    assert [line.message.partition(":")[0] for line in result.lines] == ["fixed UC359"]


def test_a_file_that_cannot_be_read_is_in_the_report(folder: Folder) -> None:
    folder.write({**FILES, "arm/urdf/broken.urdf": '<robot name="broken">\n  <link name="a"/\n</robot>\n'})
    ran = folder.run("migrate", "arm", "--from", "humble", "--to", "jazzy", "-o", "new")
    assert ran.returncode == 0, ran.stderr
    line = next(line for line in (folder.path / "new/MIGRATION.md").read_text().splitlines() if "broken.urdf" in line)
    assert "the file is not migrated, because it cannot be read (UC001: " in line


def test_lint_finds_each_todo_once_also_in_files_that_no_robot_reads(folder: Folder) -> None:
    todo = "<!-- TODO(urdfctl): decide this -->"
    files = {
        "arm/package.xml": MANIFEST.replace("<name>", f"{todo.replace('this', 'it')}<name>"),
        "arm/worlds/yard.world": f"<sdf>\n  {todo.replace('this', 'where')}\n</sdf>\n",
        "arm/config/filter.yaml": "# TODO(urdfctl): and this\na: 1\n",
        "arm/urdf/arm.urdf.xacro": MIGRATED.replace("  <!-- the hardware -->", f"  {todo}"),
        "arm/urdf/other.urdf.xacro": MIGRATED.replace('name="arm"', 'name="other"'),
    }
    folder.write(files)
    ran = folder.run("lint", "arm", "--select", "UC708", "--format", "concise")
    found = sorted(line.partition(": ")[0].rpartition("/")[2] for line in ran.stdout.splitlines() if "UC708" in line)
    assert found == ["arm.urdf.xacro:8:8", "filter.yaml:1:3", "package.xml:1:26", "yard.world:2:8"]


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights on Windows")
def test_what_links_lead_to_outside_of_the_workspace_is_not_read(folder: Folder) -> None:
    folder.write({f"checkout/{name}": text for name, text in {**FILES, ".git/HEAD": "", "own.world": "own"}.items()})
    folder.write({"home/secret.world": "secret", "home/urdfctl.toml": "secret"})
    for name, leads_to in {"arm/own.world": "checkout", "arm/secret.world": "home", "urdfctl.toml": "home"}.items():
        (folder.path / "checkout" / name).symlink_to(folder.path / leads_to / Path(name).name)
    os.chdir("checkout")
    read: dict[str, bytes] = {}

    def look(packages: MigratedPackages) -> Iterator[Proposal]:
        read.update({Path(path).name: packages.read(path).data for path in packages.files(".world")})
        read.update({name: b"copied" for name in os.listdir(packages.scratch.root) if name == "urdfctl.toml"})
        yield from ()

    with reading_within([str(folder.path / "checkout")]):
        result_of(folder.path / "checkout", ("look", look))
    assert read == {"own.world": b"own", "secret.world": b""}
