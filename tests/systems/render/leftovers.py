"""What people leave beside a system's own files: parts that nothing includes, results of tools, backups."""

from __future__ import annotations

from textwrap import indent

from systems.render.description import XACRO
from systems.render.parameters import dumped
from systems.render.places import Places, config_folder, pick
from systems.render.workspace import Workspace
from systems.system import System

Files = dict[str, str]


def parts(system: System, places: Places) -> Files:
    """A macro that no description calls, with parameters for it, and a piece of a description without its links."""
    name = pick(system, "part", ("gripper", "camera_mount", "tool"))
    joint = f"${{prefix}}{name}_joint"
    macro = (
        f'<joint name="{joint}" type="prismatic">\n  <parent link="${{parent}}"/>\n'
        f'  <child link="${{prefix}}{name}"/>\n'
        f'  <limit lower="0" upper="0.1" effort="10" velocity="1"/>\n</joint>\n<link name="${{prefix}}{name}"/>\n'
    )
    head = f'<xacro:macro name="{name}" params="prefix parent">\n{indent(macro, "  ")}</xacro:macro>\n'
    described = f'<?xml version="1.0"?>\n<robot {XACRO}>\n{indent(head, "  ")}</robot>\n'
    parameters = {"joints": [f"{name}_joint"]}
    own = parameters if system.generation == 1 else {"ros__parameters": parameters}
    return {
        f"{places.description}/urdf/parts/{name}.xacro": described,
        f"{places.control}/{config_folder(system)}/parts/{name}.yaml": dumped({f"{name}_controller": own}),
    }


def calibration(system: System, places: Places) -> Files:
    """What a calibration wrote: offsets of joints, and the description as text."""
    robot = system.robots[0]
    offsets = {f"{robot.prefix}{joint.name}": 0.01 for joint in robot.joints}
    link = '<link name="base_link"/>\n  <link name="camera"/>\n'
    joint = '<joint name="camera_joint" type="fixed">\n    <parent link="base_link"/>\n    <child link="camera"/>\n'
    text = f'<robot name="{robot.model}_calibrated">\n  {link}  {joint}  </joint>\n</robot>\n'
    folder = f"{places.control}/{pick(system, 'calibration', ('calibration', 'results', 'output'))}"
    return {
        f"{folder}/joint_offsets.yaml": dumped({"joint_offsets": offsets}),
        f"{folder}/kinematics.yaml": dumped({"kinematics": {"shoulder": {"x": 0.0, "y": 0.0, "z": 0.1625}}}),
        f"{folder}/{robot.model}_calibrated.urdf": text,
    }


def backups(workspace: Workspace) -> Files:
    """Copies of files as they were, with endings that nothing reads."""
    system = workspace.system
    end = pick(system, "backup", (".bak", ".orig", "~", ".old"))
    robot = workspace.robots[0]
    copied = [*workspace.starts[:1], robot.description, *sorted(robot.parameters)]
    before = system.robots[0].joints[0].name
    return {f"{path}{end}": workspace.files[path].replace(before, f"{before}_v0") for path in copied}
