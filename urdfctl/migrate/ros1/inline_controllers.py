"""Controllers that a launch file of ROS 1 declares itself: they move to a file, which ROS 2 needs for them.

A launch file of ROS 2 gives parameters to one node. The controllers in a `<rosparam>` are those of the manager, which
reads a file, and so does the plugin of a simulator.
"""

from __future__ import annotations

import os
import re
import textwrap
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import elements, end_of, written_in
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.roslaunch_values import around
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.gate import exists
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, read_yaml

_AUTHORITY = "wiki.ros.org/roslaunch/XML/rosparam; controller_manager.cpp: the types are parameters of the manager"


def _inline(packages: MigratedPackages) -> Iterator[Proposal]:
    for path, root in packages.found(launch_roots).items():
        folder = package_around(os.path.dirname(path))
        name = package_name(os.path.join(folder, "package.xml")) if folder else None
        if folder is None or name is None or not packages.may_change(path):
            continue
        taken: set[str] = set()
        for element in _declaring(root):
            file = _new_file(os.path.join(folder, "config"), path, taken)
            taken.add(file)
            yield _moved(element, file, f"$(find {name})/config/{os.path.basename(file)}")


def _declaring(root: Element) -> Iterator[Element]:
    """The <rosparam> elements of no node that contain the type of a controller."""
    for element in (one for one in elements(root) if one.tagName == "rosparam"):
        is_own = any(outer.tagName == "node" for outer in around(element))
        if not is_own and not {"file", "command"} & element.attrs.keys() and _has_controller(element):
            yield element


def _has_controller(element: Element) -> bool:
    text = textwrap.dedent(written_in(element))
    if "&" in text or "<" in text:  # it is written in another way in a file
        return False
    documents = read_yaml(SourceText("", text.encode("utf-8", "surrogateescape"))).documents
    return any(_declares(document, deepest=2) for document in documents)


def _declares(node: Node, *, deepest: int) -> bool:
    """Whether a map is a controller, or contains one below the names of namespaces."""
    if not isinstance(node, Mapping):
        return False
    kind = node.get("type")
    if isinstance(kind, Scalar) and re.fullmatch(r"\w+/\w*Controller\w*", kind.text):
        return True
    return deepest > 0 and any(_declares(entry.value, deepest=deepest - 1) for entry in node.entries)


def _new_file(folder: str, launch: str, taken: set[str]) -> str:
    stem = os.path.basename(launch).partition(".")[0]
    names = (f"{stem}_controllers{'' if number == 1 else f'_{number}'}.yaml" for number in range(1, 1000))
    paths = (os.path.join(folder, name) for name in names)
    return next(path for path in paths if path not in taken and not exists(path))


def _moved(element: Element, file: str, address: str) -> Proposal:
    tag = element.source.start_tag(element.start)
    start = tag.end if tag else element.start
    opened = element.source.data[element.start : start].decode("utf-8", "surrogateescape").removesuffix(">").rstrip()
    edit = Edit(
        SourceSpan(element.source, element.start, end_of(element)), f'{opened} command="load" file="{address}"/>'
    )
    text = "".join(f"{line.rstrip()}\n" for line in textwrap.dedent(written_in(element)).strip("\n").splitlines())
    what = f"the controllers in <rosparam> are in {os.path.basename(file)} now"
    entry = ReportEntry(EntryKind.DONE, what, element.at, authority=_AUTHORITY)
    return Proposal((edit,), created=((file, text.rstrip() + "\n"),), entries=(entry,))


INLINE_CONTROLLERS = Step(
    name="inline-controllers",
    part=Part.YAML,
    summary="Controllers in launch files",
    propose=_inline,
    generation=1,
    is_needed=True,
    rows=(Row("controllers in <rosparam> ... </rosparam>", "a file of parameters", "", _AUTHORITY),),
    before=[
        {
            "launch/arm.launch": """
                <launch>
                  <rosparam>
                    elbow_controller:
                      type: effort_controllers/JointEffortController
                      joint: elbow
                  </rosparam>
                  <node pkg="controller_manager" type="spawner" name="spawner" args="elbow_controller"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "config/arm_controllers.yaml": """
                elbow_controller:
                  type: effort_controllers/JointEffortController
                  joint: elbow
            """,
            "launch/arm.launch": """
                <launch>
                  <rosparam command="load" file="$(find arm)/config/arm_controllers.yaml"/>
                  <node pkg="controller_manager" type="spawner" name="spawner" args="elbow_controller"/>
                </launch>
            """,
        },
    ],
)
