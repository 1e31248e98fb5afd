"""Parameters of MoveIt for ROS 1 in the files that MoveIt 2 loads: controllers, planning pipelines, limits."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import elements, root_of
from urdfctl.migrate.edits.yaml_edits import MapEdits
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.left_over import renamed_parameters
from urdfctl.migrate.ros1.moveit_package import CONTROLLERS_FILE, is_of_moveit
from urdfctl.migrate.ros1.moveit_pipelines import CARTESIAN_LIMITS, PILZ_LIMITS
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.gate import exists
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Node, Scalar, YamlEntry, read_yaml
from urdfctl.source.yaml.tree import Sequence as List

_LIST = "controller_list"
_MANAGER = "moveit_simple_controller_manager"
_PIPELINE = "_planning_pipeline.launch.xml"
_OF_PIPELINES = ("planning_plugin", "request_adapters", "start_state_max_bounds_error")
_OF_EXECUTION = ("allowed_execution_duration_scaling", "allowed_goal_duration_margin", "allowed_start_tolerance")
_LIMITS = ("max_velocity", "max_acceleration", "max_jerk", "min_position", "max_position", "min_velocity")
_WHOLE_LIMIT = re.compile(r"(\bmax_(?:trans|rot)_(?:vel|acc|dec):[ \t]*[-+]?\d+)(?![\d.eE])")
_INTEGER = re.compile(r"[-+]?\d+")
_REFERENCE = re.compile(r"\$\(arg (\w+)\)")
_CONTROLLERS = "moveit2 moveit_simple_controller_manager: controller_names, and a map for each"
_BUILDER = "moveit2 moveit_configs_utils MoveItConfigsBuilder: config/PIPELINE_planning.yaml"
_PILZ = "moveit2#1422: MoveItConfigsBuilder.pilz_cartesian_limits() loads config/pilz_cartesian_limits.yaml"
_DOUBLES = "moveit2 robot_model_loader.cpp: limits of joints are doubles; rcl rejects integers"


def _maps(node: Node) -> Iterator[tuple[Map, YamlEntry]]:
    """The entries of all maps in a file, each with its map."""
    for entry in node.entries if isinstance(node, Map) else ():
        assert isinstance(node, Map)  # noqa: S101 (for the checker of types)
        yield node, entry
        yield from _maps(entry.value)


# -- controllers -------------------------------------------------------------------------------------------------------


def _controllers(packages: MigratedPackages) -> Iterator[Proposal]:
    by_folder: dict[str, list[SourceText]] = {}
    for path in packages.files(".yaml", ".yml"):
        source = packages.read(path)
        if _LIST.encode() in source.data and not os.path.basename(path).startswith("fake"):
            by_folder.setdefault(os.path.dirname(path), []).append(source)
    for folder, sources in by_folder.items():
        new = os.path.join(folder, CONTROLLERS_FILE)
        if not exists(new):
            yield from _controllers_of(packages, new, sources)


def _controllers_of(packages: MigratedPackages, new: str, sources: Sequence[SourceText]) -> Iterator[Proposal]:
    known: dict[str, Map] = {}
    edits: list[Edit] = []
    deleted: list[str] = []
    for source in sources:
        documents = read_yaml(source).documents
        found = [(parent, one) for root in documents for parent, one in _maps(root) if one.key.text == _LIST]
        items = [item for _, one in found if isinstance(one.value, List) for item in one.value.items]
        maps = [item for item in items if isinstance(item, Map) and isinstance(item.get("name"), Scalar)]
        if not found or len(maps) != len(items):
            continue
        for item in maps:
            name = item.get("name")
            known.setdefault(name.text if isinstance(name, Scalar) else "", item)
        is_all = all(len(root.entries) == 1 for root in documents if isinstance(root, Map))
        if is_all and found[0][0] in documents:
            deleted.append(source.path)
        else:
            edits += _without(source, found)
    if not known:
        return
    message = f"the controllers of MoveIt are in {CONTROLLERS_FILE}, in the form of MoveIt 2"
    entry = ReportEntry(EntryKind.DONE, message, file=new, authority=_CONTROLLERS)
    edits += renamed_parameters(packages, deleted, new)
    text = _controllers_text(known, _execution(packages, new))
    yield Proposal(tuple(edits), ((new, text),), tuple(deleted), (entry,))


def _without(source: SourceText, found: Sequence[tuple[Map, YamlEntry]]) -> tuple[Edit, ...]:
    edits = MapEdits(source)
    for parent, entry in found:
        edits.drop(((parent, entry),))
    return edits.edits()


def _controllers_text(known: Mapping[str, Map], execution: Mapping[str, str]) -> str:
    lines = [f"moveit_controller_manager: {_MANAGER}/MoveItSimpleControllerManager", ""]
    if execution:
        lines += ["trajectory_execution:", *(f"  {name}: {value}" for name, value in execution.items()), ""]
    lines += [f"{_MANAGER}:", "  controller_names:", *(f"    - {name}" for name in known)]
    for name, item in known.items():
        lines += ["", f"  {name}:"]
        for entry in item.entries:
            if entry.key.text == "name":
                continue
            if isinstance(entry.value, List):
                texts = [one.text for one in entry.value.items if isinstance(one, Scalar)]
                lines += [f"    {entry.key.text}:", *(f"      - {text}" for text in texts)]
            elif isinstance(entry.value, Scalar):
                lines.append(f"    {entry.key.text}: {entry.value.text}")
    return "\n".join(lines) + "\n"


def _execution(packages: MigratedPackages, new: str) -> dict[str, str]:
    """The parameters of the execution of trajectories in the launch files of a package."""
    folder = package_around(os.path.dirname(new)) or ""
    paths = (path for path in packages.files("trajectory_execution.launch.xml") if path.startswith(folder + os.sep))
    given = {name: value for path in paths for name, value in _parameters(packages.read(path)).items()}
    found = {
        name: given[f"trajectory_execution/{name}"] for name in _OF_EXECUTION if f"trajectory_execution/{name}" in given
    }
    return {name: _as_double(value) for name, value in found.items() if "$" not in value}


def _as_double(text: str) -> str:
    return f"{text}.0" if _INTEGER.fullmatch(text) else text


# -- planning pipelines ------------------------------------------------------------------------------------------------


def _parameters(source: SourceText) -> dict[str, str]:
    """The parameters that a launch file sets, with its own arguments put in."""
    root = root_of(source)
    found = list(elements(root)) if root is not None else []
    values = {
        one.attrs.get("name", ""): one.attrs.get("value", one.attrs.get("default", ""))
        for one in found
        if one.tagName == "arg"
    }
    given = {
        one.attrs.get("name", ""): one.attrs["value"]
        for one in found
        if one.tagName == "param" and "value" in one.attrs
    }
    return {name: _REFERENCE.sub(lambda ref: values.get(ref[1], ref[0]), text) for name, text in given.items()}


def _pipelines(packages: MigratedPackages) -> Iterator[Proposal]:
    for path in packages.files(_PIPELINE):
        pipeline = os.path.basename(path).removesuffix(_PIPELINE)
        folder = package_around(os.path.dirname(path))
        given = _parameters(packages.read(path)) if pipeline and folder and is_of_moveit(path) else {}
        wanted = {name: " ".join(given[name].split()) for name in _OF_PIPELINES if name in given}
        wanted = {name: text for name, text in wanted.items() if text and "$" not in text}
        if "planning_plugin" not in wanted or folder is None:
            continue
        target = os.path.join(folder, "config", f"{pipeline}_planning.yaml")
        source = packages.read(target)
        if b"planning_plugin" in source.data:
            continue
        what = f"the planning pipeline '{pipeline}' names its plugin and adapters in its file"
        entry = ReportEntry(EntryKind.DONE, what, file=target, authority=_BUILDER)
        text = "".join(_pipeline_lines(wanted))
        if exists(target):
            start = _first_key(source)
            yield Proposal((Edit(SourceSpan(source, start, start), text),), entries=(entry,))
        else:
            yield Proposal(created=((target, text),), entries=(entry,))


def _first_key(source: SourceText) -> int:
    """The offset of the line of the first key of a file; its end if there is none."""
    roots = [root for root in read_yaml(source).documents if isinstance(root, Map) and root.entries]
    return source.data.rfind(b"\n", 0, roots[0].entries[0].key.start) + 1 if roots else len(source.data)


def _pipeline_lines(wanted: Mapping[str, str]) -> Iterator[str]:
    for name, text in wanted.items():
        words = text.split()
        if name == "request_adapters":
            yield f"{name}: >-\n" + "".join(f"  {word}\n" for word in words)
        else:
            yield f"{name}: {_as_double(text) if name.endswith('error') else text}\n"


# -- limits ------------------------------------------------------------------------------------------------------------


def _limits(packages: MigratedPackages) -> Iterator[Proposal]:
    for path in packages.files("joint_limits.yaml"):
        source = packages.read(path)
        found = [
            entry.value
            for root in read_yaml(source).documents
            for _, entry in _maps(root)
            if entry.key.text in _LIMITS and isinstance(entry.value, Scalar) and _INTEGER.fullmatch(entry.value.text)
        ]
        if found and is_of_moveit(path):
            edits = tuple(
                Edit(SourceSpan(source, one.start, one.end), f"{one.text}.0")
                for one in found
                if isinstance(one, Scalar)
            )
            what = f"{len(edits)} limits of joints are written as doubles"
            yield Proposal(edits, entries=(ReportEntry(EntryKind.DONE, what, found[0].at, authority=_DOUBLES),))


def _of_pilz(packages: MigratedPackages) -> Iterator[Proposal]:
    for path in packages.files(f"/{CARTESIAN_LIMITS}"):
        new = os.path.join(os.path.dirname(path), PILZ_LIMITS)
        if is_of_moveit(path) and not exists(new):
            entry = ReportEntry(EntryKind.DONE, f"{CARTESIAN_LIMITS} became {PILZ_LIMITS}", file=new, authority=_PILZ)
            edits = tuple(renamed_parameters(packages, [path], new))
            text = _WHOLE_LIMIT.sub(r"\1.0", packages.read(path).data.decode("utf-8", "replace"))
            yield Proposal(edits, ((new, text),), (path,), (entry,))


def _moveit_files(packages: MigratedPackages) -> Iterator[Proposal]:
    yield from _controllers(packages)
    yield from _pipelines(packages)
    yield from _limits(packages)
    yield from _of_pilz(packages)


MOVEIT_FILES = Step(
    name="moveit-files",
    part=Part.MOVEIT,
    summary="Parameters of MoveIt",
    propose=_moveit_files,
    generation=1,
    is_needed=True,
    rows=(
        Row(
            "controller_list: [{name: N, ...}]",
            f"{CONTROLLERS_FILE}: controller_names: [N], N: {{...}}",
            "",
            _CONTROLLERS,
        ),
        Row("PIPELINE_planning_pipeline.launch.xml", "config/PIPELINE_planning.yaml", "", _BUILDER),
        Row("trajectory_execution.launch.xml", f"{CONTROLLERS_FILE}: trajectory_execution", "", _CONTROLLERS),
        Row("joint_limits: max_velocity: 1", "max_velocity: 1.0", "", _DOUBLES),
        Row(CARTESIAN_LIMITS, PILZ_LIMITS, "", _PILZ),
    ),
    before=[
        {
            "config/ros_controllers.yaml": """
                controller_list:
                  - name: arm_controller
                    action_ns: follow_joint_trajectory
                    type: FollowJointTrajectory
                    joints: [shoulder, elbow]
            """,
        },
    ],
    after=[
        {
            "config/moveit_controllers.yaml": """
                moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager

                moveit_simple_controller_manager:
                  controller_names:
                    - arm_controller

                  arm_controller:
                    action_ns: follow_joint_trajectory
                    type: FollowJointTrajectory
                    joints:
                      - shoulder
                      - elbow
            """,
            "config/ros_controllers.yaml": "",
        },
    ],
)
