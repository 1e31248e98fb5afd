"""The commands that build and start what a migration made, for a person who wants to see it run."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.output.change import Change
from urdfctl.source.disk.files import is_launch
from urdfctl.source.workspaces.packages import package_around, package_name

_STARTS = (b"gz_sim.launch.py", b"gazebo.launch.py", b"gzserver.launch.py", b"ros2_control_node")
"""What a launch file names that starts a simulator, or the manager of real hardware."""
_MOST = 3


def commands_for(scratch: Scratch, changes: Sequence[Change], target: str, base: str) -> tuple[str, ...]:
    """Return the commands that check the changed packages, build them, and start their robots; none without changes.

    base: the folder to which paths are relative.
    """
    folders = dict.fromkeys(
        folder for change in changes if (folder := package_around(os.path.dirname(scratch.of(change.file))))
    )
    names = {folder: package_name(os.path.join(folder, "package.xml")) for folder in sorted(folders)}
    built = [name for name in names.values() if name]
    if not built:
        return ()
    shown = " ".join(os.path.relpath(scratch.real(folder), base) for folder in names)
    started = [f"ros2 launch {names[folder]} {name}" for folder, name in _starting(scratch, names)]
    return (
        f"urdfctl lint {shown} --distro {target}",
        "# in the folder of the workspace:",
        f"colcon build --packages-up-to {' '.join(built)}",
        ". install/setup.bash",
        *started[:_MOST],
    )


def _starting(scratch: Scratch, folders: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield the launch files that start robots, each with the folder of its package."""
    known = set(folders)
    for path in scratch.files():
        folder = package_around(os.path.dirname(path))
        data = scratch.content(path) if folder in known and is_launch(path) else b""
        is_of_ros2 = path.endswith((".launch.xml", ".launch.yaml")) or b"generate_launch_description" in data
        if folder and is_of_ros2 and any(mark in data for mark in _STARTS):
            yield folder, os.path.basename(path)
