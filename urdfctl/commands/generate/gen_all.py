"""`urdfctl gen-all`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateAll(GenerateOptions, command="gen-all"):
    """Write a package with all of it: robot, controllers, launch file and dependencies.

    \b
    Example: urdfctl gen-all urdf/body.xacro --distro jazzy --simulator gz -o ../picker_control
    """


command = Command(GenerateAll, run_generate)
