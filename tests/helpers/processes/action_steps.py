"""The shell steps of action.yml, run as GitHub's runner runs them."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml
from folder import CHECKOUT

ACTION: dict[str, Any] = yaml.safe_load((CHECKOUT / "action.yml").read_text(encoding="utf-8"))
STEPS: dict[str, dict[str, Any]] = {step["name"]: step for step in ACTION["runs"]["steps"]}
_EXPRESSION = r"\$\{\{ (\S+) \}\}"


class Job:
    """A job of a workflow that uses the action in a checkout.

    runner: a folder for the files that the runner gives to a step.
    source: the folder of the action.
    installed: whether the step Install has run already; its Python is one that runs this checkout's urdfctl.
    """

    def __init__(self, checkout: Path, runner: Path, *, source: Path = CHECKOUT, installed: bool = True) -> None:
        self.checkout = checkout
        self.temp = runner / "temp"
        self.temp.mkdir(parents=True, exist_ok=True)
        self.summary = runner / "summary.md"
        self.outputs: dict[str, str] = {}
        if installed:
            self.outputs["steps.install.outputs.python"] = str(self._python())
        self._output = runner / "output"
        self._source = source

    def step(
        self, name: str, inputs: Mapping[str, str], variables: Mapping[str, str], *, base: str = ""
    ) -> subprocess.CompletedProcess[str]:
        """Run a step with the inputs of a workflow, and environment variables that replace the test's own.

        base: the branch that a pull request wants to change.
        """
        expressions = {
            **{f"inputs.{key}": inputs.get(key, spec["default"]) for key, spec in ACTION["inputs"].items()},
            **self.outputs,
            "github.action_path": str(self._source),
            "github.base_ref": base,
        }
        of_step = {
            name: re.sub(_EXPRESSION, lambda found: expressions[found[1]], value)
            for name, value in STEPS[name]["env"].items()
        }
        self._output.write_text("")
        ran = subprocess.run(
            ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", STEPS[name]["run"]],
            cwd=self.checkout,
            env={
                **{name: value for name, value in os.environ.items() if name != "PYTHONPATH"},
                **variables,
                **of_step,
                "RUNNER_TEMP": str(self.temp),
                "GITHUB_WORKSPACE": str(self.checkout),
                "GITHUB_OUTPUT": str(self._output),
                "GITHUB_STEP_SUMMARY": str(self.summary),
            },
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
        step_id = STEPS[name].get("id", name)
        self.outputs |= {f"steps.{step_id}.outputs.{key}": value for key, value in self.told().items()}
        return ran

    def _python(self) -> Path:
        path = self.temp / "python"
        code = f"import sys; sys.path.insert(0, {str(CHECKOUT)!r}); from urdfctl.__main__ import main; main()"
        lines = ['test "$1 $2 $3" = "-I -m urdfctl" || exit 99', "shift 3"]
        path.write_text("\n".join(["#!/bin/sh", *lines, f'exec "{sys.executable}" -I -c "{code}" "$@"', ""]))
        path.chmod(0o755)
        return path

    def told(self) -> dict[str, str]:
        """The outputs of the last step, as the runner reads them."""
        return dict(line.split("=", 1) for line in self._output.read_text().splitlines())


def obeyed(printed: str) -> list[str]:
    """The workflow commands among the lines that a step printed, as the runner obeys them.

    A command is `::name …::` at the start of a line, or `##[name …]` anywhere in it; between `::stop-commands::TOKEN`
    and `::TOKEN::` there are none.
    """
    found, token = [], None
    for line in printed.splitlines():
        if token is not None:
            token = None if line.strip() == f"::{token}::" else token
        elif stopped := re.fullmatch(r"\s*::stop-commands::(\S+)", line):
            token = stopped[1]
        elif re.match(r"\s*::[\w-]+[ :]", line) or re.search(r"##\[[\w-]+", line):
            found.append(line)
    return found
