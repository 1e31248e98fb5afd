"""UC624."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.control.model_spawners import model_spawners, option_name, option_of
from urdfctl.control.parameters.spawner_options import MODEL_SOURCES, OF_MODEL_SPAWNERS
from urdfctl.model.launch import Launch, Node, Word, joined
from urdfctl.names import nearest
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch.common import ROS_2, state_publishers
from urdfctl.rules.launch.steps import PUBLISHES_DESCRIPTION, description_topic, started_apart
from urdfctl.rules.launch_samples import PUBLISHER
from urdfctl.source.opaque import UNKNOWN

_GZ = """
      <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"><arg name="gz_args" value="-r empty.sdf"/></include>
      <node pkg="ros_gz_sim" exec="create" args="-topic %s -name arm"/>"""
_MARKED_GZ = _GZ.replace("<node", "«<node").replace('arm"/>', 'arm"/>»')
_SPAWN = """
            <launch>
              <include file="$(find gazebo_ros)/launch/empty_world.launch"/>%s
              <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param %s -model arm"/>
            </launch>
"""
_FOREIGN = """
      <include file="$(find-pkg-share other_arm)/launch/arm.launch.py"/>"""
_SET = """
              <param name="robot_description" textfile="$(find arm)/arm.urdf"/>"""


def _of_ros2(*nodes: str) -> dict[str, str]:
    manifest = "".join(
        f"<exec_depend>{name}</exec_depend>" for name in ("ros_gz_sim", "robot_state_publisher", "xacro")
    )
    return {
        "arm.launch.xml": f"<launch>{''.join(nodes)}</launch>",
        "arm.urdf": "",
        "package.xml": f"<package><name>arm</name>{manifest}</package>",
    }


def _of_ros1(parameter: str, set_before: str = _SET) -> dict[str, str]:
    manifest = "<package><name>arm</name><exec_depend>gazebo_ros</exec_depend></package>"
    return {"arm.launch": _SPAWN % (set_before, parameter), "arm.urdf": "", "package.xml": manifest}


@rule(
    "UC624",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros_gz_sim create.cpp: 'Waiting messages on topic [%s].', until one comes; gazebo_ros spawn_entity.py: 'Waiting for "
    "entity xml on %s'; spawn_model of ROS 1: rospy.get_param() raises KeyError; without a source create.cpp: 'Must specify "
    "either -file, -param, -string or -topic', and argparse in the others",
    bad=[
        _of_ros2(PUBLISHER, _GZ % "«robot_desc»"),
        _of_ros2(_GZ % "«robot_description»"),
        _of_ros1("«robot_descripton»"),
        _of_ros1("robot_description", _SET.replace("robot_description", "«robot_descripton»")),
        _of_ros1("«robot_description»", ""),
        {
            **_of_ros1("«robot_description»", _SET.replace("robot_description", "robot_desc")),
            "other.launch": f"<launch>{_SET}</launch>",
        },
        _of_ros2(PUBLISHER, _GZ % "«robot_descriptions»", _FOREIGN),
        _of_ros2(PUBLISHER, _MARKED_GZ.replace("-topic %s ", "")),
    ],
    good=[
        _of_ros2(PUBLISHER, _GZ % "robot_description"),
        _of_ros2(PUBLISHER, _GZ % "/robot_description"),
        {**_of_ros2(PUBLISHER, _GZ % "robot_desc"), "publish.py": "node.create_publisher(String, 'robot_desc', 1)\n"},
        {**_of_ros2(_GZ % "robot_description"), "state.launch.xml": f"<launch>{PUBLISHER}</launch>"},
        _of_ros1("robot_description"),
        _of_ros1("robot_descriptions", _SET.replace("robot_description", "robot_descriptions")),
        _of_ros2(PUBLISHER, _GZ % "robot_model", _FOREIGN),
        {**_of_ros1("robot_description", ""), "README.md": "rosparam set robot_description -t arm.urdf\n"},
    ],
)
def model_description_missing(project: Project) -> Iterator[Finding]:
    """Model is spawned from a topic or parameter that nobody sets, or from nothing.

    With `-topic`, the program waits for a description that never comes. With `-param` of ROS 1, it ends with a KeyError;
    without any source, with an error. Either way the robot is not spawned, and its controller manager does not start. It is
    an error if the launch file publishes the description under another name, or sets a parameter that is robot_description
    with a slip. If some included file is not here, only a similar name is reported.
    """
    launch = project.launch
    if launch is None or not (launch.complete or launch.unread):
        return
    yield from _misnamed(project, launch)
    for node in model_spawners(launch):
        if node.sure and node.complete and not _names_source(node):
            asked = "-param" if launch.ros != ROS_2 else "-topic"
            message = f"'{node.executable.text}' is not told what to spawn, and ends; add {asked} robot_description"
            yield Finding(node.at, message)
        elif node.sure and node.complete and node.namespace is not None and not launch.misnamed:
            found = _of_topic(project, launch, node) if launch.ros == ROS_2 else _of_parameter(project, launch, node)
            yield from found if launch.complete else (each for each in found if each.fix is not None)


def _names_source(node: Node) -> bool:
    """Whether a program gets what it spawns, by an option or a parameter. Options may be shortened; one that it does not
    have may be a misspelt source, which another rule tells.
    """
    program = node.executable.text
    sources, options = MODEL_SOURCES.get(program), OF_MODEL_SPAWNERS.get(program)
    given = [name for name in map(option_name, node.words) if name is not None]
    given += [word.text for word in node.parameters]
    if sources is None or node.files or (options and not set(given) <= set(options)):
        return True
    return any(source.startswith(name) for source in sources for name in given)


def _misnamed(project: Project, launch: Launch) -> Iterator[Finding]:
    """Yield the parameters of ROS 1 that are robot_description with a slip, and that nothing reads."""
    for word in launch.misnamed:
        if not _reads(launch, word.text) and not project.may_mention(_named(word.text)):
            message = f"parameter '{word.text}' has the robot description, but nothing reads it; did you mean 'robot_description'?"
            yield Finding(word.at, message, fix=replaced(word.at, word.text, "robot_description"))


def _of_topic(project: Project, launch: Launch, node: Node) -> Iterator[Finding]:
    word = option_of(node, "topic")
    publishers = state_publishers(launch)
    known = all(each.namespace is not None and each.complete for each in publishers)
    if word is None or word.known is None or not known:
        return
    asked, offered = description_topic(node, word.text), {description_topic(each): each for each in publishers}
    if asked in offered or UNKNOWN in asked or any(asked in map(_absolute, _ends(each)) for each in launch.nodes):
        return
    if not offered:
        apart = started_apart(launch)
        if not project.may_mention(PUBLISHES_DESCRIPTION, apart) and not project.may_mention(_named(asked), apart):
            yield _finding(node, word, f"nothing here publishes '{asked}'", Severity.WARNING)
    elif not project.may_mention(_named(asked)):
        topic, publisher = next(iter(offered.items()))
        sure = launch.complete and all(each.sure for each in launch.nodes)
        found = _finding(node, word, f"robot_state_publisher publishes '{topic}'", None if sure else Severity.WARNING)
        fix = replaced(word.at, word.text, topic.lstrip("/")) if nearest(asked, [topic]) else None
        yield found._replace(notes=(Note("robot_state_publisher is started here", publisher.at),), fix=fix)


def _of_parameter(project: Project, launch: Launch, node: Node) -> Iterator[Finding]:
    word = option_of(node, "param")
    if word is None or word.known is None or UNKNOWN in "".join(launch.named):
        return
    asked = joined(node.namespace or "", word.text)
    loaded = {load.namespace for load in launch.loads}  # the parameters in files, none of which is a description
    named = [name for name in launch.named if name and name not in loaded]
    if any(f"{asked}/".startswith(f"{name}/") or name.startswith(f"{asked}/") for name in named):
        return
    if not all(load.file.exists for load in launch.loads) or any(not one.name for one in launch.inline):
        return
    others = [
        name for name in launch.named if re.search("desc|urdf", name.rpartition("/")[2]) and not _reads(launch, name)
    ]
    is_elsewhere = project.may_mention(_named(asked), started_apart(launch))
    if is_elsewhere and not others:
        return
    what = f"the launch file sets '{others[0]}'" if others else "nothing here sets it"
    message = f"'{node.executable.text}' reads parameter '{asked}', but {what}"
    fix = replaced(word.at, word.text, others[0].lstrip("/")) if others and nearest(asked, others) else None
    sure = launch.complete and others and not is_elsewhere
    yield Finding(word.at, message, fix=fix, severity=None if sure else Severity.WARNING)


def _reads(launch: Launch, name: str) -> bool:
    """Whether a node of the launch file may read a parameter: an argument or a parameter of it says its name."""
    words = (word.text for node in launch.nodes for word in (*node.words, *node.parameters))
    return any(re.search(_named(name), word) for word in words)


def _finding(node: Node, word: Word, what: str, severity: Severity | None) -> Finding:
    asked = description_topic(node, word.text)
    return Finding(word.at, f"'{node.executable.text}' waits for topic '{asked}', but {what}", severity=severity)


def _named(topic: str) -> str:
    """What says a topic's or parameter's name."""
    return rf"\b{re.escape(topic.rpartition('/')[2])}\b"


def _ends(node: Node) -> Iterator[str]:
    """The topics that a node's remappings lead to."""
    yield from (after for _, after in node.remaps)


def _absolute(topic: str) -> str:
    return f"/{topic.lstrip('/')}"
