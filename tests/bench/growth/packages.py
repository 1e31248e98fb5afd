"""Launch files, packages, settings, logs and folders that grow by one part."""

from __future__ import annotations

import json

from robots import (
    CONTROLLERS,
    LAUNCH,
    MANIFEST,
    ROS1_LAUNCH,
    XML_LAUNCH,
    YAML_LAUNCH,
    Grown,
    Tree,
    component,
    controlled,
    group,
    manager,
    robot,
    star,
)

HEAD = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node


def generate_launch_description():
"""
DESCRIPTION = (
    '<param name="robot_description" command="$(find xacro)/xacro $(find p)/urdf/r.xacro"/>\n'
    '<rosparam file="$(find p)/config/c.yaml"/>\n'
)


def base(joints: int = 1) -> Tree:
    names = ", ".join(f"j{i}" for i in range(joints))
    described = star(joints) + component("".join(controlled(f"j{i}") for i in range(joints)))
    return {**robot(described), CONTROLLERS: manager(["c"], group("c", names))}


def ros1(content: str) -> Tree:
    return {**base(), ROS1_LAUNCH: f"<launch>\n{DESCRIPTION}{content}</launch>\n"}


def xml(content: str) -> Tree:
    return {**base(), XML_LAUNCH: f'<launch>\n<let name="x" value="1"/>\n{content}</launch>\n'}


def yaml(content: str) -> Tree:
    return {**base(), YAML_LAUNCH: f"launch:\n{content}"}


def python(body: str, returned: str = "LaunchDescription([])") -> Tree:
    return {**base(), LAUNCH: f"{HEAD}{body}    return {returned}\n"}


def lines(line: str, count: int) -> str:
    return "".join(line.replace("@", str(i)) for i in range(count))


SPAWNER = '<node pkg="controller_manager" exec="spawner" args="c@"/>\n'
OLD_SPAWNER = '<node pkg="controller_manager" type="spawner" name="s@" args="c@"/>\n'
PYTHON_SPAWNER = "Node(package='controller_manager', executable='spawner', arguments=['c@'])"
BASE_CLASS = "base_class_type='controller_interface::ControllerInterface'"
SEMANTIC = "config/r.srdf"


def srdf(content: str) -> str:
    return f'<robot name="r">{content}</robot>'


PACKAGES: dict[str, Grown] = {
    # launch files
    "arguments of roslaunch": lambda n: ros1(lines('<arg name="a@" default="1"/>\n', n)),
    "arguments of arguments": lambda n: ros1(
        '<arg name="a" default="1"/>\n' + lines('<arg name="a@" default="$(arg a)"/>\n', n)
    ),
    "arguments of the environment": lambda n: ros1(lines('<arg name="a@" default="$(optenv A 1)"/>\n', n)),
    "arguments and nodes": lambda n: ros1(
        lines('<arg name="a@" default="1"/>\n<node pkg="p" type="t" name="n@"/>\n', n)
    ),
    "arguments and groups": lambda n: ros1(lines('<arg name="a@" default="1"/>\n<group><group/></group>\n', n)),
    "groups in groups": lambda n: ros1("<group>" * n + "</group>" * n),
    "spawners of roslaunch": lambda n: ros1(lines(OLD_SPAWNER, n)),
    "words of a node": lambda n: ros1(OLD_SPAWNER.replace("c@", lines("c@ ", n))),
    "parameters of roslaunch": lambda n: ros1(lines('<param name="a@" value="1"/>\n', n)),
    "files of roslaunch": lambda n: ros1('<rosparam file="$(find p)/config/c.yaml"/>\n' * n),
    "inline parameters": lambda n: ros1(lines("<rosparam>{a@: 1}</rosparam>\n", n)),
    "an inline parameter": lambda n: ros1("<rosparam>" + lines("a@: 1\n", n) + "</rosparam>\n"),
    "remaps of roslaunch": lambda n: ros1(lines('<remap from="a@" to="b"/>\n', n)),
    "substitutions of one text": lambda n: ros1(
        '<arg name="b" default="1"/><arg name="a" default="' + "$(arg b)" * n + '"/>'
    ),
    "evaluations of roslaunch": lambda n: ros1(lines('<arg name="a@" default="$(eval 1 + @)"/>\n', n)),
    "includes of roslaunch": lambda n: {
        **ros1('<include file="$(find p)/launch/a.xml"/>\n' * n),
        "launch/a.xml": "<launch/>",
    },
    "arguments of an include": lambda n: {
        **ros1('<include file="$(find p)/launch/a.xml">' + lines('<arg name="a@" value="1"/>\n', n) + "</include>\n"),
        "launch/a.xml": "<launch>" + lines('<arg name="a@"/>\n', n) + "</launch>",
    },
    "missing files of roslaunch": lambda n: ros1(lines('<rosparam file="$(find p)/config/c@.yaml"/>\n', n)),
    "packages of roslaunch": lambda n: ros1(lines('<include file="$(find pkg_@)/a.launch"/>\n', n)),
    "arguments in XML": lambda n: xml(lines('<arg name="a@" default="1"/>\n', n)),
    "spawners in XML": lambda n: xml(lines(SPAWNER, n)),
    "words in XML": lambda n: xml(SPAWNER.replace("c@", lines("c@ ", n))),
    "substitutions in XML": lambda n: xml('<let name="a" value="' + "$(var x)" * n + '"/>'),
    "substitutions in substitutions": lambda n: xml('<let name="a" value="' + "$(var " * n + "x" + ")" * n + '"/>'),
    "open substitutions": lambda n: xml('<let name="a" value="' + "$(var " * n + '"/>'),
    "parameters in XML": lambda n: xml(
        '<node pkg="p" exec="e">' + lines('<param name="a@" value="1"/>\n', n) + "</node>"
    ),
    "groups with arguments in XML": lambda n: xml(lines('<let name="a@" value="1"/><group/>\n', n)),
    "arguments in YAML": lambda n: yaml(lines("- arg: {name: a@, default: '1'}\n", n)),
    "spawners in YAML": lambda n: yaml(lines("- node: {pkg: controller_manager, exec: spawner, args: c@}\n", n)),
    "names in Python": lambda n: python(lines("    a@ = @\n", n)),
    "branches in Python": lambda n: python(lines("    a@ = @\n    if x:\n        b@ = 1\n", n)),
    "returns in Python": lambda n: python(lines("    if x:\n        return [@]\n", n)),
    "spawners in Python": lambda n: python(
        "    a = [\n" + lines(f"        {PYTHON_SPAWNER},\n", n) + "    ]\n", "LaunchDescription(a)"
    ),
    "appended actions": lambda n: python(
        "    a = LaunchDescription()\n" + lines(f"    a.add_action({PYTHON_SPAWNER})\n", n), "a"
    ),
    "declared arguments": lambda n: python(
        "    a = LaunchDescription()\n"
        + lines("    a.add_action(DeclareLaunchArgument('a@', default_value='1'))\n", n),
        "a",
    ),
    "items of a list": lambda n: python("    a = [" + "1, " * n + "]\n    b = a + a\n"),
    "parts of a text": lambda n: python("    a = 'x'\n    b = f'" + "{a}" * n + "'\n"),
    "added texts": lambda n: python("    a = ''\n" + lines("    a = a + 'x'\n", n)),
    "functions in Python": lambda n: python(lines("    def f@(): return 1\n    f@()\n", n)),
    "comparisons in Python": lambda n: python("    a = " + lines("x == @ or ", n) + "1\n"),
    "entries of a dict": lambda n: python("    a = {" + lines('"a@": 1, ', n) + "}\n    b = {**a, **a}\n"),
    "brackets in Python": lambda n: python("    a = " + "-" * n + "1\n"),
    "imports": lambda n: python(lines("    from os import path as a@\n", n)),
    "launch files": lambda n: {
        **base(),
        **{f"launch/l{i}.launch": f"<launch>\n{DESCRIPTION}</launch>\n" for i in range(n)},
    },
    # packages and settings
    "dependencies": lambda n: {
        **base(),
        "package.xml": MANIFEST.format(lines("<depend>d@</depend>\n", n)),
        ROS1_LAUNCH: "<launch>" + lines('<include file="$(find d_@)/a.launch"/>\n', n) + "</launch>",
    },
    "exports of a package": lambda n: {
        **base(),
        "package.xml": MANIFEST.format("<export>" + lines('<a plugin="${prefix}/p@.xml"/>\n', n) + "</export>"),
    },
    "classes of a plugin": lambda n: {
        **base(),
        "package.xml": MANIFEST.format('<export><controller_interface plugin="${prefix}/p.xml"/></export>'),
        "p.xml": "<library path='p'>" + lines(f"<class name='p/C@' type='p::C@' {BASE_CLASS}/>\n", n) + "</library>",
    },
    "installs of CMake": lambda n: {
        **base(),
        "CMakeLists.txt": "project(p)\n" + lines("install(DIRECTORY a@ DESTINATION share/p)\n", n),
        ROS1_LAUNCH: "<launch>" + lines('<rosparam file="$(find p)/a@/b.yaml"/>', min(n, 300)) + "</launch>",
    },
    "loops of CMake": lambda n: {
        **base(),
        "CMakeLists.txt": "project(p)\n"
        + lines("foreach(a b)\ninstall(FILES ${a} DESTINATION share/p)\nendforeach()\n", n),
    },
    "data files of setup.py": lambda n: {
        **base(),
        "setup.py": "from setuptools import setup\nsetup(data_files=[\n"
        + lines("    ('share/p/a@', ['a@/b']),\n", n)
        + "])\n",
    },
    "lines of .gitignore": lambda n: {
        **base(),
        ".gitignore": lines("a@*b\n", n),
        **{f"urdf/x{i}.yaml": "a: 1\n" for i in range(200)},
    },
    "stars of .gitignore": lambda n: {**base(), ".gitignore": "*a" * n + "\n", "urdf/" + "a" * 200: ""},
    "stars of folders of .gitignore": lambda n: {**base(), ".gitignore": "a/" + "**/" * n + "b\n"},
    "ignored codes": lambda n: {**base(), "urdfctl.toml": "ignore = [" + lines('"UC@", ', n) + "]\n"},
    "ignored codes of files": lambda n: {
        **base(),
        "urdfctl.toml": "[per-file-ignores]\n" + lines('"a@/*" = ["UC1"]\n', n),
    },
    "robots of the settings": lambda n: {
        **base(),
        "urdfctl.toml": lines('[[robot]]\nname = "r@"\npath = "urdf/r.xacro"\n\n', n),
    },
    "packages of a workspace": lambda n: {
        **base(),
        **{f"a{i}/package.xml": MANIFEST.format("").replace("<name>p", f"<name>p{i}") for i in range(n)},
    },
    "folders in folders": lambda n: {**base(), "/".join(["a"] * min(n, 400)) + "/b.yaml": "a: 1\n"},
    "files that are nothing": lambda n: {**base(), **{f"a{i}.txt": "" for i in range(n)}},
    "robots of a folder": lambda n: {
        f"urdf/r{i}.urdf": f'<robot name="r{i}"><link name="a"/></robot>' for i in range(n)
    },
    "controller files of a folder": lambda n: {
        **base(),
        **{f"config/c{i}.yaml": manager(["c"], group("c", "j0")) for i in range(n)},
    },
    # MoveIt
    "groups of MoveIt": lambda n: {
        **base(),
        SEMANTIC: srdf(lines('<group name="g@"><joint name="j_@"/></group>\n', n)),
    },
    "collisions of MoveIt": lambda n: {
        **base(),
        SEMANTIC: srdf(lines('<disable_collisions link1="l_@" link2="base"/>\n', n)),
    },
    "states of MoveIt": lambda n: {
        **base(),
        SEMANTIC: srdf(
            '<group name="g"><joint name="j0"/></group>'
            + lines('<group_state name="s@" group="g"><joint name="j_@" value="0"/></group_state>\n', n)
        ),
    },
    # known findings
    "known findings": lambda n: {
        **robot('<link name="b"/>\n' * min(n, 2000)),
        "known.json": json.dumps(
            {"version": 1, "findings": [{"code": "UC101", "file": f"a{i}.urdf", "message": "m"} for i in range(n)]}
        ),
    },
}
MESSAGES = {
    "messages": "[ERROR] [1700000000.0] [controller_manager]: The controller named 'c@' was not found.\n",
    "errors of spawners": "[spawner-@] [FATAL] [1700000000.0] [spawner_c@]: Failed loading controller c@\n",
    "messages of nothing": "hello @\n",
    "tracebacks": "Traceback (most recent call last):\n  File 'a@.py', line @, in f\nKeyError: '@'\n",
    "messages of one kind": "[ERROR] [1700000000.0] [controller_manager]: Could not load controller 'c'\n",
    "quotes": "'\"@",
    "brackets": "[",
    "codes of colours": "\x1b[31m",
    "words": "Could not load controller c@ because ",
    "blanks": " ",
}
LOGS: dict[str, Grown] = {
    f"{name} of a log": lambda n, message=message: {"a.log": lines(message, n)} for name, message in MESSAGES.items()
}
LOGS["messages of a log of a robot"] = lambda n: {**base(min(n, 300)), "a.log": lines(MESSAGES["messages"], n)}
