"""The commands that build and start what a migration made, for a person who wants to see it run."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.output.change import Change
from urdfctl.source.disk.files import is_launch
from urdfctl.source.workspaces.packages import package_around, package_name

_STARTS = (b"gz_sim.launch.py", b"gazebo.launch.py", b"gzserver.launch.py", b"ros2_control_node")
"""What a launch file names that starts a simulator, or the manager of real hardware."""
_REQUIRED = re.compile(rb'DeclareLaunchArgument\("[\w-]+"\)|<arg name="[\w-]+"/>')
"""An argument that a person would have to give."""
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
        "rosdep install --from-paths src --ignore-src -r -y",
        f"colcon build --packages-up-to {' '.join(built)}",
        ". install/setup.bash",
        *started[:_MOST],
    )


def _starting(scratch: Scratch, folders: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield the launch files that start robots, each with the folder of its package: those that no other one includes
    and that need no argument, if there are any."""
    known = set(folders)
    launches: dict[str, tuple[str, bytes]] = {}
    for path in scratch.files():
        folder = package_around(os.path.dirname(path))
        if folder in known and folder and is_launch(path):
            launches[path] = folder, scratch.content(path)
    texts = b"\n".join(data for _, data in launches.values())
    starting = {
        path: data for path, (_, data) in launches.items() if _is_of_ros2(path, data) and _starts(data, launches)
    }
    whole = [
        path
        for path, data in starting.items()
        if not _REQUIRED.search(data) and f"/{os.path.basename(path)}".encode() not in texts
    ]
    for path in whole or starting:
        yield launches[path][0], os.path.basename(path)


def _is_of_ros2(path: str, data: bytes) -> bool:
    return path.endswith((".launch.xml", ".launch.yaml")) or b"generate_launch_description" in data


def _starts(data: bytes, launches: Mapping[str, tuple[str, bytes]], depth: int = 0) -> bool:
    """Whether a launch file starts a simulator or a manager, or includes one that does."""
    if any(mark in data for mark in _STARTS):
        return True
    included = (one for path, (_, one) in launches.items() if f"/{os.path.basename(path)}".encode() in data)
    return depth < _MOST and any(_starts(one, launches, depth + 1) for one in included)
