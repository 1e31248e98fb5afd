"""UC676."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch_samples import CONTROLLERS
from urdfctl.rules.moveit.samples import MOVEIT, SEMANTIC, built


def _files(semantic: str) -> dict[str, str]:
    return {
        "arm.urdf": "",
        "arm.launch": f"""
            <launch>
              <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
              <param name="robot_description_semantic" textfile="{semantic}"/>
            </launch>
        """,
        "config/arm.srdf": SEMANTIC,
        "package.xml": '<package format="2"><name>arm</name></package>',
    }


@rule(
    "UC676",
    severity=Severity.ERROR,
    runtime="refuses",
    authority='launch_param_builder utils.py raise_if_file_not_found(): "File .../config/kinematics.yaml doesn\'t exist"; '
    "moveit_configs_builder.py to_moveit_configs(): reads the SRDF, kinematics.yaml and joint_limits.yaml; "
    "trajectory_execution(): 'Unable to guess which parameter file to load'; roslaunch: 'Invalid "
    "<param> tag: No such file or directory'",
    bad=[
        _files("«$(find arm)/config/robot.srdf»"),
        built("«{}»", {"config/ros2_controllers.yaml": CONTROLLERS, "config/plan_controllers.yaml": MOVEIT}),
    ],
    good=[
        _files("$(find arm)/config/arm.srdf"),
        built("{}", {"config/ros2_controllers.yaml": CONTROLLERS, "config/moveit_controllers.yaml": MOVEIT}),
    ],
)
def moveit_file_missing(project: Project) -> Iterator[Finding]:
    """File of MoveIt's configuration does not exist.

    The launch stops. MoveItConfigsBuilder reads the SRDF that .setup_assistant names, or config/NAME.srdf, and
    config/kinematics.yaml and config/joint_limits.yaml, unless a call names other files. Of several files that end with
    _controllers.yaml it needs moveit_controllers.yaml.
    """
    files = project.moveit.files if project.moveit else None
    if files is None or not files.sure:
        return
    read = (("SRDF", files.semantic), ("kinematics file", files.kinematics), ("joint limits file", files.limits))
    for what, file in read:
        if file is not None and file.exists is False and file.path and (files.as_values or file is files.semantic):
            name = "/".join(file.path.replace("\\", "/").split("/")[-2:])
            yield Finding(file.at, f"{what} for MoveIt does not exist: '{name}'")
    if files.undecided:
        names = in_words(files.undecided, 3)
        message = f"MoveIt cannot choose among {names}: name its controllers 'moveit_controllers.yaml'"
        yield Finding(files.at, message)
