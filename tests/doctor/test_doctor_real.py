"""The doctor and the real smoke test on a ROS 2 system that really runs; skipped where ROS 2 is not sourced."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from folder import Folder

from urdfctl.rules.running.samples import FILES

pytestmark = pytest.mark.skipif(
    shutil.which("ros2") is None or "AMENT_PREFIX_PATH" not in os.environ,
    reason="ROS 2 is not sourced (the scheduled workflow runs this in the official images)",
)
DESCRIPTION = FILES["arm.urdf"].replace("arm_driver/ArmSystem", "mock_components/GenericSystem")
SOURCES = {**FILES, "arm.urdf": DESCRIPTION}
START = 30.0
_MANAGER = ["ros2", "run", "controller_manager", "ros2_control_node"]
SOURCED = {name: value for name, value in os.environ.items() if name.startswith(("AMENT_", "ROS_"))}


@contextmanager
def running(folder: Path, controllers: str, *spawned: str) -> Iterator[None]:
    """A manager, its state publisher, and what a spawner starts; all end with the block."""
    parameters = {"/**": {"ros__parameters": {"robot_description": DESCRIPTION}}}
    (folder / "description.yaml").write_text(json.dumps(parameters))
    (folder / "started.yaml").write_text(controllers)
    given = ["--ros-args", "--params-file", "description.yaml"]
    remapped = ["-r", "/controller_manager/robot_description:=/robot_description"]
    commands = [
        ["ros2", "run", "robot_state_publisher", "robot_state_publisher", *given],
        [*_MANAGER, *given, "--params-file", "started.yaml", *remapped],
    ]
    log = (folder / "log").open("wb")
    started = [
        subprocess.Popen(words, cwd=folder, stdout=log, stderr=log, start_new_session=True) for words in commands
    ]
    try:
        spawner = ["ros2", "run", "controller_manager", "spawner", *spawned, "--controller-manager-timeout", "30"]
        subprocess.run(spawner, cwd=folder, stdout=log, stderr=log, check=False, timeout=2 * START)
        time.sleep(1)
        yield
    finally:
        for process in started:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        log.close()


def test_a_real_system_as_in_the_files_has_nothing_wrong(folder: Folder) -> None:
    with running(folder.path, FILES["controllers.yaml"], "joint_state_broadcaster", "head"):
        folder.write(SOURCES)
        ran = folder.run("doctor", "--snapshot", "now.json", environ=SOURCED)
    assert (ran.returncode, ran.stdout[:4]) == (0, "ok: "), ran.stdout + ran.stderr


def test_a_misspelt_joint_of_a_real_system_is_told_first(folder: Folder) -> None:
    wrong = FILES["controllers.yaml"].replace("[pan, tilt]", "[pan, tlit]")
    with running(folder.path, wrong, "joint_state_broadcaster", "head"):
        folder.write(SOURCES)
        ran = folder.run("doctor", environ=SOURCED)
    assert "UC834" in ran.stdout.splitlines()[0]
    assert "tlit" in ran.stdout.splitlines()[0]


def test_a_controller_that_nobody_spawned_in_a_real_system_is_told(folder: Folder) -> None:
    with running(folder.path, FILES["controllers.yaml"], "joint_state_broadcaster"):
        folder.write(SOURCES)
        ran = folder.run("doctor", environ=SOURCED)
    assert "UC830 controller 'head' is not loaded" in ran.stdout.splitlines()[0]


def test_the_real_manager_agrees_with_the_simulated_one(folder: Folder) -> None:
    folder.write(SOURCES)
    ran = folder.run("smoke", "launch/arm.launch.xml", "--engine", "ros2", "--format", "json", environ=SOURCED)
    [robot] = json.loads(ran.stdout)["robots"]
    passed = {one["controller"]: (one["passed"], one["differs"]) for one in robot["controllers"]}
    assert passed == {"joint_state_broadcaster": ("activate", False), "head": ("activate", False)}
