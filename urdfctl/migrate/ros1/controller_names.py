"""Controllers that have the name of a joint get a name of their own: in ROS 2 they would hide the joint."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, elements, root_of
from urdfctl.migrate.edits.yaml_edits import leaves
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_map import controller_maps
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Node, Scalar, Sequence, read_yaml

_AUTHORITY = (
    "ros2_control controller_manager/src/controller_manager.cpp: the name before the first slash of an interface "
    "is looked up among the controllers first"
)
_ARGUMENT = r"\$\(arg ([\w-]+)\)"
_OF_CONTROLLERS = "controller_list"
"""The list of controllers that MoveIt commands."""


def _names(packages: MigratedPackages) -> Iterator[Proposal]:
    """One change for all files: the name is in controller files, in launch files, and in those of MoveIt."""
    declared = [item for _, _, items in controller_maps(packages) for item in items if item.type and not item.is_file]
    joints = {*_joints_of_robots(packages), *_joints_of(item.entry.value for item in declared)}
    known = {item.name for item in declared}
    new = {name: _free(f"{name}_controller", known) for name in sorted(known & joints)}
    if not new:
        return
    entries = [
        ReportEntry(
            EntryKind.DECIDED,
            f"controller '{item.name}' became '{new[item.name]}': in ROS 2 it would hide the joint of this name",
            item.entry.key.at,
            authority=_AUTHORITY,
        )
        for item in declared
        if item.name in new
    ]
    edits = [Edit(_span(item.entry.key), new[item.name]) for item in declared if item.name in new]
    yield Proposal((*edits, *_in_lists(packages, new), *_in_launch_files(packages, new)), entries=tuple(entries))


def _joints_of_robots(packages: MigratedPackages) -> Iterator[str]:
    robots = (loaded.project.robot for loaded in packages.loaded())
    return (name for robot in robots if robot is not None for name in robot.joint_names)


def _joints_of(controllers: Iterable[Node]) -> Iterator[str]:
    """The joints that controllers name themselves."""
    for controller in controllers:
        for name, path in leaves(controller) if isinstance(controller, Map) else ():
            value = path[-1][1].value
            if name in {"joint", "joints"}:
                items = value.items if isinstance(value, Sequence) else (value,)
                yield from (item.text for item in items if isinstance(item, Scalar))


def _free(name: str, known: set[str]) -> str:
    return name if name not in known else _free(f"{name}_", known)


def _span(scalar: Scalar) -> SourceSpan:
    return SourceSpan(scalar.source, scalar.start, scalar.end)


def _in_lists(packages: MigratedPackages, new: Mapping[str, str]) -> Iterator[Edit]:
    """The edits of the lists of controllers for MoveIt."""
    for path in packages.files(".yaml", ".yml"):
        source = packages.read(path)
        documents = read_yaml(source).documents if _OF_CONTROLLERS.encode() in source.data else ()
        for root in documents:
            listed = root.get(_OF_CONTROLLERS) if isinstance(root, Map) else None
            maps = (item for item in listed.items if isinstance(item, Map)) if isinstance(listed, Sequence) else ()
            names = (one.get("name") for one in maps)
            yield from (Edit(_span(one), new[one.text]) for one in names if isinstance(one, Scalar) and one.text in new)


def _in_launch_files(packages: MigratedPackages, new: Mapping[str, str]) -> Iterator[Edit]:
    """The edits of what launch files start, and of the arguments with names for that."""
    roots = (root_of(packages.read(path)) for path in packages.files(".launch", ".xml"))
    found = [element for root in roots if root is not None for element in elements(root)]
    started = [element for element in found if attribute(element, "pkg") == "controller_manager"]
    arguments = {name for element in started for name in re.findall(_ARGUMENT, attribute(element, "args"))}
    for element in started:
        yield from _in_attribute(element, "args", new)
    for element in found:
        if element.tagName == "arg" and attribute(element, "name") in arguments:
            for name in ("default", "value"):
                yield from _in_attribute(element, name, new)


def _in_attribute(element: Element, name: str, new: Mapping[str, str]) -> Iterator[Edit]:
    old = attribute(element, name)
    words = "|".join(sorted(map(re.escape, new), key=len, reverse=True))
    text = re.sub(rf"(?<![\w$(.-])({words})(?![\w.:=-])", lambda match: new[match[1]], old)
    tag = element.source.start_tag(element.start)
    if text != old and tag is not None:
        yield Edit(SourceSpan(element.source, *tag.attributes[name]), text)


CONTROLLER_NAMES = Step(
    name="controller-names",
    part=Part.YAML,
    summary="Controllers with the name of a joint",
    propose=_names,
    rows=(Row("a controller NAME that is also a joint", "NAME_controller", "", _AUTHORITY),),
    generation=1,
    before=[
        {
            "robot.urdf": "",
            "config/controllers.yaml": """
                elbow:
                  type: effort_controllers/JointEffortController
                  joint: elbow
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                elbow_controller:
                  type: effort_controllers/JointEffortController
                  joint: elbow
            """,
        },
    ],
)
