"""A command refuses a value that is none of an option's choices, and names it: the option alone does not."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from urdfctl.commands import COMMANDS, command_named
from urdfctl.commands.app import app
from urdfctl.errors import UserError

ARM = (
    '<robot name="arm"><link name="base"/><link name="fore"/><joint name="elbow" type="revolute"><parent link="base"/>'
    '<child link="fore"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="9" velocity="1"/></joint></robot>'
)
BESIDE = {
    "rules": (),
    "init": (),
    "server": (),
    "gen-check": (),
    "explain": ("a line of a log", "--in", "."),
    "why": ("arm.urdf", "link:base"),
    "schema": ("controllers",),
    "gen-launch": ("arm.urdf", "--type", "effort", "--distro", "noetic"),
    "gen-all": ("arm.urdf", "--type", "effort", "--distro", "noetic"),
    "migrate": (".", "--to", "jazzy"),
}
"""What a command line must have beside the option, where that is not just a robot."""


def cases() -> Iterator[tuple[str, str, str]]:
    """Yield each command with each of its options that has choices and no other values, by attribute and flag."""
    for name in COMMANDS:
        for attribute, one in command_named(name).options.declared.items():
            if one.choices and one.flags and not one.is_open:
                yield name, attribute, one.flags[-1]


@pytest.mark.parametrize(("command", "name", "flag"), list(cases()))
def test_a_value_that_is_no_choice_is_refused_by_name(
    command: str, name: str, flag: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("arm.urdf").write_text(ARM, encoding="utf-8")
    words = [command, *BESIDE.get(command, ("arm.urdf",)), f"{flag}=bogus"]
    ran = CliRunner().invoke(app, words)
    assert isinstance(ran.exception, UserError), (
        f"'urdfctl {' '.join(words)}' did not refuse it: compare the value with the choices where the command runs, "
        f"and raise UserError. What the command needs beside the option is in BESIDE.\n{ran.output[:500]}"
    )
    said, choices = str(ran.exception), ", ".join(command_named(command).options.declared[name].choices)
    assert "bogus" in said or said == f"{flag} must be {choices}", said
