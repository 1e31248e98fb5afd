"""What the workflows of GitHub run is what this checkout has: commands, inputs, versions."""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from folder import CHECKOUT
from generating import command
from smoking_engines import needs_an_engine

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

WORKFLOWS = CHECKOUT / ".github" / "workflows"
pytestmark = pytest.mark.skipif(not WORKFLOWS.is_dir(), reason="the workflows are not part of an sdist")
PROJECT = tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def jobs(name: str) -> dict[str, Any]:
    """The jobs of a workflow."""
    read: dict[str, Any] = yaml.safe_load((WORKFLOWS / name).read_text(encoding="utf-8"))["jobs"]
    return read


def test_the_oldest_versions_are_those_that_the_package_and_its_extras_allow() -> None:
    lines = (CHECKOUT / ".github/oldest.txt").read_text(encoding="utf-8").splitlines()
    oldest = dict(line.split("==") for line in lines if not line.startswith("#"))
    extras = [line for name, wanted in PROJECT["optional-dependencies"].items() if name != "dev" for line in wanted]
    wanted = [line for line in (*PROJECT["dependencies"], *extras) if "python_version >=" not in line]
    allowed = dict(re.findall(r"^([\w-]+)>=([\d.]+)", "\n".join(wanted), re.MULTILINE))
    assert {name: version for name, version in oldest.items() if name != "click"} == allowed


def test_the_oldest_python_that_the_package_allows_is_tried_with_both() -> None:
    matrix = jobs("check.yml")["tests"]["strategy"]["matrix"]
    oldest = PROJECT["requires-python"].removeprefix(">=")
    assert (matrix["python"][0], matrix["versions"]) == (oldest, ["newest"])
    assert {"os": "ubuntu-latest", "python": oldest, "versions": "oldest"} in matrix["include"]


def test_our_own_action_is_given_inputs_that_it_has() -> None:
    inputs = yaml.safe_load((CHECKOUT / "action.yml").read_text(encoding="utf-8"))["inputs"]
    ours = [step for job in jobs("check.yml").values() for step in job["steps"] if step.get("uses") == "./"]
    assert len(ours) == 2
    assert [name for step in ours for name in step["with"] if name not in inputs] == []


@pytest.mark.parametrize("job", ["windows", pytest.param("wheel", marks=needs_an_engine)])
def test_the_commands_of_a_job_find_the_samples_sound(job: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(CHECKOUT)
    scripts = "\n".join(step["run"] for step in jobs("check.yml")[job]["steps"] if "run" in step)
    lines = re.findall(r"^ *(?:bare/bin/)?urdfctl (.*)$", scripts, re.MULTILINE)
    assert len(lines) >= 2
    for line in lines:
        assert command(*shlex.split(line)).returncode == 0, line


TO_MIGRATE = {"samples/gripper"}
"""What its warnings are about is mended by a migration, which test_samples.py makes and lints."""


def test_the_samples_that_the_action_looks_at_are_all_there_are() -> None:
    sound, broken = (
        step["with"]["paths"].split() for step in jobs("check.yml")["samples"]["steps"] if step.get("uses") == "./"
    )
    folders = {path.parent.relative_to(CHECKOUT).as_posix() for path in (CHECKOUT / "samples").glob("*/package.xml")}
    assert set(sound) == folders - TO_MIGRATE
    assert [Path(path).name for path in broken] == ["broken"]
