"""Arguments of launch files in files of parameters, which roslaunch evaluates and ROS 2 does not: their values."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import Place, SourceSpan

_AUTHORITY = "wiki.ros.org/roslaunch/XML/rosparam: subst_value; ros2_control reads parameter files as they are"
_ARGUMENT = re.compile(rb"\$\(arg \w+\)")


def _arguments(packages: MigratedPackages) -> Iterator[Proposal]:
    for path, values in _values(packages).items():
        source = packages.read(path)
        for found in _ARGUMENT.finditer(source.data) if packages.may_change(path) else ():
            line = source.data.rfind(b"\n", 0, found.start()) + 1
            if source.data[line : found.start()].lstrip().startswith(b"#"):
                continue
            text = found[0].decode()
            at = Place(source, found.start(), end=found.end())
            known = values.get(text, set())
            if len(known) != 1:
                yield for_you(
                    at, f"write the value of {text}: launch files have several, or none", authority=_AUTHORITY
                )
                continue
            (value,) = known
            what = f"'{text}' became '{value}', its value by default: ROS 2 does not evaluate it in this file"
            entry = ReportEntry(EntryKind.DECIDED, what, at, authority=_AUTHORITY)
            yield Proposal((Edit(SourceSpan(source, *found.span()), value),), entries=(entry,))


def _values(packages: MigratedPackages) -> dict[str, dict[str, set[str]]]:
    """The values of the arguments in the files that are evaluated, by file and argument."""
    found: dict[str, dict[str, set[str]]] = {}
    launches = (loaded.project.launch for loaded in packages.loaded())
    for load in (load for launch in launches if launch is not None and launch.ros == 1 for load in launch.loads):
        if load.substituted and load.file.path and is_file(load.file.path):
            of_file = found.setdefault(os.path.realpath(load.file.path), {})
            for text, value in load.rewriting.texts:
                of_file.setdefault(text, set()).add(value)
    return found


FILE_ARGUMENTS = Step(
    name="arguments-in-parameter-files",
    part=Part.YAML,
    summary="Arguments of launch files in files of parameters",
    propose=_arguments,
    generation=1,
    is_needed=True,
    rows=(Row('<rosparam file subst_value="true">: $(arg NAME)', "the default of the argument", "", _AUTHORITY),),
    before=[
        {
            "arm.launch": """
                <launch>
                  <arg name="rate" default="50"/>
                  <rosparam file="$(find arm)/config/states.yaml" command="load" subst_value="true"/>
                </launch>
            """,
            "config/states.yaml": """
                joint_state_controller:
                  type: joint_state_controller/JointStateController
                  publish_rate: $(arg rate)
            """,
        },
    ],
    after=[
        {
            "config/states.yaml": """
                joint_state_controller:
                  type: joint_state_controller/JointStateController
                  publish_rate: 50
            """,
        },
    ],
)
