"""Settings that mean nothing are refused in one line, with the nearest that does; little of the environment
passes on."""

from __future__ import annotations

import pytest
from folder import Folder

from urdfctl.catalog.distros import ALL
from urdfctl.config.settings import Settings, passed_on, validate_settings
from urdfctl.errors import UserError


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (Settings(distro="noetik"), "unknown distro 'noetik'; did you mean 'noetic'?"),
        (Settings(distro="Jazzy"), "unknown distro 'Jazzy'; did you mean 'jazzy'?"),
        (Settings(distro="xyz"), f"unknown distro 'xyz'; known are {', '.join(ALL)}"),
        (Settings(simulator="ode"), "unknown simulator 'ode'; known are gz, gazebo-classic, mujoco, none"),
        (
            Settings(simulator="mujoko"),
            "unknown simulator 'mujoko'; did you mean 'mujoco'?; known are gz, gazebo-classic, mujoco, none",
        ),
        (Settings(workspace="nowhere"), "folder 'nowhere' does not exist"),
        (Settings(package_paths=(".", "nowhere")), "folder 'nowhere' does not exist"),
        (Settings(timeout=0), "--timeout must be a number of seconds up to 86400, not 0"),
        (Settings(timeout=-1), "--timeout must be a number of seconds up to 86400, not -1"),
        (Settings(timeout=float("nan")), "--timeout must be a number of seconds up to 86400, not nan"),
        (Settings(timeout=float("inf")), "--timeout must be a number of seconds up to 86400, not inf"),
        (Settings(memory=0), "--memory must be a number of MiB up to 1048576, not 0"),
        (Settings(memory=-5 << 20), "--memory must be a number of MiB up to 1048576, not -5"),
        (Settings(memory=1 << 80), "--memory must be a number of MiB up to 1048576, not 1152921504606846976"),
    ],
)
def test_a_setting_that_means_nothing_is_refused(folder: Folder, settings: Settings, told: str) -> None:
    with pytest.raises(UserError) as refused:
        validate_settings(settings)
    assert str(refused.value) == told


@pytest.mark.parametrize(
    "settings",
    [
        Settings(),
        Settings(distro="noetic", simulator="gz", workspace=".", package_paths=(".",)),
        Settings(simulator="none", timeout=0.5, memory=1 << 20),
    ],
)
def test_settings_that_mean_something_pass(folder: Folder, settings: Settings) -> None:
    assert validate_settings(settings) is settings


def test_a_description_sees_what_tells_of_ros_and_what_the_user_names() -> None:
    environ = {
        "ROS_DISTRO": "noetic",
        "ROS_PACKAGE_PATH": "/a",
        "AMENT_PREFIX_PATH": "/b",
        "CMAKE_PREFIX_PATH": "/c",
        "HOME": "/home/me",
        "LANG": "C",
        "AWS_SECRET_ACCESS_KEY": "xyz",
        "PATH": "/bin",
        "ROBOT": "left",
    }
    assert set(passed_on(environ)) == {
        "ROS_DISTRO",
        "ROS_PACKAGE_PATH",
        "AMENT_PREFIX_PATH",
        "CMAKE_PREFIX_PATH",
        "HOME",
        "LANG",
    }
    assert set(passed_on(environ, ("ROBOT", "UNSET"))) - set(passed_on(environ)) == {"ROBOT"}


def test_settings_survive_the_way_to_a_worker_and_back() -> None:
    settings = Settings("noetic", "gz", ("a", "b"), ".", ("x",), {"HOME": "/"}, trust=True, timeout=3.5, memory=1 << 30)
    assert Settings.from_json(settings.to_json()) == settings
