"""Generate MoveIt's configuration of a robot: what plans for it, beside the files that control it."""

from __future__ import annotations

import re
from collections.abc import Sequence

from urdfctl.catalog.distros import since
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.files.bringup import FORMS, launch_name, planning_launch_name
from urdfctl.generate.files.moveit import usable_by_moveit
from urdfctl.generate.files.planning_groups import planning_groups
from urdfctl.generate.files.semantic import SemanticPart, semantic_parts, semantic_text, with_own_parts
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.request.choice import chosen
from urdfctl.generate.request.planning_group import LinkTree, PlanningGroup
from urdfctl.generate.robot.anatomy import anatomy_of
from urdfctl.generate.robot.facts import JointFacts, Linkage, RobotFacts
from urdfctl.generate.robot.mounting import needs_world
from urdfctl.generate.text.templates import Templates

_RAMP = 2.0
"""The acceleration of a joint in parts of its greatest velocity, per second."""
_LISTED = 4
_TOLERATED = 0.1
"""How far outside of its limits a joint may start before jazzy: the start_state_max_bounds_error that is written."""
_NOWHERE = "from where MoveIt cannot plan"
_ELSEWHERE = "let it start elsewhere, by the initial_value of its joints in <ros2_control>"
_OF_FAKES = ("joint_state_publisher", "moveit_fake_controller_manager")
_LISTS_SINCE = "jazzy"
_YAML = ("ompl_planning", "pilz_industrial_motion_planner_planning", "pilz_cartesian_limits", "kinematics")


def moveit_dependencies(options: GeneratorOptions) -> list[str]:
    """Return the packages that are required to plan."""
    names = "moveit_kinematics moveit_planners_ompl moveit_ros_move_group moveit_ros_visualization "
    names += "moveit_simple_controller_manager pilz_industrial_motion_planner tf2_ros "
    if options.ros == 1:
        return [*names.split(), "rviz", *(() if options.simulated else _OF_FAKES)]
    stomp = ["moveit_planners_stomp"] if options.distro in since(_LISTS_SINCE) else []
    return [*names.split(), "moveit_configs_utils", "rviz2", *stomp]


def moveit_files(
    made: Sequence[GeneratedController],
    options: GeneratorOptions,
    templates: Templates,
    robot: RobotFacts,
    xml_command: str,
) -> tuple[list[File], list[str]]:
    """Return the files, and what of the SRDF that is there was kept, in words. UserError if MoveIt cannot plan.

    xml_command: the command for a comment in XML.
    """
    linkage = robot.linkage
    if linkage is None:
        raise UserError("MoveIt needs a whole robot: name one that can be expanded")
    _check(options)
    usable = [controller for controller, _ in usable_by_moveit(made)]
    if not usable:
        raise UserError("no controller of the robot is one that MoveIt uses: it needs --type trajectory or gripper")
    tools = anatomy_of(robot, chosen(robot)).tools
    solid = {name for one, other, _ in linkage.pairs for name in (one, other)}
    groups = planning_groups(usable, linkage.links, options.planning_groups, tools, solid=solid, bare=options.own)
    name, parts = robot.name or "robot", semantic_parts(robot, linkage, groups, in_world=needs_world(robot, options))
    semantic = f"config/{re.sub(r'[^A-Za-z0-9_.-]+', '_', name)}.srdf"
    notes: list[str] = []
    if options.output:
        parts, notes = with_own_parts(parts, f"{options.output}/{semantic}", robot)
    notes += _about_start(linkage, parts, 0.0 if options.distro in since(_LISTS_SINCE) else _TOLERATED)
    notes += _about_hulls(linkage.hulls)
    notes += _about_bare(groups, {joint.name for one in usable for joint in one.task.joints})
    values = _values(options, robot, groups, linkage, parts)
    values.update(semantic=semantic, robot=name)
    files = [File(semantic, semantic_text(name, xml_command, parts))]
    settings = [*_YAML, "joint_limits", *(["stomp_planning"] if values["lists"] else [])]
    settings += ["fake_controllers"] if options.ros == 1 and not options.simulated else []
    files += [File(f"config/{one}.yaml", templates.render(f"moveit/{one}.yaml", **values)) for one in settings]
    files.append(File("config/moveit.rviz", templates.render("moveit/moveit.rviz", **values)))
    launch = planning_launch_name(options)
    values["command"] = xml_command if options.ros == 1 else options.command
    files.append(File(f"launch/{launch}", templates.render(f"launch/{launch}", **values)))
    return files, notes


def _about_start(linkage: Linkage, parts: Sequence[SemanticPart], margin: float) -> list[str]:
    """Why MoveIt cannot plan from where the robot starts, in words. UserError if links touch there for sure."""
    rest = dict(linkage.rest)
    outside = [name for name, low, high in linkage.spans if not low - margin <= rest.get(name, low) <= high + margin]
    notes = [f"joint '{name}' starts outside of its soft limits, {_NOWHERE}: {_ELSEWHERE}" for name in outside]
    untested = {part.key for part in parts}
    for pair in linkage.starting:
        if ("disable_collisions", *sorted(pair)) not in untested:
            told = f"links '{pair[0]}' and '{pair[1]}' touch where the robot starts, {_NOWHERE}"
            if linkage.hulls:
                return [*notes, f"{told}, as far as their convex hulls tell"]
            raise UserError(f"{told}: {_ELSEWHERE}")
    return notes


def _about_bare(groups: Sequence[PlanningGroup], moved: set[str]) -> list[str]:
    """Which groups no controller moves, in words."""
    bare = [group.name for group in groups if group.joints and moved.isdisjoint(group.joints)]
    return [f"no controller of the robot moves group '{name}', which MoveIt can plan for and not move" for name in bare]


def _about_hulls(links: Sequence[str]) -> list[str]:
    """That meshes are tested as their convex hulls, in words."""
    if not links:
        return []
    named = ", ".join(links[:_LISTED]) + (", ..." if len(links) > _LISTED else "")
    install = "pip install 'urdfctl[moveit]' brings FCL, which tests the meshes"
    return [f"meshes are tested for collisions as their convex hulls, which touch more often ({named}): {install}"]


def _check(options: GeneratorOptions) -> None:
    if options.distro not in (*since("humble"), "noetic"):
        raise UserError(
            f"{options.distro} has not the MoveIt that is written for; use noetic, humble or a later distro"
        )
    if options.form not in FORMS:
        raise UserError(f"--form must be one of {', '.join(FORMS)}, not '{options.form}'")
    if options.namespace:
        raise UserError("MoveIt's configuration has no namespace; leave out --namespace")


def _values(
    options: GeneratorOptions,
    robot: RobotFacts,
    groups: Sequence[PlanningGroup],
    linkage: Linkage,
    parts: Sequence[SemanticPart],
) -> dict[str, object]:
    """What the templates use."""
    lists = options.distro in since(_LISTS_SINCE)
    virtual = [part for part in parts if part.tag == "virtual_joint" and part.get("type") == "fixed"]
    moved = {name for group in groups for name in group.joints}
    pipelines = ["ompl", "pilz_industrial_motion_planner", *(["stomp"] if lists else [])]
    return {
        "command": options.command,
        "chains": [group for group in groups if group.tip],
        "groups": [group for group in groups if group.joints],
        "joints": [_limits(joint) for joint in robot.joints if joint.name in moved],
        "ramp": _RAMP,
        "lists": lists,
        "first": groups[0].name,
        "root": "world" if needs_world(robot, options) else LinkTree(linkage.links).root,
        "virtual": bool(virtual),
        "package": options.package or "my_robot_control",
        "file": planning_launch_name(options),
        "ros": options.ros,
        "control": launch_name(options),
        "source": "PythonLaunchDescriptionSource" if options.form == "python" else "AnyLaunchDescriptionSource",
        "simulated": options.simulated,
        "simulator": options.simulator,
        "pipelines": "[" + ", ".join(f'"{one}"' for one in pipelines) + "]",
    }


def _limits(joint: JointFacts) -> dict[str, object]:
    velocity = abs(joint.velocity) if joint.velocity else None
    return {
        "name": joint.name,
        "velocity": repr(float(velocity)) if velocity else None,
        "acceleration": repr(round(_RAMP * (velocity or 1.0), 6)),
    }
