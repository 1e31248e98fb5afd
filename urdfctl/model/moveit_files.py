"""The files that a launch file gives to MoveIt."""

from __future__ import annotations

from urdfctl.model.controllers import FileReference
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class MoveItFiles(NamedTuple):
    """The files that a launch file gives to MoveIt. None where it gives none, or an unknown one.

    at: the place in the launch file.
    semantic: the SRDF. arguments: the xacro arguments for it.
    kinematics: kinematics.yaml. limits: joint_limits.yaml.
    controllers: moveit_controllers.yaml, or in ROS 1 the files with a `controller_list`.
    pipelines: the names of planning pipelines, with their files.
    namespace: the namespace of the node that reads them; None if unknown.
    as_values: ROS 2: whether the launch file reads the YAML files and passes their content as values.
    runs: whether move_group is started with them.
    as_yaml: ROS 2: whether launch parses the text of the SRDF as YAML, because nothing says that it is a string.
    bare_kinematics: ROS 2: whether the groups in kinematics.yaml are passed without `robot_description_kinematics`.
    """

    at: Place
    semantic: FileReference | None = None
    arguments: tuple[tuple[str, str], ...] | None = ()
    kinematics: FileReference | None = None
    limits: FileReference | None = None
    controllers: tuple[FileReference, ...] = ()
    pipelines: tuple[tuple[str, FileReference], ...] = ()
    namespace: str | None = None
    sure: bool = True
    as_values: bool = False
    runs: bool = False
    as_yaml: bool = False
    bare_kinematics: bool = False
