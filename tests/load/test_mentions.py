"""What other texts of a workspace say: scripts, READMEs, other launch files, and lists of repositories."""

from __future__ import annotations

from pathlib import Path

import pytest
from folder import Folder
from launched_packages import found

from urdfctl.load import mentions
from urdfctl.load.mentions import Mentions
from urdfctl.rules.launch_samples import ARM, BROADCASTER, CONTROLLERS, MANAGER, PUBLISHER, launched

REPOS = "repositories:\n  ros2_controllers: {type: git, url: https://github.com/%s/ros2_controllers}\n"


def said(folder: Path, expression: str, *read: str) -> bool | None:
    return Mentions().beside(str(folder), [str(folder / name) for name in read])(expression)


def test_a_text_that_was_read_does_not_count(tmp_path: Path) -> None:
    (tmp_path / "a.launch").write_text("<node type='spawner'/>")
    assert said(tmp_path, "spawner") is True
    assert said(tmp_path, "spawner", "a.launch") is False


@pytest.mark.parametrize(
    "name", ["package.xml", "CMakeLists.txt", "build/run.sh", "robot.urdf", "wheel.stl", ".mypy_cache/run.json"]
)
def test_what_starts_nothing_does_not_count(name: str, tmp_path: Path) -> None:
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_text("spawner")
    assert said(tmp_path, "spawner") is False


def test_a_workflow_counts(tmp_path: Path) -> None:
    (tmp_path / ".github/workflows").mkdir(parents=True)
    (tmp_path / ".github/workflows/simulate.yml").write_text("run: ros2 run controller_manager spawner arm")
    assert said(tmp_path, "spawner") is True


def test_no_more_texts_are_read_than_the_answer_needs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("a.py", "b.py", "c.py"):
        (tmp_path / name).write_text("spawner")
    read: list[str] = []
    monkeypatch.setattr(mentions, "start_of", lambda path, _: read.append(Path(path).name) or b"spawner")
    say = Mentions().beside(str(tmp_path), [str(tmp_path / "a.py")])
    assert (say("spawner"), say("spawner")) == (True, True)
    assert read == ["a.py", "b.py"]


def test_it_is_unknown_after_a_search_that_was_interrupted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(_path: str, _most: int) -> bytes:
        raise KeyboardInterrupt

    (tmp_path / "a.py").write_text("spawner")
    say = Mentions().beside(str(tmp_path), [])
    with monkeypatch.context() as patched:
        patched.setattr(mentions, "start_of", interrupted)
        with pytest.raises(KeyboardInterrupt):
            say("spawner")
    assert say("spawner") is None


def test_how_a_workspace_is_made_stands_in_lists_of_repositories_and_scripts_and_not_in_code(tmp_path: Path) -> None:
    say = Mentions().beside(str(tmp_path), [])
    (tmp_path / "driver.cpp").write_text("url: github.com/arms/ros2_controllers")
    assert (say("/ros2_controllers"), say("/ros2_controllers", of_builds=True)) == (True, False)
    (tmp_path / "Dockerfile").write_text("RUN git clone https://github.com/arms/ros2_controllers")
    assert Mentions().beside(str(tmp_path), [])("/ros2_controllers", of_builds=True) is True


@pytest.mark.parametrize(
    ("name", "is_said"),
    [
        ("Dockerfile", True),
        ("docker/Dockerfile", True),
        ("arm/scripts/install.sh", True),
        ("base/README.md", True),
        ("base/.github/workflows/test.yml", True),
        ("base/doc/notes.md", False),
    ],
)
def test_how_a_workspace_is_made_does_not_stand_deep_in_the_package_of_another_robot(
    name: str, is_said: bool, folder: Folder
) -> None:
    files = {"arm/package.xml": "<package/>", "base/package.xml": "<package/>", "arm/arm.urdf": "<robot/>"}
    folder.write({**files, name: "git clone https://github.com/arms/ros2_controllers"})
    say = Mentions().beside(str(folder.path), [str(folder.path / "arm/arm.urdf")])
    assert say("/ros2_controllers", of_builds=True) is is_said


def test_it_is_unknown_in_a_workspace_with_too_many_texts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mentions, "MOST_FILES", 2)
    for number in range(3):
        (tmp_path / f"{number}.py").write_text("")
    assert said(tmp_path, "spawner") is None


@pytest.mark.parametrize(("owner", "severity"), [("husarion", "info"), ("ros-controls", "warning")])
def test_a_parameter_may_be_read_by_a_fork_of_the_controllers(owner: str, severity: str, folder: Folder) -> None:
    controllers = CONTROLLERS.replace("joints: [", "own_parameter: true\n        joints: [")
    files = launched(PUBLISHER, MANAGER, BROADCASTER, ARM, controllers=controllers)
    [finding] = found(folder, {**files, "arm.repos": REPOS % owner}, "UC430", distro="jazzy")
    assert severity in str(finding)


_LAUNCH = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node

def chosen(context):
    if LaunchConfiguration("spawn").perform(context) == "true":
        BRANCH
    return []

def generate_launch_description():
    share = get_package_share_directory("arm")
    robot = {"robot_description": Command(["xacro ", share + "/arm.urdf"])}
    program = "spawner"
    states = Node(package="controller_manager", executable=program, arguments=["joint_state_broadcaster"]CONDITION)
    return LaunchDescription([
        DeclareLaunchArgument("spawn", default_value="false"),
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[robot]),
        Node(package="controller_manager", executable="ros2_control_node", parameters=[share + "/controllers.yaml"]),
        OpaqueFunction(function=chosen), ADDED])
"""


@pytest.mark.parametrize(
    ("branch", "condition", "added", "is_found"),
    [
        ("pass", "", "", True),
        (
            "return [Node(package='controller_manager', executable='spawner', arguments=['arm_controller'])]",
            "",
            "",
            False,
        ),
        ("pass", ", condition=IfCondition(LaunchConfiguration('spawn'))", "states", False),
    ],
    ids=["nowhere", "in a branch", "on a condition"],
)
def test_what_runs_only_with_other_arguments_counts(
    branch: str, condition: str, added: str, is_found: bool, folder: Folder
) -> None:
    launch = _LAUNCH.replace("BRANCH", branch).replace("CONDITION", condition).replace("ADDED", added)
    files = {name: text for name, text in launched().items() if name != "arm.launch.xml"}
    assert bool(found(folder, {"arm.launch.py": launch, **files}, "UC621", distro="jazzy")) is is_found
