"""UC670."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, applies_to, since, until
from urdfctl.model.moveit import Pipeline
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.moveit.samples import planned
from urdfctl.source.yaml.tree import Scalar, Sequence

_NEW = since("jazzy")
_OLD = tuple(distro for distro in until("iron") if distro in ROS2)
_OLD_PIPELINE = """
    planning_plugin: ompl_interface/OMPLPlanner
    request_adapters: >-
      default_planner_request_adapters/AddTimeOptimalParameterization
      default_planner_request_adapters/FixStartStateBounds
"""
_NEW_PIPELINE = """
    planning_plugins: [ompl_interface/OMPLPlanner]
    request_adapters: [default_planning_request_adapters/CheckStartStateBounds]
    response_adapters: [default_planning_response_adapters/AddTimeOptimalParameterization]
"""


@rule(
    "UC670",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    options=("--distro=jazzy",),
    authority="moveit2 planning_pipeline.cpp: since jazzy planning_plugins, request_adapters and response_adapters are lists: "
    "\"Planning plugin name is empty or not defined in namespace 'ompl'\"; until iron planning_plugin is a text, and "
    "request_adapters a text with names between spaces",
    bad=[
        planned(
            ompl_planning=_OLD_PIPELINE.replace("planning_plugin:", "«planning_plugin»:").replace(
                "request_adapters: >-", "«request_adapters»: >-"
            )
        ),
    ],
    good=[planned(ompl_planning=_NEW_PIPELINE)],
)
def pipeline_of_other_distro(project: Project) -> Iterator[Finding]:
    """Planning pipeline is written for another distro.

    jazzy renamed planning_plugin to planning_plugins, made it and the adapters lists, and replaced the adapters. In the
    other form, the pipeline cannot load a planner, or move_group ends because a parameter has the wrong type. A MoveIt
    that is built in the workspace may be of another release than that of the distro.
    """
    distros = set(project.distros)
    is_new, is_old = distros <= set(_NEW), distros <= set(_OLD)
    if not (is_new or is_old) or project.moveit is None or project.moveit.is_here:
        return
    for pipeline in project.moveit.pipelines:
        yield from _for_new(pipeline) if is_new else _for_old(pipeline)


def _for_new(pipeline: Pipeline) -> Iterator[Finding]:
    old = pipeline.setting("planning_plugin")
    if old and not pipeline.setting("planning_plugins"):
        message = f"pipeline '{pipeline.name}' has no planner: since jazzy the key is 'planning_plugins', with a list"
        yield Finding(old[0].at, message)
    for name in ("planning_plugins", "request_adapters", "response_adapters"):
        given = pipeline.setting(name)
        if given and isinstance(given[1], Scalar):
            example = given[1].text.split()[:1]
            message = f"'{name}' is a text, but must be a list since jazzy, e.g. {name}: {example}".replace("'", '"', 0)
            yield Finding(given[0].at, message)
        elif given and isinstance(given[1], Sequence):
            yield from _gone(given[1])


def _gone(adapters: Sequence) -> Iterator[Finding]:
    for item in adapters.items:
        if isinstance(item, Scalar) and item.text.startswith("default_planner_request_adapters/"):
            message = f"adapter '{item.text}' does not exist since jazzy; see default_planning_request_adapters"
            yield Finding(item.at, message)


def _for_old(pipeline: Pipeline) -> Iterator[Finding]:
    new = pipeline.setting("planning_plugins")
    if new and not pipeline.setting("planning_plugin"):
        message = f"pipeline '{pipeline.name}' uses 'planning_plugins', which {applies_to(_NEW)}; use 'planning_plugin'"
        yield Finding(new[0].at, message)
    adapters = pipeline.setting("request_adapters")
    if adapters and isinstance(adapters[1], Sequence):
        message = "'request_adapters' is a list, but must be one text with names between spaces until iron"
        yield Finding(adapters[0].at, message)
