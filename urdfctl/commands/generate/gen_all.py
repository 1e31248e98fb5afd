"""`urdfctl gen-all`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateAll(GenerateOptions, command="gen-all"):
    """Write a package with all of it: robot, controllers, launch file and dependencies.

    \b
    Example: urdfctl gen-all robot.xacro --type effort --distro jazzy --simulator gz -o my_robot_control
    """


command = Command(GenerateAll, run_generate)
