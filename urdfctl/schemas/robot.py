"""XML Schemas (XSD 1.0) of robots: URDF as urdfdom reads it, and <ros2_control> as a distro's parser does.

Authorities: urdfdom's urdf_parser/src (model.cpp, link.cpp, joint.cpp, pose.cpp) and ros2_control's
hardware_interface/src/component_parser.cpp.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from urdfctl.catalog.distros import ROS2, since
from urdfctl.errors import UserError

_FOLDER = Path(__file__).parent
_BY_DISTRO = re.compile(r"\s*<!--(since|until) (\w+)-->(.*?)<!--end-->", re.DOTALL)
_URDF_IS_READ = since("jazzy")
"""From jazzy on, the parser of ros2_control reads the joints of the URDF too."""
_NAMESPACE = "http://www.w3.org/2001/XMLSchema"
_ROBOT = """\
<xs:element name="robot" type="Robot">
{keys}
</xs:element>
<xs:complexType name="Robot" mixed="true">
{content}
{attributes}
  <xs:anyAttribute processContents="skip"/>
</xs:complexType>
"""
_ATTRIBUTES = """\
  <xs:attribute name="name" type="xs:string" use="required"/>
  <xs:attribute name="version" type="Version"/>"""
_KEYS = """\
  <xs:key name="link"><xs:selector xpath="link"/><xs:field xpath="@name"/></xs:key>
  <xs:key name="joint"><xs:selector xpath="joint"/><xs:field xpath="@name"/></xs:key>
  <xs:keyref name="parentLink" refer="link"><xs:selector xpath="joint/parent"/><xs:field xpath="@link"/></xs:keyref>
  <xs:keyref name="childLink" refer="link"><xs:selector xpath="joint/child"/><xs:field xpath="@link"/></xs:keyref>
  <xs:unique name="oneParent"><xs:selector xpath="joint/child"/><xs:field xpath="@link"/></xs:unique>"""
_CONTROLLED = """\
  <xs:keyref name="mimickedJoint" refer="joint">
    <xs:selector xpath="joint/mimic"/><xs:field xpath="@joint"/>
  </xs:keyref>
  <xs:unique name="system"><xs:selector xpath="ros2_control"/><xs:field xpath="@name"/></xs:unique>
  <xs:keyref name="controlledJoint" refer="joint">
    <xs:selector xpath="ros2_control/joint | ros2_control/transmission/joint"/><xs:field xpath="@name"/>
  </xs:keyref>"""
_OPEN = """\
  <xs:sequence><xs:any minOccurs="0" maxOccurs="unbounded" processContents="lax"/></xs:sequence>"""
_WITH_CONTROL = """\
  <xs:sequence>
    <xs:group ref="Part" minOccurs="0" maxOccurs="unbounded"/>
    <xs:sequence maxOccurs="unbounded">
      <xs:element ref="ros2_control"/>
      <xs:group ref="Part" minOccurs="0" maxOccurs="unbounded"/>
    </xs:sequence>
  </xs:sequence>"""
_UNREAD = '<xs:element name="{}" type="Anything"/>\n'
_PARTS = ("link", "joint", "material", "gazebo", "transmission", "sensor")
_OF_TOOLS = ("mujoco", "mujoco_inputs", "loop_joint", "group", "group_state", "disable_collisions", "verbose")
"""Elements of other tools beside those of URDF: an element without a namespace has to be named to be allowed."""


@cache
def urdf_schema() -> str:
    """Return the XML Schema of URDF; unknown elements directly below <robot> are allowed."""
    robot = _ROBOT.format(keys=_KEYS, content=_OPEN, attributes=_ATTRIBUTES)
    others = "".join(_UNREAD.format(name) for name in ("ros2_control", *_OF_TOOLS))
    return _schema(robot, others, _read("common.xsd"), _read("urdf.xsd"))


@cache
def ros2_control_schema(distro: str) -> str:
    """Return the XML Schema of a robot with at least one <ros2_control>, as a distro's ros2_control reads it.

    Raises UserError if the distro is not one of ROS 2.
    """
    if distro not in ROS2:
        raise UserError(f"<ros2_control> needs a distro of ROS 2, not '{distro}': {', '.join(ROS2)}")
    if distro in _URDF_IS_READ:
        robot = _ROBOT.format(keys=f"{_KEYS}\n{_CONTROLLED}", content=_WITH_CONTROL, attributes=_ATTRIBUTES)
        urdf = _read("urdf.xsd")
    else:
        robot = _ROBOT.format(keys="", content=_WITH_CONTROL, attributes="")
        urdf = "".join(map(_UNREAD.format, ("link", "joint", "material")))
    control = _of_distro(_read("ros2_control.xsd"), distro)
    return _schema(robot, _group(), _read("common.xsd"), urdf, control)


def _group() -> str:
    parts = "\n".join(f'    <xs:element ref="{name}"/>' for name in _PARTS)
    of_tools = "\n".join(f'    <xs:element name="{name}" type="Anything"/>' for name in _OF_TOOLS)
    other = '    <xs:any namespace="##other" processContents="skip"/>'
    return f'<xs:group name="Part">\n  <xs:choice>\n{parts}\n{of_tools}\n{other}\n  </xs:choice>\n</xs:group>\n'


def _of_distro(text: str, distro: str) -> str:
    """The parts of a text that are for a distro: `<!--since jazzy-->...<!--end-->`."""

    def chosen(part: re.Match[str]) -> str:
        is_later = distro in since(part[2]) and distro != part[2]
        return part[3] if (distro in since(part[2]) if part[1] == "since" else not is_later) else ""

    return _BY_DISTRO.sub(chosen, text)


def _schema(*parts: str) -> str:
    body = "\n".join(part.rstrip() for part in parts)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<xs:schema xmlns:xs="{_NAMESPACE}">\n{body}\n</xs:schema>\n'


def _read(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8")
