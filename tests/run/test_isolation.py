"""No Python of ours runs what lies in the folder that it starts in: the command, its workers, those of the server."""

from __future__ import annotations

import ast
import asyncio
import json
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder

from urdfctl.config.settings import Settings
from urdfctl.lint.job import job_for, lint_work
from urdfctl.load.target import Target
from urdfctl.run.fresh import run_all_fresh
from urdfctl.run.limits import Limits
from urdfctl.server.commands.processes import pip_install, run_command

ROBOT = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" value="${1 + 1}"/>
  <link name="base"/>
</robot>
"""
SPY = "import os\nwith open(os.path.join({folder!r}, 'was_run'), 'a') as file:\n    file.write({name!r} + '\\n')\n"
LATER = ("json.py", "yaml.py", "xacro/__init__.py", "xacro/xmlutils.py", "typer.py", "rich/__init__.py", "jinja2.py")
"""What a command imports after it has started."""
AT_START = (
    "sitecustomize.py",
    "usercustomize.py",
    "encodings/__init__.py",
    "urdfctl/__init__.py",
    "urdfctl/__main__.py",
)
"""What Python itself imports, or `python -m urdfctl`."""
RELATIVE = [".", "inside", f"inside{os.pathsep}", f"{os.pathsep}/nowhere"]
"""Values of PYTHONPATH by which Python finds modules in the current folder, or below it."""


def hostile(folder: Folder, modules: tuple[str, ...]) -> None:
    """Write a robot, and modules that say so when they run: here and in the folder `inside`."""
    for name in modules:
        text = SPY.format(folder=str(folder.path), name=name)
        folder.write({name: text, f"inside/{name}": text})
    folder.write({"arm.xacro": ROBOT})


def run_in(folder: Folder) -> list[str]:
    """The modules of the folder that have run."""
    told = folder.path / "was_run"
    return sorted(set(told.read_text().split())) if told.exists() else []


def started(folder: Folder, words: list[str], variables: Mapping[str, str]) -> subprocess.CompletedProcess[str]:
    environ = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(
        words, cwd=folder.path, env={**environ, **variables}, capture_output=True, text=True, timeout=60, check=False
    )


EXPAND = ("expand", "arm.xacro")
"""A command that is imported by typer, and that loads xacro."""


def test_the_module_runs_nothing_of_the_current_folder(folder: Folder) -> None:
    hostile(folder, LATER)
    ran = started(folder, [sys.executable, "-m", "urdfctl", *EXPAND], {})
    assert ('<link name="base"/>' in ran.stdout, run_in(folder)) == (True, []), ran.stderr


@pytest.mark.parametrize("entries", RELATIVE)
def test_the_command_runs_nothing_of_the_current_folder_though_pythonpath_names_it(
    folder: Folder, entries: str
) -> None:
    command = Path(sys.executable).parent / "urdfctl"
    if not command.is_file():
        pytest.skip("urdfctl is not installed beside this Python")
    hostile(folder, LATER)
    ran = started(folder, [str(command), *EXPAND], {"PYTHONPATH": entries})
    assert ('<link name="base"/>' in ran.stdout, run_in(folder)) == (True, []), ran.stderr


def test_folders_that_pythonpath_names_in_full_are_kept(folder: Folder) -> None:
    folder.write({"other/there.py": "", "here/arm.xacro": ROBOT})
    code = (
        "import sys; from urdfctl.startup.isolation import leave_current_folder; leave_current_folder(); import there"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code],
        cwd=folder.path / "here",
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(folder.path / "other"), str(CHECKOUT)])},
        check=False,
    )
    assert ran.returncode == 0


def test_it_runs_in_the_folder_that_it_is_installed_in(folder: Folder) -> None:
    ran = subprocess.run(
        [sys.executable, "-m", "urdfctl", "rules", "--select", "UC121"],
        cwd=CHECKOUT,
        env={**os.environ, "PYTHONPATH": ""},
        capture_output=True,
        check=False,
    )
    assert ran.returncode == 0


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not remove a folder that a process is in")
def test_a_folder_that_was_removed_while_one_is_in_it_is_no_obstacle(folder: Folder) -> None:
    gone = folder.path / "gone"
    gone.mkdir()
    line = f"cd '{gone}' && rmdir '{gone}' && exec '{sys.executable}' -I -m urdfctl --version"
    assert started(folder, ["sh", "-c", line], {}).stdout.startswith("urdfctl ")


@pytest.mark.skipif(sys.platform == "win32", reason="the program of this test is a shell script")
@pytest.mark.parametrize("entry", ["", ".", "inside"])
def test_no_program_of_the_current_folder_runs_though_path_names_it(folder: Folder, entry: str) -> None:
    for name in ("git", "inside/git"):
        folder.write({name: f"#!/bin/sh\necho {name} >> '{folder.path}/was_run'\n", "arm.xacro": ROBOT})
        (folder.path / name).chmod(0o755)
    path = os.pathsep.join([entry, os.environ["PATH"]])
    started(folder, [sys.executable, "-m", "urdfctl", "diff", "HEAD:", "arm.xacro"], {"PATH": path})
    assert run_in(folder) == []


@pytest.mark.parametrize("entries", RELATIVE)
def test_a_fresh_worker_runs_nothing_of_the_current_folder(
    folder: Folder, entries: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    hostile(folder, (*LATER, *AT_START))
    monkeypatch.setenv("PYTHONPATH", entries)
    job = job_for(lint_work, Target("arm.xacro"), Settings())
    [result] = run_all_fresh([job], "urdfctl.lint.job:perform_alone", Limits(60.0, 2 << 30, {}), 1)
    assert (getattr(result, "reason", None), run_in(folder)) == (None, [])


@pytest.mark.parametrize("entries", RELATIVE)
def test_a_command_of_the_server_runs_nothing_of_the_folder_that_it_works_in(
    folder: Folder, entries: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    hostile(folder, (*LATER, *AT_START))
    monkeypatch.setenv("PYTHONPATH", entries)
    words = ["lint", "arm.xacro", "--format", "json"]
    ended = asyncio.run(run_command(words, str(folder.path), lambda _line: None, asyncio.Event()))
    assert (ended.status, run_in(folder)) == (0, []), ended
    assert [target["robot"] for target in json.loads(ended.output)["targets"]] == ["arm.xacro"]


def test_what_the_server_tells_people_to_type_runs_nothing_of_the_folder_they_are_in(folder: Folder) -> None:
    hostile(folder, ("pip/__init__.py", "pip/__main__.py"))
    started(folder, ["sh", "-c", pip_install("view").replace(" install ", " --version #")], {})
    assert run_in(folder) == []


def test_every_process_of_python_is_started_by_the_one_function_that_isolates_it() -> None:
    naming = {
        path.relative_to(CHECKOUT).as_posix()
        for path in sorted((CHECKOUT / "urdfctl").rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute) and ast.unparse(node) == "sys.executable"
    }
    assert naming == {"urdfctl/startup/isolation.py"}
