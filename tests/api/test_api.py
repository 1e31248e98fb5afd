"""urdfctl from Python: the same findings as the commands, nothing printed and nothing written."""

from __future__ import annotations

import json
import os
import re
import threading
from pathlib import Path
from typing import Any

import pytest
from folder import CHECKOUT, Folder

from urdfctl import api

BROKEN = CHECKOUT / "samples" / "broken"
MYBOT = CHECKOUT / "samples" / "mybot" / "urdf" / "mybot.xacro"
ARM = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="tip" default="hand"/>
  <link name="base"/><link name="$(arg tip)"/>
  <joint name="wrist" type="continuous"><parent link="base"/><child link="$(arg tip)"/></joint>
</robot>
"""


@pytest.mark.parametrize("sample", ["broken", "mybot", "gripper", "my_robot", "radu"])
def test_the_findings_are_those_of_the_command_each_once(sample: str, folder: Folder) -> None:
    path = CHECKOUT / "samples" / sample
    ran = folder.run("lint", str(path), "--format", "json", "--no-cache", "--exit-zero")
    told = [(one["code"], one["file"], one["line"], one["message"]) for one in json.loads(ran.stdout)["findings"]]
    found = [(one.code, one.at.file, one.at.line, one.message) for one in api.lint(path).findings]
    assert found == told
    assert len(set(found)) == len(found)


def test_options_take_paths_as_arguments_do(folder: Folder) -> None:
    folder.write({"arm.xacro": ARM})
    by_text = api.lint("arm.xacro", workspace=".", package_path=["."]).findings
    assert api.lint(Path("arm.xacro"), workspace=Path(), package_path=[Path()]).findings == by_text


def test_nothing_is_printed_written_or_left_changed(folder: Folder, capfd: pytest.CaptureFixture[str]) -> None:
    folder.write({"arm.xacro": ARM})
    here, before = os.getcwd(), sorted(os.listdir())
    api.lint("arm.xacro", args={"tip": "claw"}, distro="noetic")
    api.smoke("arm.xacro", engine="none")
    api.generate("gen-controllers", "arm.xacro", types=["effort"])
    api.migrate(CHECKOUT / "samples" / "mybot", to="jazzy")
    assert (os.getcwd(), sorted(os.listdir())) == (here, before)
    assert capfd.readouterr() == ("", "")
    assert Path(__file__).read_text(encoding="utf-8"), "what may be read is not limited after a call"


def test_a_description_is_expanded_and_loaded_with_its_arguments(folder: Folder) -> None:
    folder.write({"arm.xacro": ARM})
    assert '<link name="claw"/>' in api.expand("arm.xacro", {"tip": "claw"})
    robot = api.load_robot("arm.xacro", {"tip": "claw"})
    assert [link.name for link in robot.links] == ["base", "claw"]
    folder.write({"arm.xacro": ARM.replace("base", "body")})
    assert [link.name for link in api.load_robot("arm.xacro").links] == ["body", "hand"], "the disk is looked at again"


def test_generators_give_their_files_and_a_migration_its_changes() -> None:
    made = api.generate("gen-all", MYBOT, types=["effort"], distro="noetic")
    assert "config/controllers.yaml" in made
    assert "effort_controllers" in made["config/controllers.yaml"]
    changes = api.migrate(CHECKOUT / "samples" / "mybot", to="jazzy").changes
    assert any(b"<ros2_control" in (change.after or b"") for change in changes)


def test_a_robot_is_smoked_and_a_fault_explained() -> None:
    report = api.smoke(BROKEN, engine="none")
    assert [finding.code for finding in report.found.findings]
    assert "<hardwareInterface>" in api.explain("UC201")
    assert "p gain" in api.explain("No p gain specified for pid.")


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: api.lint("nowhere"), "file or folder 'nowhere' does not exist"),
        (lambda: api.expand("nowhere.xacro"), "file 'nowhere.xacro' does not exist"),
        (lambda: api.load_robot("nowhere.urdf"), "file or folder 'nowhere.urdf' does not exist|'nowhere.urdf'"),
        (lambda: api.load_robot("bad.urdf"), "bad.urdf' cannot be loaded"),
        (lambda: api.expand("bad.urdf"), "bad.urdf:1:"),
        (lambda: api.migrate(".", to="noetic"), "'noetic' is a distro of ROS 1"),
        (lambda: api.explain("UC999999"), "unknown rule 'UC999999'"),
        (lambda: api.generate("gen-check", "."), "'gen-check' is no generator"),
        (lambda: api.generate("gen-controllers", "bad.urdf"), "bad.urdf"),
        (lambda: api.lint(".", fail_on="often"), "often"),
    ],
)
def test_bad_input_is_an_error_in_one_line(call: object, said: str, folder: Folder) -> None:
    folder.write({"bad.urdf": "<robot"})
    assert callable(call)
    with pytest.raises(api.UserError, match=said):
        call()


def test_an_option_that_the_command_does_not_have_is_a_slip_of_the_program() -> None:
    with pytest.raises(TypeError, match="has no option distance"):
        api.lint(BROKEN, distance="noetic")


def test_threads_wait_for_each_other() -> None:
    found: list[int] = []
    threads = [threading.Thread(target=lambda: found.append(len(api.lint(BROKEN).findings))) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [len(api.lint(BROKEN).findings)] * 3


def test_the_examples_of_the_docs_run(folder: Folder, capsys: pytest.CaptureFixture[str]) -> None:
    page = (CHECKOUT / "docs" / "api.md").read_text(encoding="utf-8")
    first, tests = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    folder.write({"urdf/robot.xacro": ARM})
    exec(first.replace('"prefix"', '"tip"'), {})  # noqa: S102 (the page's own code)
    assert "UC" in capsys.readouterr().out
    names: dict[str, Any] = {}
    exec(tests, names)  # noqa: S102 (the page's own code)
    with pytest.raises(AssertionError):
        names["test_the_robot_can_be_started"]()
    folder.write({"urdf/robot.xacro": '<robot name="box"><link name="base"/></robot>'})
    names["test_the_robot_can_be_started"]()


def test_the_page_names_each_function() -> None:
    page = (CHECKOUT / "docs" / "api.md").read_text(encoding="utf-8")
    functions = {name for name in api.__all__ if callable(getattr(api, name)) and name.islower()}
    assert functions == set(re.findall(r"^\| `(\w+)\(", page, re.MULTILINE))
