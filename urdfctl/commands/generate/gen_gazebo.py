"""`urdfctl gen-gazebo`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateGazebo(GenerateOptions, command="gen-gazebo"):
    """Write the simulator plugin that runs the controllers, as a xacro file to include.

    \b
    Example: urdfctl gen-gazebo --simulator gz --distro jazzy -o urdf/simulator.xacro
    """


command = Command(GenerateGazebo, run_generate)
