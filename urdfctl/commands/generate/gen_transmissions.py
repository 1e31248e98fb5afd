"""`urdfctl gen-transmissions`."""

from __future__ import annotations

from urdfctl.commands.declaring import Command
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import run_generate


class GenerateTransmissions(GenerateOptions, command="gen-transmissions"):
    """Write the ROS 1 transmissions, as a xacro file to include.

    \b
    Example: urdfctl gen-transmissions urdf/body.xacro --interface effort --macro --distro noetic
    """


command = Command(GenerateTransmissions, run_generate)
