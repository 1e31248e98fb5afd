"""The gains by which Gazebo Classic itself moved joints in ROS 1: parameters of the joints in `<ros2_control>`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.distros import between
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, child, children, indent_of, lines_of
from urdfctl.migrate.edits.places import written_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_map import GAINS_OF_GAZEBO
from urdfctl.migrate.shared.hardware import simulated_by
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Scalar, read_yaml

_AUTHORITY = "gazebo_ros2_control doc/index.rst: PID control joints; control_toolbox (ROS 1) Pid::initParam()"
_PREFIXES = {"position": "pos", "velocity": "vel"}
_OF_XML = (".xacro", ".urdf", ".gazebo", ".inc")


def reads_gains(packages: MigratedPackages) -> bool:
    """Return whether the simulator of the migrated robot has a PID loop for each joint, as in ROS 1."""
    is_classic = simulated_by(packages) == "gazebo-classic"
    return is_classic and packages.options.target in between("humble", "iron")


def _gains(packages: MigratedPackages) -> Iterator[Proposal]:
    gains = _by_joint(packages) if packages.is_ros1 and reads_gains(packages) else {}
    found: set[str] = set()
    joints = list(_joints(packages)) if gains else []
    for joint in joints:
        name = attribute(joint, "name")
        given = gains.get(name)
        command = next(
            (one for one in children(joint, "command_interface") if attribute(one, "name") in _PREFIXES), None
        )
        found.add(name)
        if given is not None and command is not None:
            yield _with_gains(joint, command, given[0])
    for name, (_, at) in gains.items():
        if name not in found:
            text = f"joint '{name}' has gains in Gazebo: write pos_kp, pos_ki, pos_kd in its <joint> of <ros2_control>"
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, text, at, authority=_AUTHORITY),))


def _joints(packages: MigratedPackages) -> Iterator[Element]:
    """Yield the joints of `<ros2_control>`, also those in macros."""
    for element in written_elements(packages, "<command_interface", _OF_XML):
        is_driven = element.tagName == "joint" and child(element, "command_interface") is not None
        if is_driven and packages.may_change(element.source.path):
            yield element


def _by_joint(packages: MigratedPackages) -> dict[str, tuple[Mapping[str, str], Place]]:
    """The gains of each joint, and where they are."""
    found: dict[str, tuple[Mapping[str, str], Place]] = {}
    for path in packages.files(".yaml", ".yml"):
        source = packages.read(path)
        pending = list(read_yaml(source).documents) if GAINS_OF_GAZEBO.encode() in source.data else []
        while pending:
            node = pending.pop()
            entries = node.entries if isinstance(node, Map) else ()
            pending += [entry.value for entry in entries if entry.key.text != GAINS_OF_GAZEBO]
            for entry in entries:
                inner = entry.value.get("pid_gains") if isinstance(entry.value, Map) else None
                if entry.key.text == GAINS_OF_GAZEBO and isinstance(inner, Map):
                    found.update({one.key.text: (_numbers(one.value), one.key.at) for one in inner.entries})
    return {name: given for name, given in found.items() if "p" in given[0]}


def _numbers(node: object) -> dict[str, str]:
    entries = node.entries if isinstance(node, Map) else ()
    return {one.key.text: one.value.text for one in entries if isinstance(one.value, Scalar)}


def _with_gains(joint: Element, command: Element, given: Mapping[str, str]) -> Proposal:
    interface = attribute(command, "name")
    prefix = _PREFIXES[interface]
    clamp = given.get("i_clamp", "0.0").lstrip("+-")
    values = {
        "kp": given["p"],
        "ki": given.get("i", "0.0"),
        "kd": given.get("d", "0.0"),
        "max_integral_error": given.get("i_clamp_max", clamp),
        "min_integral_error": given.get("i_clamp_min", f"-{clamp}"),
    }
    indent, start = indent_of(command), lines_of(command).start
    lines = "".join(f'{indent}<param name="{prefix}_{name}">{value}</param>\n' for name, value in values.items())
    tag = joint.source.start_tag(command.start)
    assert tag is not None  # noqa: S101 (it has a name)
    edits = (
        Edit(SourceSpan(joint.source, start, start), lines),
        Edit(SourceSpan(joint.source, *tag.attributes["name"]), f"{interface}_pid"),
    )
    what = f"the gains of joint '{attribute(joint, 'name')}' in Gazebo became parameters of the joint"
    return Proposal(edits, entries=(ReportEntry(EntryKind.DONE, what, joint.at, authority=_AUTHORITY),))


JOINT_GAINS = Step(
    name="gains-of-gazebo",
    part=Part.URDF,
    summary="Gains of Gazebo Classic for joints",
    propose=_gains,
    generation=1,
    rows=(
        Row(
            "gazebo_ros_control/pid_gains/JOINT: {p, i, d, i_clamp}",
            'pos_kp, pos_ki, pos_kd and command "position_pid" up to iron',
            "",
            _AUTHORITY,
        ),
    ),
    before=[
        {
            "options": "--from=noetic --to=humble --simulator=gazebo-classic",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gazebo_ros2_control/GazeboSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>

                <gazebo>
                  <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "config/gains.yaml": """
                gazebo_ros_control:
                  pid_gains:
                    elbow: {p: 100.0, i: 1.0, d: 5.0, i_clamp: 3.0}
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gazebo_ros2_control/GazeboSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <param name="pos_kp">100.0</param>
                    <param name="pos_ki">1.0</param>
                    <param name="pos_kd">5.0</param>
                    <param name="pos_max_integral_error">3.0</param>
                    <param name="pos_min_integral_error">-3.0</param>
                    <command_interface name="position_pid"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>

                <gazebo>
                  <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
