"""`urdfctl lint params.yaml --node NAME=definition.yaml` checks any node as a controller is checked."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from folder import Folder, environment

DEFINITION = """
localiser:
  rate: {type: double, validation: {gt<>: [0.0]}}
  frame: {type: string, default_value: map, validation: {one_of<>: [[map, odom]]}}
  sensors: {type: string_array, default_value: []}
  weights:
    __map_sensors:
      value: {type: double, default_value: 1.0}
"""


def said(folder: Folder, parameters: str, *options: str, name: str = "localiser") -> list[tuple[str, str, str]]:
    folder.write({"d.yaml": DEFINITION, "p.yaml": f"{name}:\n  ros__parameters: {parameters}\n"})
    ran = folder.run("lint", "p.yaml", "--node", "localiser=d.yaml", "--format", "json", *options)
    assert ran.stderr == ""
    return [(one["severity"], one["code"], one["message"]) for one in json.loads(ran.stdout)["findings"]]


@pytest.mark.parametrize("name", ["localiser", "/left/localiser", "/**"])
def test_right_parameters_of_a_node_have_no_findings(folder: Folder, name: str) -> None:
    parameters = "{rate: 2.0, frame: odom, sensors: [gps], weights: {gps: {value: 2.0}}, use_sim_time: true}"
    assert said(folder, parameters, "--distro", "jazzy", name=name) == []


@pytest.mark.parametrize(
    ("parameters", "expected"),
    [
        ("{rate: 0.0}", ("error", "UC433", "'rate' must be > 0.0, not 0.0")),
        ("{rate: fast}", ("error", "UC432", "'rate' must be a number with a decimal point, not the string 'fast'")),
        ("{rate: 1.0, frame: world}", ("error", "UC433", "'frame' must be 'map' or 'odom', not 'world'")),
        ("{rate: 1.0, fram: odom}", ("warning", "UC430", "'localiser' has no parameter 'fram'; did you mean 'frame'?")),
        ("{rate: 1.0, other: 1}", ("warning", "UC430", "'localiser' has no parameter 'other'; it is ignored")),
        ("{frame: odom}", ("error", "UC431", "node 'localiser' is missing 'rate', which its definition requires")),
    ],
)
def test_a_node_is_checked_with_its_definition(folder: Folder, parameters: str, expected: tuple[str, str, str]) -> None:
    assert said(folder, parameters, "--distro", "jazzy") == [expected]


def test_a_node_is_checked_without_a_distro(folder: Folder) -> None:
    assert [one[:2] for one in said(folder, "{rate: 0.0}")] == [("error", "UC433")]


@pytest.mark.parametrize(
    ("option", "message"),
    [
        ("localiser", "--node must be NAME=FILE, not 'localiser'"),
        ("localiser=absent.yaml", "'absent.yaml' cannot be read: No such file or directory"),
        ("localiser=p.yaml", "'p.yaml' does not define parameters in the form of generate_parameter_library"),
        (
            "localizer=d.yaml",
            "--node localizer: no file has parameters for a node of this name; did you mean 'localiser'?",
        ),
    ],
)
def test_a_definition_that_checks_nothing_is_an_error(folder: Folder, option: str, message: str) -> None:
    folder.write({"d.yaml": DEFINITION, "p.yaml": "localiser: {ros__parameters: {rate: 1.0}}"})
    ran = folder.run("lint", "p.yaml", "--node", option)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert message in ran.stderr


def test_a_node_without_parameters_is_an_error_also_when_the_results_are_from_an_earlier_run(folder: Folder) -> None:
    slow = (
        "import sys; from urdfctl.lint import cache; cache.STORE_FROM = 0; from urdfctl.__main__ import main; "
        "sys.argv[1:] = ['lint', 'p.yaml', '--node', 'localizer=d.yaml']; main()"
    )
    folder.write(
        {"d.yaml": DEFINITION.replace("localiser", "localizer"), "p.yaml": "localiser:\n  ros__parameters: {}\n"}
    )
    environ = environment({"XDG_CACHE_HOME": str(folder.path / "cache")})
    (folder.path / "cache").mkdir()
    runs = [
        subprocess.run([sys.executable, "-c", slow], env=environ, capture_output=True, text=True, check=False)
        for _ in "ab"
    ]
    assert list((folder.path / "cache").rglob("*.json")) != []
    assert [(ran.returncode, ran.stdout) for ran in runs] == [(2, ""), (2, "")]
    assert runs[0].stderr == runs[1].stderr
