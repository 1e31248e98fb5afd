"""`urdfctl gen-launch`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateLaunch(GenerateOptions, command="gen-launch"):
    """Write a launch file that starts the robot and its controllers.

    \b
    Example: urdfctl gen-launch urdf/robot.xacro --distro jazzy --simulator gz -o launch/arm.launch.py
    """


command = Command(GenerateLaunch, run_generate)
