"""`urdfctl gen-controllers`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateControllers(GenerateOptions, command="gen-controllers"):
    """Write the controllers' YAML file.

    \b
    Example: urdfctl gen-controllers urdf/robot.xacro --type trajectory --joints 'elbow|wrist' --distro jazzy
    """


command = Command(GenerateControllers, run_generate)
