"""The switch between ROS 1 and ROS 2 in descriptions that are for both: a property or an argument like `is_ros2`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, elements, root_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan

_NAME = r"(?:(?:is|for|use|with)_)?ros_?([12])"
_BOOLS = {"false": "true", "true": "false", "False": "True", "True": "False", "0": "1", "1": "0"}
_DECLARING = {"xacro:property": "value", "xacro:arg": "default"}
_AUTHORITY = "the description has <ros2_control> for this case"


def _switches(packages: MigratedPackages) -> Iterator[Proposal]:
    sources = [packages.read(path) for path in packages.files(*OF_XML)]
    if not any(b"<ros2_control" in source.data for source in sources):
        return
    for source in sources:
        root = root_of(source) if source.is_xacro else None
        for element in elements(root) if root is not None else ():
            key = _DECLARING.get(element.tagName, "")
            name = re.fullmatch(_NAME, attribute(element, "name"), re.IGNORECASE) if key else None
            old = attribute(element, key) if name else ""
            tag = source.start_tag(element.start)
            if name is None or tag is None or old not in _BOOLS or _is_true(old) is (name[1] == "2"):
                continue
            message = f"switch '{name[0]}' is {_BOOLS[old]}: the descriptions are for ROS 2"
            edit = Edit(SourceSpan(source, *tag.attributes[key]), _BOOLS[old])
            yield Proposal((edit,), entries=(ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY),))


def _is_true(text: str) -> bool:
    return text in {"true", "True", "1"}


SWITCHES = Step(
    name="ros-switches",
    part=Part.URDF,
    summary="Switches of descriptions for both generations",
    propose=_switches,
    generation=1,
    rows=(Row("property or argument 'is_ros2' false", "true", "", _AUTHORITY),),
    before=[
        {
            "arm.xacro": """
                <xacro:property name="is_ros2" value="false"/>
                <xacro:if value="${is_ros2}">
                  <ros2_control name="arm" type="system">
                    <hardware>
                      <plugin>mock_components/GenericSystem</plugin>
                    </hardware>
                    <joint name="elbow">
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                  </ros2_control>
                </xacro:if>
            """,
        },
    ],
    after=[
        {
            "arm.xacro": """
                <xacro:property name="is_ros2" value="true"/>
                <xacro:if value="${is_ros2}">
                  <ros2_control name="arm" type="system">
                    <hardware>
                      <plugin>mock_components/GenericSystem</plugin>
                    </hardware>
                    <joint name="elbow">
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                  </ros2_control>
                </xacro:if>
            """,
        },
    ],
)
