"""`urdfctl gen-moveit`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateMoveIt(GenerateOptions, command="gen-moveit"):
    """Write a package that plans with MoveIt, and all that it needs: robot, controllers and launch files.

    \b
    Example: urdfctl gen-moveit urdf/body.xacro --distro jazzy -o ../picker_moveit
    """


command = Command(GenerateMoveIt, run_generate)
