"""Packages of MoveIt for ROS 1, and where they find the robot and its semantic description."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfctl.generate.text.scalars import python_text
from urdfctl.migrate.edits.markup import elements, root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.left_over import addressed_files
from urdfctl.migrate.ros1.moveit_pipelines import loaded_pipelines
from urdfctl.source.disk.gate import exists
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

MARK = ".setup_assistant"
MOVE_GROUP = "move_group.launch"
_CONTEXT = "planning_context.launch"
CONTROLLERS_FILE = "moveit_controllers.yaml"
_LOADED_BY = {"joint_limits.yaml": "joint_limits", "kinematics.yaml": "robot_description_kinematics"}
"""The methods of MoveItConfigsBuilder that load the files of a planning context."""
_ADDRESS = re.compile(r"\$\(find ([\w-]+)\)/([^\s'\"]+)")
_ARGUMENT = re.compile(r"\$\(arg (\w+)\)")
_GIVEN = re.compile(r"(\w+):='?([^\s']*)'?")


class MoveitPackage(NamedTuple):
    """A package of MoveIt with launch files for ROS 1.

    folder, name: of the package.
    robot: the robot's name, as the semantic description has it.
    calls: the calls that tell MoveItConfigsBuilder where the descriptions are, unless it finds them by itself, and
        which planning pipelines to load.
    needs_description: whether a person must say where the robot's description is.
    """

    folder: str
    name: str
    robot: str
    calls: tuple[str, ...] = ()
    needs_description: bool = False


def is_of_moveit(path: str) -> bool:
    """Return whether a file is in a package that MoveIt's Setup Assistant made."""
    folder = package_around(os.path.dirname(path))
    return folder is not None and is_moveit_folder(folder)


def is_moveit_folder(folder: str) -> bool:
    """Return whether a package is one of MoveIt's Setup Assistant, by its hidden file or its launch file."""
    names = (MARK, f"launch/{MOVE_GROUP}", f"launch/{MOVE_GROUP}.py")
    return any(exists(os.path.join(folder, name)) for name in names)


def moveit_packages(packages: MigratedPackages) -> Iterator[MoveitPackage]:
    """Yield the packages of MoveIt whose semantic description is known."""
    for manifest in packages.files("package.xml"):
        folder, name = os.path.dirname(manifest), package_name(manifest)
        if not name or not is_moveit_folder(folder):
            continue
        own = [path for path in packages.files(".srdf") if path.startswith(os.path.join(folder, "config") + os.sep)]
        context = root_of(packages.read(os.path.join(folder, "launch", _CONTEXT)))
        if exists(os.path.join(folder, MARK)) and len(own) == 1:
            yield _with_pipelines(packages, MoveitPackage(folder, name, _robot(packages, own[0])))
        elif context is not None and (found := _from_context(packages, folder, name, context)) is not None:
            yield _with_pipelines(packages, found)


def _with_pipelines(packages: MigratedPackages, found: MoveitPackage) -> MoveitPackage:
    """A package with the call that names its planning pipelines."""
    names = ", ".join(python_text(name) for name in loaded_pipelines(packages, found.folder))
    return found._replace(calls=(*found.calls, f"planning_pipelines(pipelines=[{names}])"))


def _robot(packages: MigratedPackages, path: str) -> str:
    root = root_of(packages.read(path))
    return root.attrs.get("name", "") if root is not None else ""


def _from_context(packages: MigratedPackages, folder: str, name: str, context: Element) -> MoveitPackage | None:
    """The package with the descriptions that its planning context loads; None if it names no semantic description."""
    defaults = _defaults(context)
    params = {_filled(one.attrs.get("name", ""), defaults): one for one in _chosen(context, defaults)}
    semantic = next((one for key, one in params.items() if key.endswith("_semantic")), None)
    robot = next((one for key, one in params.items() if key.endswith("robot_description")), None)
    written = _filled(_source(semantic), defaults) if semantic is not None else ""
    of_semantic = _ADDRESS.search(written)
    if of_semantic is None:
        return None
    calls = [f"robot_description_semantic(file_path={_shown(of_semantic, name)})"]
    of_robot = _ADDRESS.search(_without_xacro(_filled(_source(robot), defaults))) if robot is not None else None
    has_mark = exists(os.path.join(folder, MARK))
    if of_robot is not None and not has_mark:
        given = dict(_GIVEN.findall(_filled(_source(robot), defaults))) if robot is not None else {}
        more = f", mappings={_dict(given)}" if given else ""
        calls.insert(0, f"robot_description(file_path={_shown(of_robot, name)}{more})")
    calls += _elsewhere(packages, folder, name, context, defaults)
    files = addressed_files(packages, of_semantic[0])
    title = next((_robot(packages, path) for path in files), "") or name.removesuffix("_moveit_config")
    return MoveitPackage(folder, name, title, tuple(calls), needs_description=of_robot is None and not has_mark)


def _elsewhere(
    packages: MigratedPackages, folder: str, name: str, context: Element, defaults: Mapping[str, str]
) -> Iterator[str]:
    """Yield the calls for files that MoveItConfigsBuilder does not find by itself: it looks directly in config/."""
    for one in elements(context):
        address = _ADDRESS.search(_filled(one.attrs.get("file", ""), defaults)) if one.tagName == "rosparam" else None
        call = _LOADED_BY.get(os.path.basename(address[2])) if address is not None else None
        if address is not None and call and "$" not in address[2] and os.path.dirname(address[2]) != "config":
            yield f"{call}(file_path={_shown(address, name)})"
    config = os.path.join(folder, "config")
    lists = [path for path in packages.files(f"/{CONTROLLERS_FILE}") if path.startswith(config + os.sep)]
    if len(lists) == 1 and os.path.dirname(lists[0]) != config:
        yield f"trajectory_execution(file_path={python_text(os.path.relpath(lists[0], folder).replace(os.sep, '/'))})"


def _defaults(context: Element) -> dict[str, str]:
    found: dict[str, str] = {}
    for one in context.elements():
        if one.tagName == "arg":
            found[one.attrs.get("name", "")] = _filled(one.attrs.get("value", one.attrs.get("default", "")), found)
    return found


def _filled(text: str, defaults: Mapping[str, str]) -> str:
    """A text with the values of its arguments."""
    return _ARGUMENT.sub(lambda found: defaults.get(found[1], found[0]), text)


def _chosen(context: Element, defaults: Mapping[str, str]) -> Iterator[Element]:
    """Yield the parameters that are set by default; the description of the robot, whether it is or not."""
    for one in elements(context):
        conditions = [(name, _filled(one.attrs[name], defaults)) for name in ("if", "unless") if name in one.attrs]
        is_set = all((value.lower() in ("true", "1")) == (name == "if") for name, value in conditions)
        is_semantic = one.attrs.get("name", "").endswith("_semantic")
        if one.tagName == "param" and _source(one) and (is_set or not is_semantic):
            yield one


def _source(param: Element | None) -> str:
    return param.attrs.get("command", param.attrs.get("textfile", "")) if param is not None else ""


def _without_xacro(command: str) -> str:
    """A command without the address of xacro's program."""
    return re.sub(r"\$\(find xacro\)/\S+", "", command)


def _shown(address: re.Match[str], own: str) -> str:
    """The file of an address as a Python expression, relative to the package of MoveIt if it is in it."""
    package, path = address.groups()
    if package == own:
        return python_text(path)
    return f"get_package_share_directory({python_text(package)}) + {python_text(f'/{path}')}"


def _dict(given: Mapping[str, str]) -> str:
    return "{" + ", ".join(f"{python_text(name)}: {python_text(value)}" for name, value in given.items()) + "}"
