"""A workspace: descriptions, parameters, launch files and packages."""

from __future__ import annotations

from systems.possible import Idioms
from systems.render.actions import LaunchFile, ParamFile, packages_in, parts_of
from systems.render.around import add_around, add_reduced
from systems.render.description import FILE_ARGUMENTS, descriptions, xacro_arguments
from systems.render.distractors import add_examples
from systems.render.documents import add_documents
from systems.render.launch import frontends, python, roslaunch
from systems.render.launch.python_descriptions import FUNCTION, MODULE, helper
from systems.render.launch.ros2_spawners import LISTED
from systems.render.packages import package_files, runtime_packages
from systems.render.parameters import dumped, parameter_files
from systems.render.places import (
    Places,
    config_folder,
    is_text,
    parameter_names,
    places_of,
    roles_of,
    source_name,
    starts_of,
)
from systems.render.plan import Plan, file_name, planned
from systems.render.planner import PARAMETERS, planner_files
from systems.render.workspace import ExpectedRobot, Workspace
from systems.system import Robot, System


def assembled(system: System, idioms: Idioms) -> Workspace:
    """Return the workspace of a system, without what lies beside it."""
    places = places_of(system, idioms)
    plan = planned(system, idioms, places)
    add_around(plan)
    add_reduced(plan)
    workspace = Workspace(system, idioms)
    workspace.files |= descriptions(system, idioms, places)
    for robot in system.robots:
        names = parameter_names(system, idioms, robot)
        folder = f"{places.control}/{config_folder(system)}"
        texts = parameter_files(system, idioms, robot, names)
        for path, text in ((f"{folder}/{name}", text) for name, text in texts.items()):
            workspace.files[path] = workspace.files.get(path, "") + text
        workspace.robots.append(expected(system, idioms, places, robot))
    workspace.files |= launch_texts(plan)
    workspace.starts = [path_of(plan, file) for file in plan.starts]
    workspace.included = [path_of(plan, file) for file in plan.files if file not in plan.starts]
    workspace.is_simulator_known = (
        not system.is_simulated or starts_of(system, idioms)[0][1][:2] == roles_of(system)[:2]
    )
    if idioms["planner"] != "none":
        workspace.files |= planner_files(system, places)
    if idioms["spawners"] == "listed in a file":
        listed = [spawn.name for spawn in system.robots[0].spawned if spawn.active]
        path = f"{places.control}/{config_folder(system)}/{LISTED}"
        workspace.files[path] = dumped({"controllers": listed})
    workspace.is_fault_visible = idioms["parameters"] != "written"
    _add_module(plan, workspace)
    add_documents(workspace, plan)
    if plan.needs_examples:
        add_examples(workspace, places)
    add_packages(workspace, plan)
    return workspace


def path_of(plan: Plan, file: LaunchFile) -> str:
    """Return the path of a launch file in the workspace."""
    return f"{file.package}/launch/{file_name(plan, file)}"


def launch_texts(plan: Plan) -> dict[str, str]:
    """Return the launch files of a plan, by their paths in the workspace."""

    def name_of(package: str, stem: str) -> str:
        return next(file_name(plan, file) for file in plan.files if (file.package, file.stem) == (package, stem))

    texts = {}
    for file in plan.files:
        if file.language == "python":
            text = python.written(file, plan.system, plan.idioms, name_of)
        elif file.language == "launch":
            text = roslaunch.written(file, plan.system, name_of)
        else:
            text = frontends.written(file, plan.system.distro, name_of)
        texts[path_of(plan, file)] = text
    return texts


def expected(system: System, idioms: Idioms, places: Places, robot: Robot) -> ExpectedRobot:
    """Return what the resolver has to know of a robot."""
    folder = f"{places.control}/{config_folder(system)}"
    arguments = xacro_arguments(system, idioms, robot)
    is_elsewhere = system.generation == 1 and robot.asked != robot.manager  # asked is a namespace
    spawned = () if is_elsewhere else robot.spawned
    is_written = idioms["parameters"] == "written"  # by the launch file, from a template
    files = frozenset(f"{folder}/{name}" for name in parameter_names(system, idioms, robot))
    return ExpectedRobot(
        description=f"{places.description}/urdf/{source_name(system, idioms, robot)}",
        arguments=tuple((name, value) for name, value in arguments.items() if name not in FILE_ARGUMENTS),
        namespace=robot.namespace,
        parameters=frozenset() if is_written else files,
        spawned=frozenset(f"{robot.namespace}/{spawn.name}".strip("/") for spawn in spawned),
        extra=files | {f"{folder}/{PARAMETERS}"},
    )


def _add_module(plan: Plan, workspace: Workspace) -> None:
    """The helper that makes descriptions, in each package whose launch files import it."""
    for path, text in list(workspace.files.items()):
        package = path.split("/")[0]
        if f"from {package}.{MODULE} import {FUNCTION}" in text:
            is_plain = is_text(plan.idioms)
            imports = "" if is_plain else "import xacro\n\n\n"
            module = f'"""Descriptions for launch files."""\n\n{imports}{helper(is_plain=is_plain)}'
            workspace.files[f"{package}/{package}/{MODULE}.py"] = module


def add_packages(workspace: Workspace, plan: Plan) -> None:
    """Add the manifests of all packages of a plan, with what they use."""
    system = workspace.system
    for package in plan.places.packages:
        paths = [path.partition("/")[2] for path in workspace.files if path.startswith(f"{package}/")]
        launched = tuple(file.actions for file in plan.files if file.package == package)
        declared = tuple(file.declared for file in plan.files if file.package == package)
        depends = (
            packages_in((launched, declared))
            | set(runtime_packages(system))
            | ({"launch", "launch_ros"} if system.generation == 2 else set())
        )
        depends |= {name for name in plan.places.packages if f"$(find {name})" in _texts(workspace, package)}
        if any(isinstance(part, ParamFile) and part.rewritten for part in parts_of(launched)):
            depends.add("nav2_common")
        own = package_files(system, package, paths, depends, build=plan.idioms["build"])
        if plan.idioms["source"] == "built" and package == plan.places.description:
            own["CMakeLists.txt"] = _building(plan, own["CMakeLists.txt"])
        workspace.files |= {f"{package}/{name}": text for name, text in own.items()}


def _building(plan: Plan, text: str) -> str:
    """The build file, which makes descriptions from xacro files."""
    names = dict.fromkeys(source_name(plan.system, plan.idioms, robot) for robot in plan.system.robots)
    files = " ".join(f"urdf/{name}" for name in names)
    line = f"xacro_add_files({files} TARGET descriptions INSTALL DESTINATION urdf)\n"
    if plan.system.generation == 1:
        text = text.replace("find_package(catkin REQUIRED)", "find_package(catkin REQUIRED COMPONENTS xacro)")
        return text + line
    return text.replace("ament_package()", f"find_package(xacro REQUIRED)\n{line}ament_package()")


def _texts(workspace: Workspace, package: str) -> str:
    return "".join(text for path, text in workspace.files.items() if path.startswith(f"{package}/"))
