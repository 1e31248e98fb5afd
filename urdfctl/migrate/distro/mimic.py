"""Mimic joints: from parameters in <ros2_control> to <mimic> in the URDF."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import quoteattr

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import child
from urdfctl.migrate.edits.tokens import XML
from urdfctl.migrate.edits.xml_edits import elements_of, inserted, removed, words_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.xml.dom import Element

_AUTHORITY = "ros2_control doc/migration.rst of jazzy, #1256: mimic joints are those of the URDF, and are not commanded"
_PARAMETERS = ("mimic", "multiplier", "offset")


def _mimic(packages: MigratedPackages) -> Iterator[Proposal]:
    files = [
        path
        for path in packages.files(*XML)
        if packages.crosses("jazzy", path) and b"<joint" in packages.read(path).data
    ]
    joints = [element for path in files for element in elements_of(packages.read(path)) if element.tagName == "joint"]
    in_urdf: dict[str, list[Element]] = {}
    for joint in joints:
        if child(joint, "parent") is not None:
            in_urdf.setdefault(joint.attrs.get("name", ""), []).append(joint)
    mimics = _mimics(packages)
    for joint in joints:
        mimicked = _parameter(joint, "mimic")
        is_known = mimics.get((joint.source.path, joint.start), False)
        if mimicked is not None:
            yield _moved(joint, mimicked, in_urdf.get(joint.attrs.get("name", ""), []), is_known=is_known)
        elif is_known and _commands(joint) and joint.attrs.get("mimic") != "false":
            what = f"mimic joint '{joint.attrs.get('name', '')}' has no command interface"
            entry = ReportEntry(EntryKind.DONE, what, joint.at, authority=_AUTHORITY)
            yield Proposal(tuple(map(removed, _commands(joint))), entries=(entry,))


def _mimics(packages: MigratedPackages) -> dict[tuple[str, int], bool]:
    """Whether the URDF says of each joint of <ros2_control> that it mimics another, in all robots that have it."""
    found: dict[tuple[str, int], bool] = {}
    for loaded in packages.loaded():
        robot = loaded.project.robot
        for control in robot.ros2_controls if robot else ():
            for part in control.of_kind("joint"):
                joint = robot.joint(part.name) if robot and part.name else None
                key = part.at.source.path, part.at.start
                found[key] = found.get(key, True) and bool(joint and joint.mimic)
    return found


def _moved(joint: Element, mimicked: Element, in_urdf: list[Element], *, is_known: bool) -> Proposal:
    """The proposal for one joint of <ros2_control>.

    in_urdf: the joints in the URDF whose names are written in the same way.
    is_known: whether the URDF has the <mimic> already.
    """
    name = joint.attrs.get("name", "")
    edits = [removed(one) for key in _PARAMETERS if (one := _parameter(joint, key)) is not None]
    edits += map(removed, _commands(joint))
    without = [one for one in in_urdf if child(one, "mimic") is None]
    added = [edit for one in without if (edit := inserted(one, _element(joint, mimicked))) is not None]
    if is_known:
        added = []
    elif not in_urdf or len(added) < len(without):
        text = f"joint '{name}' mimics '{words_of(mimicked)}': move this to <mimic> of the joint in the URDF"
        return for_you(mimicked.at, text, authority=_AUTHORITY)
    what = f"joint '{name}' mimics '{words_of(mimicked)}' by <mimic> in the URDF, and has no command interface"
    return Proposal(
        _distinct([*edits, *added]), entries=(ReportEntry(EntryKind.DONE, what, joint.at, authority=_AUTHORITY),)
    )


def _commands(joint: Element) -> list[Element]:
    """The command interfaces of a joint, also those in conditions."""
    found, pending = [], joint.elements()
    while pending:
        element = pending.pop()
        pending += element.elements()
        found += [element] if element.tagName == "command_interface" else []
    return found


def _distinct(edits: list[Edit]) -> tuple[Edit, ...]:
    return tuple(dict.fromkeys(edits))


def _element(joint: Element, mimicked: Element) -> str:
    """The <mimic> element of the URDF, with the values as they are written."""
    attributes = f"joint={quoteattr(words_of(mimicked))}"
    for key in _PARAMETERS[1:]:
        value = _parameter(joint, key)
        if value is not None:
            attributes += f" {key}={quoteattr(words_of(value))}"
    return f"<mimic {attributes}/>"


def _parameter(joint: Element, name: str) -> Element | None:
    return next((one for one in joint.elements() if one.tagName == "param" and one.attrs.get("name") == name), None)


MIMIC = Step(
    name="mimic-joints",
    part=Part.URDF,
    summary="Mimic joints of <ros2_control>",
    propose=_mimic,
    rows=(Row('<ros2_control>: <param name="mimic">', "<mimic> in the URDF, no command", "jazzy", _AUTHORITY),),
    before=[
        {
            "arm.urdf": """
                <robot name="arm">
                  <link name="base"/>
                  <link name="upper"/>
                  <link name="fore"/>
                  <joint name="shoulder" type="continuous">
                    <parent link="base"/>
                    <child link="upper"/>
                  </joint>
                  <joint name="elbow" type="continuous">
                    <parent link="upper"/>
                    <child link="fore"/>
                  </joint>
                  <ros2_control name="arm" type="system">
                    <hardware>
                      <plugin>mock_components/GenericSystem</plugin>
                    </hardware>
                    <joint name="shoulder">
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                    <joint name="elbow">
                      <param name="mimic">shoulder</param>
                      <param name="multiplier">-1</param>
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                  </ros2_control>
                </robot>
            """,
        },
    ],
    after=[
        {
            "arm.urdf": """
                <robot name="arm">
                  <link name="base"/>
                  <link name="upper"/>
                  <link name="fore"/>
                  <joint name="shoulder" type="continuous">
                    <parent link="base"/>
                    <child link="upper"/>
                  </joint>
                  <joint name="elbow" type="continuous">
                    <parent link="upper"/>
                    <child link="fore"/>
                    <mimic joint="shoulder" multiplier="-1"/>
                  </joint>
                  <ros2_control name="arm" type="system">
                    <hardware>
                      <plugin>mock_components/GenericSystem</plugin>
                    </hardware>
                    <joint name="shoulder">
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                    <joint name="elbow">
                      <state_interface name="position"/>
                    </joint>
                  </ros2_control>
                </robot>
            """,
        },
    ],
)
