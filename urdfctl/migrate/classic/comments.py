"""Comments of descriptions that are read as YAML: by launch without a type, by Gazebo Classic's plugin in humble."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.edits.tokens import XML
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.rules.launch.description_read_as_yaml import description_read_as_yaml
from urdfctl.rules.ros2_control.comment_breaks_parameter import comment_breaks_parameter
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.todo import MARK

_AUTHORITY = (
    "gazebo_ros2_control#295: humble's plugin passes the description on as a parameter, which is parsed as YAML"
)
_LAUNCH = "launch_ros utilities/evaluate_parameters.py: a substitution without a type is passed to yaml.safe_load"
_COLON = re.compile(r"[ \t]*:(?=\s)")
_HASH = re.compile(r"(?<=\s)#+")


def _comments(packages: MigratedPackages) -> Iterator[Proposal]:
    is_passed_on = packages.options.target == "humble" and packages.simulator == "gazebo-classic"
    if not is_passed_on and not any(MARK.encode() in packages.read(path).data for path in packages.files(*XML)):
        return
    done: set[tuple[str, int]] = set()
    fixes: tuple[str, ...] = ()
    for loaded in packages.loaded(packages.options.target):
        if is_passed_on and any(comment_breaks_parameter.check(loaded.project)):
            what, authority, fixes = "Gazebo's plugin cannot pass on", _AUTHORITY, ("UC359",)
        elif any(description_read_as_yaml.check(loaded.project)):
            what, authority, fixes = "launch cannot read", _LAUNCH, ()
        else:
            continue
        what = f"the punctuation of a comment is changed: {what} a colon before a blank"
        for span in _spans(packages, loaded):
            new = re.sub(r"--+", "-", _HASH.sub("", _COLON.sub(" -", span.text)))
            if new != span.text and (span.file, span.start) not in done:
                done.add((span.file, span.start))
                at = Place(span.source, span.start, end=span.end)
                entry = ReportEntry(EntryKind.DECIDED, what, at, authority=authority, option="delete the comment")
                yield Proposal((Edit(span, new),), entries=(entry,), fixes=fixes)


def _spans(packages: MigratedPackages, loaded: LoadedTarget) -> Iterator[SourceSpan]:
    """Yield the texts of the comments that a robot keeps."""
    tag = loaded.project.robot.tag if loaded.project.robot else None
    kept = {comment.text.strip() for comment in tag.comments()} if tag else set()
    for path in loaded.sources if kept else ():
        if path.endswith(XML) and packages.may_change(path):
            yield from _written(packages.read(path), kept)


def _written(source: SourceText, kept: set[str]) -> Iterator[SourceSpan]:
    """Yield the texts of the comments in a file that a robot keeps; those with expressions look different there."""
    for found in re.finditer(rb"<!--(.*?)-->", source.data, re.DOTALL):
        span = SourceSpan(source, *found.span(1))
        if "$" in span.text or span.text.strip() in kept:
            yield span


COMMENTS = Step(
    name="comments",
    part=Part.URDF,
    summary="Comments in descriptions that are read as YAML",
    propose=_comments,
    rows=(
        Row("<!-- NAME: text --> for Gazebo Classic", "<!-- NAME - text -->", "humble", _AUTHORITY),
        Row("<!-- NAME: text --> that launch reads as YAML", "<!-- NAME - text -->", "", _LAUNCH),
    ),
    before=[
        {
            "options": "--to=humble --simulator=gazebo-classic",
            "robot.urdf": """
                <!-- wheels: the left ones -->
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
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <!-- wheels - the left ones -->
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
        },
    ],
)
