"""Files that name the distro that a workspace is for."""

from __future__ import annotations

import json

from systems.render.places import pick
from systems.render.workspace import Workspace


def add_evidence(workspace: Workspace) -> None:
    """Add the file that names the distro, if the switch says so; otherwise the user names it."""
    kind = workspace.idioms["evidence"]
    distro = workspace.system.distro
    workspace.is_distro_given = kind == "option"
    if kind == "dockerfile":
        workspace.files["Dockerfile"] = _dockerfile(workspace)
    elif kind == "workflow":
        workspace.files[".github/workflows/ci.yaml"] = _workflow(workspace)
    elif kind == "devcontainer":
        text = json.dumps({"name": "workspace", "image": f"osrf/ros:{distro}-desktop"}, indent=2)
        workspace.files[".devcontainer/devcontainer.json"] = text + "\n"


def _dockerfile(workspace: Workspace) -> str:
    distro = workspace.system.distro
    image = pick(workspace.system, "image", (f"ros:{distro}", f"osrf/ros:{distro}-desktop", f"ros:{distro}-ros-base"))
    return (
        f"FROM {image}\n\nWORKDIR /ws\nCOPY . /ws/src\n"
        "RUN apt-get update && rosdep update && rosdep install -y --from-paths src --ignore-src\n"
    )


def _workflow(workspace: Workspace) -> str:
    distro = workspace.system.distro
    head = "name: ci\non: [push]\njobs:\n  build:\n    runs-on: ubuntu-latest\n    steps:\n"
    head += "      - uses: actions/checkout@v4\n"
    steps = {
        "setup-ros": (
            f"      - uses: ros-tooling/setup-ros@v0.7\n        with:\n          required-ros-distributions: {distro}\n"
        ),
        "industrial_ci": (
            f"      - uses: ros-industrial/industrial_ci@master\n        env:\n          ROS_DISTRO: {distro}\n"
        ),
    }
    return head + steps[pick(workspace.system, "workflow", ("setup-ros", "industrial_ci"))]
