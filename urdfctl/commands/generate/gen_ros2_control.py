"""`urdfctl gen-ros2-control`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateRos2Control(GenerateOptions, command="gen-ros2-control"):
    """Write the <ros2_control> tag of ROS 2, as a xacro file to include.

    \b
    Example: urdfctl gen-ros2-control urdf/robot.xacro --joints 'elbow|wrist' --hardware mock --distro jazzy
    """


command = Command(GenerateRos2Control, run_generate)
