"""The list of its joints that lies beside a robot."""

from __future__ import annotations

import os

from urdfctl.source.disk.files import Files
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import Place


def listed_joints_beside(path: str, files: Files) -> tuple[tuple[str, Place], ...]:
    """Return the joints that a ROS-Industrial support package lists: urdf/arm.xacro has config/joint_names_arm.yaml."""
    folder, name = os.path.split(path)
    file = os.path.join(os.path.dirname(folder), "config", f"joint_names_{name.partition('.')[0]}.yaml")
    if not is_file(file):
        return ()
    from urdfctl.load.controller_files import listed_joints

    return tuple(listed_joints(file, files))
