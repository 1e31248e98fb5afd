"""`urdfctl rules`, `urdfctl explain` and the command itself."""

from __future__ import annotations

import json
import os
import re

import pytest
from folder import Folder
from sampling import sample
from typer.testing import CliRunner, Result

from urdfctl import __version__
from urdfctl.commands.app import app
from urdfctl.errors import UserError
from urdfctl.fault import Fault
from urdfctl.rules import all_faults, command_of

FAULTS = all_faults()


def command(*words: str) -> Result:
    """What the command does in this process; an exception rises."""
    return CliRunner().invoke(app, list(words), catch_exceptions=False, terminal_width=200)


def test_the_rules_are_listed_a_line_each() -> None:
    ran = command("rules")
    assert ran.exit_code == 0
    lines = ran.stdout.splitlines()
    assert [line.split()[:3] for line in lines] == [[fault.code, fault.severity.value, fault.name] for fault in FAULTS]
    assert all(line.endswith(fault.summary) for line, fault in zip(lines, FAULTS, strict=True))


def test_the_rules_may_be_chosen_by_the_beginning_of_their_codes() -> None:
    ran = command("rules", "--select", "uc201,UC00")
    assert {line.split()[0][:4] for line in ran.stdout.splitlines()} == {"UC20", "UC00"}
    assert [line.split()[0] for line in ran.stdout.splitlines() if line.startswith("UC2")] == ["UC201"]


def test_the_rules_as_json_tell_all_of_them() -> None:
    given = json.loads(command("rules", "--format", "json").stdout)
    assert [rule["code"] for rule in given] == [fault.code for fault in FAULTS]
    assert set(given[0]) == {
        *("code", "name", "severity", "summary", "why", "runtime", "because", "authority", "distros"),
        *("origin", "prints"),
    }


def test_an_unknown_format_of_the_rules_is_refused() -> None:
    with pytest.raises(UserError, match="unknown format 'yaml'; known are text, json"):
        command("rules", "--format", "yaml")


def test_a_rule_is_explained_with_its_reason_its_authority_and_its_examples(folder: Folder) -> None:
    told = command("explain", "UC201").stdout
    assert told.startswith(
        "UC201 transmission-joint-without-interface (error; indigo to noetic)\n\nTransmission joint without"
    )
    for part in ("ros_control skips the joint", "Authority: ros_control", "Wrong:", "Right:", "robot.urdf:"):
        assert part in told
    assert "To ignore it in one place: <!-- urdfctl: ignore[UC201] the reason -->" in told
    assert "«" not in told
    assert os.listdir() == []


def test_the_output_in_an_explanation_is_what_lint_says(folder: Folder) -> None:
    told = command("explain", "UC201").stdout
    real = re.search(r"Output of urdfctl lint:\n\n((?:  .*\n)+)", told)
    assert real
    first = real.group(1).splitlines()[0]
    assert re.match(r"  robot\.urdf:\d+:\d+: error UC201 joint 'elbow' of transmission 'elbow_trans' has no", first)


@pytest.mark.parametrize(
    "what", ["uc201", "transmission-joint-without-interface", "Transmission-Joint-Without-Interface"]
)
def test_a_rule_is_known_by_its_code_and_its_name_in_any_case(folder: Folder, what: str) -> None:
    assert command("explain", what).stdout == command("explain", "UC201").stdout


@pytest.mark.parametrize("fault", sample(FAULTS, 24), ids=lambda fault: fault.code)
def test_every_rule_can_be_explained_and_its_example_shows_it(folder: Folder, fault: Fault) -> None:
    told = command("explain", fault.code).stdout
    assert told.startswith(fault.code)
    if "Wrong:" in told and command_of(fault.code) == "lint":
        assert f" {fault.code} " in told.partition("Output of urdfctl lint:")[2].partition("Right:")[0]


@pytest.mark.parametrize(
    ("what", "told"),
    [
        ("U201", "unknown rule 'U201'; did you mean 'UC201'? To list all rules, run urdfctl rules"),
        (
            "link-without-nam",
            "unknown rule 'link-without-nam'; did you mean 'link-without-name'? To list all rules, run urdfctl rules",
        ),
        ("nothing-like-it", "unknown rule 'nothing-like-it'. To list all rules, run urdfctl rules"),
    ],
)
def test_an_unknown_rule_is_told_with_the_nearest(what: str, told: str) -> None:
    with pytest.raises(UserError) as unknown:
        command("explain", what)
    assert str(unknown.value) == told


def test_an_unknown_rule_has_status_2(folder: Folder) -> None:
    ran = folder.run("explain", "nothing-like-it")
    assert (ran.returncode, ran.stdout, ran.stderr) == (
        2,
        "",
        "urdfctl: unknown rule 'nothing-like-it'. To list all rules, run urdfctl rules\n",
    )


@pytest.mark.parametrize("name", ["lint", "expand", "rules", "explain"])
def test_the_help_of_each_command_has_an_example(name: str) -> None:
    ran = command(name, "--help")
    assert ran.exit_code == 0
    assert re.search(rf"Example: urdfctl {name}\b", ran.stdout)
    assert command(name, "-h").stdout == ran.stdout


def test_the_help_names_every_command(folder: Folder) -> None:
    told = command("--help").stdout
    for name in ("lint", "expand", "rules", "explain"):
        assert re.search(rf"^ *{name} ", told, re.MULTILINE)


def test_no_word_at_all_shows_the_help(folder: Folder) -> None:
    ran = folder.run()
    assert "Usage: urdfctl [OPTIONS] COMMAND" in ran.stdout + ran.stderr
    assert "Traceback" not in ran.stderr


@pytest.mark.parametrize("words", [["lnt"], ["--unheard-of"], ["rules", "--formt", "x"]])
def test_an_unknown_command_or_option_has_status_2(folder: Folder, words: list[str]) -> None:
    ran = folder.run(*words)
    assert ran.returncode == 2
    assert ran.stderr.splitlines()[-1].startswith("Error: No such")


def test_the_version_is_told(folder: Folder) -> None:
    ran = folder.run("--version")
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, f"urdfctl {__version__}\n", "")


def test_the_rules_go_through_a_closed_pipe_and_any_locale(folder: Folder) -> None:
    assert folder.run("rules", environ={"PYTHONIOENCODING": "ascii"}).stdout == folder.run("rules").stdout
    assert folder.run("explain", "UC017", environ={"LC_ALL": "C", "PYTHONUTF8": "0"}).returncode == 0
