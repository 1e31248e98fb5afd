"""`urdfctl convert`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class ConvertRobot(GenerateOptions, command="convert"):
    """Convert a robot to MuJoCo's own format, with actuators, mimic joints and sensors; or to SDF, as gz does.

    \b
    Example: urdfctl convert urdf/robot.xacro --to mjcf -o robot.xml
    """


command = Command(ConvertRobot, run_generate)
