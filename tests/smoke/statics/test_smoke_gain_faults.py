"""An unstable loop is told which gain of which joint is wrong, and up to which value it would be stable."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from smoking import smoked, target_of

from urdfctl.rules.smoke.common import GAINS, LIFT


def found(folder: Path, gains: str, robot: str = LIFT) -> list[str]:
    yaml = (GAINS % "mover").replace("p: 4000.0, i: 100.0, d: 400.0", gains)
    result = smoked(target_of(folder, {"robot.urdf": robot.strip(), "controllers.yaml": yaml}), distro="jazzy")
    return [f"{one.code}:{one.at.line} {one.message}" for one in result.linted.outcome.diagnostics]


LINE = 13
"""The line of the gains in the controller file."""


@pytest.mark.parametrize(
    ("gains", "code", "words"),
    [
        ("p: -4000.0, i: 0.0, d: 400.0", "UC916", "p of joint 'lift' is -4000, which pushes it away"),
        ("p: 4000.0, i: -5.0, d: 400.0", "UC916", "i of joint 'lift' is -5, which pushes it away"),
        (
            "p: 4000.0, i: 100.0, d: 9000.0",
            "UC916",
            "d of joint 'lift' is 9000, but is stable only up to 5e+03",
        ),
        ("p: 9000000.0, i: 0.0, d: 1000.0", "UC916", "p of joint 'lift' is 9e+06, but is stable only up to"),
        ("p: 0.0, i: 0.0, d: 400.0", "UC987", "for joint 'lift' are 0"),
    ],
)
def test_the_gain_is_named_at_its_line(gains: str, code: str, words: str, tmp_path: Path) -> None:
    [message] = found(tmp_path, gains)
    assert message.startswith(f"{code}:{LINE} ")
    assert words in message


@pytest.mark.parametrize("gains", ["p: 4000.0, i: 100.0, d: 400.0", "p: 4000.0, i: 0.0, d: 2500.0"])
def test_a_stable_loop_is_left_alone(gains: str, tmp_path: Path) -> None:
    assert found(tmp_path, gains) == []


def test_the_range_that_is_told_is_stable(tmp_path: Path) -> None:
    [message] = found(tmp_path, "p: 4000.0, i: 100.0, d: 9000.0")
    most = re.search(r"up to (\S+)", message)
    assert most
    assert found(tmp_path, f"p: 4000.0, i: 100.0, d: {0.8 * float(most[1])}") == []


@pytest.mark.parametrize(
    ("gains", "d", "words"),
    [
        ("p: 4000.0, i: 900.0", 0.0, r"d of joint 'lift' is 0, which is too low: (\S+) steadies it with the 5 kg"),
        (
            "p: 4000.0, i: 9000.0",
            10.0,
            r"i of joint 'lift' is 9000, but is stable only up to .*, or with a d of (\S+)$",
        ),
    ],
)
def test_the_damping_that_is_told_to_help_makes_the_loop_stable(
    gains: str, d: float, words: str, tmp_path: Path
) -> None:
    [message] = found(tmp_path, f"{gains}, d: {d}")
    enough = re.search(words, message)
    assert enough, message
    assert not any("UC916" in one for one in found(tmp_path, f"{gains}, d: {float(enough[1])}"))


@pytest.mark.parametrize(("p", "expected"), [("50.0", []), ("900.0", []), ("1100.0", ["UC916"]), ("-5.0", ["UC916"])])
def test_a_loop_that_holds_a_velocity_is_stable_below_twice_the_mass_per_update(
    p: str, expected: list[str], tmp_path: Path
) -> None:
    """A mass of 5 kg at 100 Hz: the loop is unstable from p = 2 m / T = 1000 on."""
    yaml = f"""
controller_manager:
  ros__parameters:
    update_rate: 100
    speed: {{type: pid_controller/PidController}}
speed:
  ros__parameters:
    dof_names: [lift]
    command_interface: effort
    reference_and_state_interfaces: [velocity]
    gains: {{lift: {{p: {p}, i: 0.0, d: 0.0}}}}
"""
    result = smoked(target_of(tmp_path, {"robot.urdf": LIFT.strip(), "controllers.yaml": yaml}), distro="jazzy")
    assert [one.code for one in result.linted.outcome.diagnostics] == expected
