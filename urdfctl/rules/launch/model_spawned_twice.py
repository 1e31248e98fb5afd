"""UC646."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from urdfctl.control.model_spawners import MODEL_SPAWNERS
from urdfctl.model.launch import Node, Word
from urdfctl.rule import Finding, Note, Project, Severity, rule


def _launched(package: str, program: str, *words: str) -> dict[str, str]:
    if program in ("spawn_model", "urdf_spawner"):
        nodes = (
            f'<node name="n{i}" pkg="{package}" type="{program}" args="-file arm.sdf {each}"/>'
            for i, each in enumerate(words)
        )
        name = "arm.launch"
    else:
        nodes = (
            f'<node name="n{i}" pkg="{package}" exec="{program}" args="-file arm.sdf {each}"/>'
            for i, each in enumerate(words)
        )
        name = "arm.launch.xml"
    manifest = f"<package><name>arm</name><exec_depend>{package}</exec_depend></package>"
    return {name: f"<launch>{''.join(nodes)}</launch>", "package.xml": manifest}


@rule(
    "UC646",
    runtime="refuses",
    because="the first model stays",
    severity=Severity.WARNING,
    authority="gazebo_plugins gazebo_ros_api_plugin.cpp: 'SpawnModel: Failure - model name arm already exist.'; "
    "gazebo_ros_factory.cpp: 'Entity [arm] already exists.'; gz-sim UserCommands.cc: 'Entity named [arm] already exists and "
    "[allow_renaming] is false. Entity not spawned.'",
    bad=[
        _launched(package, program, f"{option} arm -x 0", f"{option} «arm» -x 1")
        for (package, program), option in MODEL_SPAWNERS.items()
    ],
    good=[
        {**_launched("gazebo_ros", "spawn_model", "-model arm", "-model leg"), "run.sh": "gzserver\n"},
        {**_launched("ros_gz_sim", "create", "-name arm", "-name arm -allow_renaming true"), "run.sh": "gz sim -r\n"},
    ],
)
def model_spawned_twice(project: Project) -> Iterator[Finding]:
    """Two models of one name are spawned.

    The simulator refuses the second one, and which is first is chance: the robot may stand elsewhere, or be another
    one. Give each model its name, or spawn it once.
    """
    launch = project.launch
    first: dict[str, Word] = {}
    followed = {launch.path, *(one.file.path for one in launch.references if one.use == "include")} if launch else set()
    for node in launch.nodes if launch else ():
        name = _model_of(node)
        if name is None or name.known is None or name.at.source.path not in followed:
            continue
        if name.text in first:
            message = f"model '{name.text}' is spawned twice; the simulator refuses the second one"
            yield Finding(name.at, message, (Note("it is spawned here too", first[name.text].at),))
        first.setdefault(name.text, name)


def _model_of(node: Node) -> Word | None:
    """The name of the model that a node certainly spawns under exactly that name."""
    option = MODEL_SPAWNERS.get((node.package.text, node.executable.text))
    if option is None or not node.sure or any("allow_renaming" in word.text for word in node.words):
        return None
    return next((after for before, after in pairwise(node.words) if before.text == option), None)
