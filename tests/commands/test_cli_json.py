"""`--format json` of every command: one object on standard output, and nothing else anywhere."""

from __future__ import annotations

import json
import shlex
from pathlib import Path
from typing import Any

import pytest
from doc_lines import copied_samples
from folder import CHECKOUT
from generating import command
from jsonschema import Draft202012Validator

from urdfctl.commands import COMMANDS, command_named
from urdfctl.commands.answering import AnswerOptions

SPEAKS_ANOTHER = {"server": "it answers editors in JSON-RPC"}
WORDS = {
    "lint": "urdf/robot.xacro",
    "smoke": "urdf/robot.xacro --engine none",
    "check": "urdf/robot.xacro --engine none",
    "show": "",
    "doctor": "now.json",
    "why": "urdf/robot.xacro joint:elbow/limit/@velocity",
    "diff": "urdf/robot.xacro urdf/body.xacro",
    "graph": "launch/bringup.launch.py",
    "view": "urdf/robot.xacro -o robot.html",
    "explain": "UC201",
    "rules": "--select UC201",
    "expand": "urdf/robot.xacro",
    "gen-all": "urdf/body.xacro --distro jazzy --simulator gz -o made",
    "gen-moveit": "urdf/body.xacro --distro jazzy --samples 10 -o made",
    "gen-controllers": "urdf/robot.xacro --type trajectory --joints elbow --distro jazzy -o made.yaml",
    "gen-transmissions": "urdf/body.xacro --interface effort --distro noetic",
    "gen-ros2-control": "urdf/robot.xacro --joints elbow --hardware mock --distro jazzy",
    "gen-gazebo": "--simulator gz --distro jazzy --into urdf/body.xacro",
    "gen-launch": "urdf/robot.xacro --distro jazzy --simulator gz -o made.launch.py",
    "gen-check": "urdf config",
    "convert": "urdf/robot.xacro --to mjcf -o made.xml",
    "migrate": ". --to kilted",
    "init": "--force",
    "schema": "controllers --distro jazzy",
}
ANSWER = json.loads((CHECKOUT / "urdfctl/output/answer.schema.json").read_text("utf-8"))


def answer_of(name: str, words: str) -> Any:
    """What a command prints as JSON."""
    ran = command(name, *shlex.split(words), "--format", "json")
    assert ran.stderr == "", "a program reads one stream"
    answer = json.loads(ran.stdout)
    if issubclass(command_named(name).options, AnswerOptions):
        Draft202012Validator(ANSWER).validate(answer)
        assert (answer["command"], answer["status"]) == (name, ran.returncode)
    return answer


@pytest.mark.parametrize("name", [name for name in COMMANDS if name not in SPEAKS_ANOTHER])
def test_every_command_answers_in_json(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert any("--format" in option.flags for option in command_named(name).options.declared.values())
    with copied_samples() as root:
        monkeypatch.chdir(root / "samples/picker")
        assert answer_of(name, WORDS[name])


def test_a_generator_names_its_files_and_what_to_do_next(monkeypatch: pytest.MonkeyPatch) -> None:
    with copied_samples() as root:
        monkeypatch.chdir(root / "samples/picker")
        made = answer_of("gen-all", WORDS["gen-all"])
        assert {file["state"] for file in made["files"]} == {"written"}
        assert all(Path(file["path"]).is_file() for file in made["files"])
        assert made["next"][-1] == "urdfctl lint made && urdfctl smoke made"
        assert {file["state"] for file in answer_of("gen-check", "made")["files"]} == {"unchanged"}
        Path("made/config/controllers.yaml").write_text("# made by hand\n")
        stale = answer_of("gen-check", "made")
        assert (stale["status"], [one["path"] for one in stale["files"] if one["state"] == "out of date"]) == (
            1,
            ["made/config/controllers.yaml"],
        )


def test_what_is_inserted_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    with copied_samples() as root:
        monkeypatch.chdir(root / "samples/picker")
        ran = command("gen-gazebo", *shlex.split(WORDS["gen-gazebo"]))
        assert "lines inserted into 'urdf/body.xacro' from line" in ran.stderr
        assert ran.stderr.endswith("urdfctl: next: urdfctl lint urdf/body.xacro\n")


def test_what_cannot_be_expanded_is_a_finding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("r.xacro").write_text("<robot><link name='a'></robot>")
    for words in (("expand", "r.xacro"), ("gen-all", "r.xacro --distro jazzy -o made")):
        answer = answer_of(*words)
        assert (answer["status"], bool(answer["findings"])) == (1, True)


def test_a_report_as_text_has_no_file_of_its_own() -> None:
    ran = command("schema", "urdf", "--format", "text=report.txt")
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: --format text is printed; json=FILE writes a file\n",
    )
