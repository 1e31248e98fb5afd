"""`urdfctl init`: a configuration that lint and smoke then use."""

from __future__ import annotations

from folder import Folder
from generating import command

ROBOT = """<robot name="r"><link name="a"/><link name="b"/>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>{}</robot>"""
GZ = '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>'
PACKAGE = "<package format='3'><name>p</name></package>"


def test_the_robots_of_a_folder_are_written(folder: Folder) -> None:
    folder.write({"p/package.xml": PACKAGE, "p/urdf/r.urdf": ROBOT.format(GZ), "p/urdf/s.urdf": ROBOT.format("")})
    ran = command("init", "--distro", "jazzy", "--simulator", "gz")
    assert ran.returncode == 0
    assert (folder.path / "urdfctl.toml").read_text() == (
        'distro = "jazzy"\nsimulator = "gz"\n\n[[robot]]\npath = "p/urdf/r.urdf"\n\n[[robot]]\npath = "p/urdf/s.urdf"\n'
    )
    assert "'.pre-commit-config.yaml' is not written; --pre-commit adds it" in ran.stderr
    lint = command("lint", "--show-settings").stdout
    assert "jazzy" in lint
    assert "urdfctl.toml" in lint


def test_what_is_detected_is_written_and_the_rest_left_open(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(GZ)})
    ran = command("init")
    text = (folder.path / "urdfctl.toml").read_text()
    assert text.startswith('# distro = "jazzy"\nsimulator = "gz"\n')
    assert "ROS distro is unknown; set it in 'urdfctl.toml', or use --distro" in ran.stderr


def test_the_hook_and_the_workflow_are_written_once(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format("")})
    words = ("init", "--distro", "jazzy", "--pre-commit", "--workflow")
    assert command(*words).returncode == 0
    assert "- id: urdfctl-lint" in (folder.path / ".pre-commit-config.yaml").read_text()
    assert "uses: OWNER/urdfctl@" in (folder.path / ".github/workflows/urdfctl.yaml").read_text()
    assert command(*words).stderr == "urdfctl: 'urdfctl.toml' exists; --force overwrites it\n"
    again = command(*words, "--force")
    assert "'.pre-commit-config.yaml' exists; add this to it if it is missing:" in again.stderr


def test_a_folder_without_robots_is_refused(folder: Folder) -> None:
    assert command("init").stderr == "urdfctl: no robot found in '.'\n"
    assert command("init", "none").stderr == "urdfctl: folder 'none' does not exist\n"
