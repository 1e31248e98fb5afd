"""Files that name the distro that a workspace is for."""

from __future__ import annotations

import json

from systems.render.places import pick
from systems.render.workspace import Workspace
from systems.system import System

_BESIDE = {"noetic": "melodic", "humble": "jazzy", "jazzy": "humble", "kilted": "jazzy"}
"""The distro that is named beside, where several are."""


def add_evidence(workspace: Workspace) -> None:
    """Add the file that names the distro, if the switch says so; otherwise the user names it, or nobody."""
    kind, system = workspace.idioms["evidence"], workspace.system
    workspace.is_distro_given = kind == "option"
    if kind == "nothing":
        workspace.distros = frozenset()
    elif kind == "several":
        workspace.distros = frozenset({system.distro, _BESIDE[system.distro]})
    writer = {
        "dockerfile": ("Dockerfile", _dockerfile),
        "workflow": (".github/workflows/ci.yaml", _workflow),
        "devcontainer": (".devcontainer/devcontainer.json", _devcontainer),
        "repos": (f"{workspace.robots[0].description.split('/')[0]}.repos", _repositories),
        "readme": ("README.md", _readme),
        "several": (".github/workflows/ci.yaml", _matrix),
    }.get(kind)
    if writer is not None:
        workspace.files[writer[0]] = writer[1](system)


def _dockerfile(system: System) -> str:
    distro = system.distro
    image = pick(system, "image", (f"ros:{distro}", f"osrf/ros:{distro}-desktop", f"ros:{distro}-ros-base"))
    head = f"FROM {image}\n"
    if pick(system, "image argument", (True, False, False)):
        head = f"ARG ROS_DISTRO={distro}\nFROM ros:${{ROS_DISTRO}}\n"
    return (
        f"{head}\nWORKDIR /ws\nCOPY . /ws/src\n"
        "RUN apt-get update && rosdep update && rosdep install -y --from-paths src --ignore-src\n"
    )


_CHECKOUT = "      - uses: actions/checkout@v4\n"
_JOB = "name: ci\non: [push]\njobs:\n  build:\n    runs-on: ubuntu-latest\n"


def _workflow(system: System) -> str:
    distro = system.distro
    steps = {
        "setup-ros": (
            f"      - uses: ros-tooling/setup-ros@v0.7\n        with:\n          required-ros-distributions: {distro}\n"
        ),
        "industrial_ci": (
            f"      - uses: ros-industrial/industrial_ci@master\n        env:\n          ROS_DISTRO: {distro}\n"
        ),
    }
    step = steps[pick(system, "workflow", ("setup-ros", "industrial_ci"))]
    return f"{_JOB}    steps:\n{_CHECKOUT}{step}"


def _matrix(system: System) -> str:
    distros = ", ".join(sorted((system.distro, _BESIDE[system.distro])))
    step = (
        "      - uses: ros-industrial/industrial_ci@master\n        env:\n          ROS_DISTRO: ${{ matrix.distro }}\n"
    )
    return f"{_JOB}    strategy:\n      matrix:\n        distro: [{distros}]\n    steps:\n{_CHECKOUT}{step}"


def _devcontainer(system: System) -> str:
    image = {"name": "workspace", "image": f"osrf/ros:{system.distro}-desktop"}
    return json.dumps(image, indent=2) + "\n"


def _repositories(system: System) -> str:
    """What is built beside the workspace, at the branches for the distro."""
    first = system.generation == 1
    branch = f"{system.distro}-devel" if first else system.distro
    names = ("ros_control", "ros_controllers") if first else ("ros2_control", "ros2_controllers")
    lines = [
        f"  {name}:\n    type: git\n    url: https://github.com/ros-controls/{name}.git\n    version: {branch}\n"
        for name in names
    ]
    return f"repositories:\n{''.join(lines)}"


def _readme(system: System) -> str:
    build = "catkin_make" if system.generation == 1 else "colcon build"
    return f"# Robots\n\n```\nsource /opt/ros/{system.distro}/setup.bash\n{build}\n```\n"
