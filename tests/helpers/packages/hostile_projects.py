"""Projects of strangers, each with one way to name something of the user's, and the commands that may read it.

`{home}` stands for a folder of the user's beside the project.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

CANARY = "CANARY5f1d"
MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>\n"
KINDS = {
    "urdf": f'<robot name="{CANARY}"><link name="{CANARY}"/></robot>\n',
    "yaml": f"controller_manager: {{ros__parameters: {{{CANARY}: {{type: {CANARY}/X}}}}}}\n",
    "launch": f"<launch><{CANARY}/></launch>\n",
    "srdf": f'<robot name="{CANARY}"/>\n',
    "obj": f"v 0 0 0 {CANARY}\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "stl": f"solid {CANARY}\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n",
    "py": f"{CANARY} = 1\n",
    "csv": f"{CANARY}\n",
}
HOME = {
    **{f"known.{kind}": text for kind, text in KINDS.items()},
    **{f"{CANARY}.{kind}": text for kind, text in KINDS.items()},
    ".netrc": f"machine {CANARY} login x\n",
    ".kube/config": f"token: {CANARY}\n",
    "urdfctl.toml": f'distro = "{CANARY}"\n',
    "baseline.json": f'{{"{CANARY}": 1}}\n',
    "tasks.yaml": f"{CANARY}: 1\n",
    "gazebo.log": f"[ERROR] [1.0]: {CANARY}\n",
    "package.xml": MANIFEST.format("known").replace("<export>", f"<depend>{CANARY}</depend><export>"),
    "CMakeLists.txt": f"project({CANARY})\ninstall(DIRECTORY {CANARY} DESTINATION share/{CANARY})\n",
    "setup.py": f"{CANARY} = 1\n",
    ".gitignore": "*\n",
    "config/known.srdf": KINDS["srdf"],
    f"config/{CANARY}.srdf": KINDS["srdf"],
    f"config/{CANARY}_planning.yaml": f"planning_plugin: {CANARY}\n",
    f"launch/{CANARY}.launch": KINDS["launch"],
    "controllers/known.j2": CANARY,
    "controllers/ros2.yaml.j2": CANARY,
    f"controllers/{CANARY}.j2": CANARY,
}
"""What the user has, and nobody else may know: contents and names."""

BODY = """
<link name="base"/><link name="fore"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0"
 izz="1"/></inertial>{}</link><joint name="elbow" type="revolute"><parent link="base"/><child link="fore"/><axis
 xyz="0 0 1"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint>
<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
<joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>
"""
XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}' + BODY.format("") + "</robot>\n"
ROBOT = XACRO.format("")
CONTROLLERS = """\
controller_manager:
  ros__parameters: {update_rate: 100, arm: {type: forward_command_controller/ForwardCommandController}}
arm: {ros__parameters: {joints: [elbow], interface_name: position}}
"""
LAUNCH = """\
<launch>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param name="robot_description" value="$(command 'xacro $(dirname)/r.xacro')"/><param from="$(dirname)/c.yaml"/>
  </node>
  {}
</launch>
"""
FILES = {
    ".git/HEAD": "",
    "package.xml": MANIFEST.format("pull"),
    "r.xacro": ROBOT,
    "c.yaml": CONTROLLERS,
    "up.launch.xml": LAUNCH.format(""),
}
VALUE = "joint:elbow/limit/@velocity"
READING: Sequence[Sequence[str]] = (
    ("lint", "."),
    ("lint", "r.xacro", "--fix"),
    ("smoke", ".", "--engine", "auto"),
    ("show", "."),
    ("graph", "."),
    ("view", "r.xacro"),
    ("why", "r.xacro", VALUE),
    ("expand", "r.xacro"),
    ("diff", "r.xacro", "r.xacro"),
    ("init", ".", "--force"),
    ("convert", "r.xacro", "--to", "mjcf", "--interface", "position", "-o", "made.xml", "--force"),
    (
        "gen-all",
        "r.xacro",
        "--type",
        "trajectory",
        "--distro",
        "jazzy",
        "--simulator",
        "mujoco",
        "-o",
        "made",
        "--force",
    ),
    ("migrate", ".", "--to", "jazzy"),
    ("explain", "unknown hardware", "--in", "."),
)
"""The commands that read robots, and the configuration."""


class Hostile(NamedTuple):
    """Files and links that replace or join those of the project, and the commands to run.

    said: a text in the output of the first command, if it has to say something.
    is_named: whether the words name the link: then what it leads to may be looked at, but not read.
    """

    files: Mapping[str, str] = {}
    links: Mapping[str, str] = {}
    words: Sequence[Sequence[str]] = READING
    said: str = ""
    is_named: bool = False


def table(text: str, said: str = "", links: Mapping[str, str] | None = None) -> Hostile:
    """A configuration."""
    return Hostile({"urdfctl.toml": text}, links or {}, said=said)


def mesh(address: str, links: Mapping[str, str] | None = None) -> Hostile:
    """A robot whose shape is in a file."""
    shape = f'<geometry><mesh filename="{address}"/></geometry>'
    parts = f"<visual>{shape}</visual><collision>{shape}</collision>"
    return Hostile({"r.xacro": ROBOT.replace("</link><joint", f"{parts}</link><joint")}, links or {})


def xacro(text: str, links: Mapping[str, str] | None = None, said: str = "") -> Hostile:
    """A robot with more elements of xacro."""
    return Hostile({"r.xacro": XACRO.format(text)}, links or {}, said=said)


def launch(text: str, links: Mapping[str, str] | None = None) -> Hostile:
    """A launch file with more elements."""
    return Hostile({"up.launch.xml": LAUNCH.format(text)}, links or {}, READING[:5])


def python(text: str, links: Mapping[str, str] | None = None) -> Hostile:
    """A launch file in Python."""
    before = "import os, yaml\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
    return Hostile({"up.launch.py": f"{before}{text}\n"}, links or {}, READING[:5])


def made(command: str, links: Mapping[str, str] | None = None, said: str = "is skipped") -> Hostile:
    """A generated file with a command in its first line."""
    header = {"made.yaml": f"# made by urdfctl {command}\na: 1\n"}
    return Hostile(header, links or {}, [("gen-check", "."), ("gen-check", "made.yaml", "--update")], said)


def build(cmake: str, **files: str) -> Hostile:
    """A package with a CMakeLists.txt, and a controller of its own."""
    whole = f"cmake_minimum_required(VERSION 3.8)\nproject(pull)\n{cmake}\n"
    own = CONTROLLERS.replace("forward_command_controller/ForwardCommandController", "pull/Own")
    return Hostile({"CMakeLists.txt": whole, "c.yaml": own, **files})


OUTSIDE = "outside the workspace"
CLASS = '<class type="pull::Own" base_class_type="controller_interface::ControllerInterface"/>'
PLUGIN = f'<library path="pull">{CLASS}</library>'
CODE = '#include "parameters.hpp"\nclass Own : controller_interface::ControllerInterface {};\n'
WIDER = 'package-paths = ["{}"]\n'
LOADS = "<link name=\"${xacro.load_yaml('{home}/.kube/config')['token']}\"/>"

CASES: Mapping[str, Hostile] = {
    # -- configuration
    "a configuration widens what may be read": Hostile(
        {"urdfctl.toml": WIDER.format("{home}"), "r.xacro": XACRO.format(LOADS)}, said=OUTSIDE
    ),
    "a configuration widens it to everything": Hostile(
        {"urdfctl.toml": WIDER.format("/"), "r.xacro": XACRO.format(LOADS)}, said=OUTSIDE
    ),
    "a configuration widens it by a relative path": table(WIDER.format("../home"), OUTSIDE),
    "a configuration widens it by a link": table(WIDER.format("l"), OUTSIDE, {"l": "{home}"}),
    "pyproject.toml widens it": Hostile({"pyproject.toml": "[tool.urdfctl]\n" + WIDER.format("{home}")}, said=OUTSIDE),
    "a robot of the configuration": table('[[robot]]\npath = "{home}/.netrc"\n', OUTSIDE),
    "a misspelt robot of the configuration": table('[[robot]]\npath = "{home}/CANARY5f1.urdf"\n', OUTSIDE),
    "a relative robot of the configuration": table('[[robot]]\npath = "../home/.netrc"\n', OUTSIDE),
    "a linked robot of the configuration": table('[[robot]]\npath = "l.urdf"\n', OUTSIDE, {"l.urdf": "{home}/.netrc"}),
    "a launch file of the configuration": table('[[robot]]\npath = "r.xacro"\nlaunch = ["{home}/.netrc"]\n', OUTSIDE),
    "a controller file of the configuration": table(
        '[[robot]]\npath = "r.xacro"\ncontrollers = ["{home}/known.yaml"]\n', OUTSIDE
    ),
    "a configuration that is a link": Hostile({}, {"urdfctl.toml": "{home}/urdfctl.toml"}, READING[:9], OUTSIDE),
    "a configuration in a package that is a link": Hostile(
        {"sub/r.xacro": ROBOT},
        {"sub/pyproject.toml": "{home}/.netrc"},
        [("lint", "sub"), ("show", "sub/r.xacro")],
        OUTSIDE,
    ),
    "a configuration in the repository that an option names": Hostile(
        {"ci.toml": WIDER.format("{home}"), "r.xacro": XACRO.format(LOADS)},
        words=[("lint", ".", "--config", "ci.toml"), ("lint", "r.xacro", "--workspace", "sub", "--config", "ci.toml")],
        links={"sub/x": "nowhere"},
        said=OUTSIDE,
    ),
    "files that options name and that are links": Hostile(
        {},
        {name: f"{{home}}/{name}" for name in ("urdfctl.toml", "baseline.json", "tasks.yaml", "gazebo.log")}
        | {
            "t": "{home}",
            "l.yaml": "{home}/known.yaml",
            "l.urdf": "{home}/known.urdf",
            "c.csv": "{home}/known.csv",
        },
        [
            ("lint", "r.xacro", "--config", "urdfctl.toml"),
            ("lint", "l.urdf", "--config", "package.xml"),
            ("lint", "r.xacro", "--baseline", "baseline.json", "--config", "c.yaml"),
            ("smoke", "l.urdf", "--engine", "none"),
            ("smoke", "r.xacro", "--tasks", "tasks.yaml"),
            ("smoke", "r.xacro", "--engine", "none", "--controllers", "l.yaml"),
            ("explain", "gazebo.log"),
            ("explain", "./gazebo.log", "--in", "."),
            ("schema", "--check", "l.yaml", "--distro", "jazzy"),
            ("schema", "--check", "l.urdf", "--distro", "jazzy"),
            ("why", "l.yaml:1"),
            ("why", "r.xacro", "l.yaml:1"),
            ("expand", "l.urdf"),
            ("diff", "l.urdf", "r.xacro"),
            ("view", "l.urdf"),
            ("gen-controllers", "c.csv", "--type", "effort", "--distro", "jazzy"),
            ("gen-controllers", "--joint", "a", "--type", "effort", "--distro", "jazzy", "--templates", "t"),
            ("gen-controllers", "--list-templates", "--templates", "t"),
            ("gen-transmissions", "--joint", "a", "--distro", "noetic", "--into", "l.urdf", "--diff"),
            ("migrate", "l.urdf", "--to", "jazzy"),
            ("lint", "r.xacro", "--node", "x=l.yaml"),
            ("lint", "r.xacro", "--package-path", "t"),
        ],
        said="leads outside the workspace; name what it leads to",
        is_named=True,
    ),
    "templates that are links": Hostile(
        {},
        {"t/controllers/ros2.yaml.j2": "{home}/controllers/known.j2", "u/controllers": "{home}/controllers"},
        [
            ("gen-controllers", "--joint", "a", "--type", "effort", "--distro", "jazzy", "--templates", "t"),
            ("gen-controllers", "--joint", "a", "--type", "effort", "--distro", "jazzy", "--templates", "u"),
            ("gen-controllers", "--list-templates", "--templates", "u"),
        ],
        OUTSIDE,
    ),
    # -- robots
    "a mesh by its path": mesh("file://{home}/known.stl"),
    "a mesh in another form by its path": mesh("file://{home}/known.obj"),
    "a misspelt mesh by its path": mesh("file://{home}/CANARY5f1.stl"),
    "a relative mesh": mesh("../home/known.stl"),
    "a mesh above its package": mesh("package://pull/../home/known.stl"),
    "a misspelt mesh above its package": mesh("package://pull/../home/CANARY5f1.stl"),
    "a mesh that is a link": mesh("package://pull/l.stl", {"l.stl": "{home}/known.stl"}),
    "a mesh in a folder that is a link": mesh("package://pull/l/CANARY5f1.stl", {"l": "{home}"}),
    "a mesh in a package that is a link": mesh("package://known/known.stl", {"known": "{home}"}),
    "an include by its path": xacro('<xacro:include filename="{home}/known.urdf"/>', said=OUTSIDE),
    "an include of a folder": xacro('<xacro:include filename="{home}"/>', said=OUTSIDE),
    "an include of a pattern": xacro('<xacro:include filename="{home}/*"/>'),
    "an include of a pattern that climbs": xacro(
        '<xacro:include filename="s/*/../../../home/*"/>', {"s/d/x": "nowhere"}
    ),
    "an include of a pattern through a link": xacro('<xacro:include filename="l*/*"/>', {"l": "{home}"}),
    "an include of a package that is a link": xacro(
        '<xacro:include filename="$(find known)/known.urdf"/>', {"known": "{home}"}
    ),
    "a property of a file": xacro("<xacro:property name='p' value=\"${xacro.load_yaml('../home/.kube/config')}\"/>"),
    "an argument of a file": xacro(
        '<xacro:arg name="f" default="CANARY"/><xacro:include filename="{home}/$(arg f)5f1.xacro"/>', said=OUTSIDE
    ),
    "parameters of a plugin": xacro(
        '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
        "<parameters>{home}/known.yaml</parameters></plugin></gazebo>"
    ),
    # -- launch files
    "a description of a launch file": Hostile(
        {"up.launch.xml": LAUNCH.format("").replace("$(dirname)/r.xacro", "{home}/.netrc")}, words=READING[:5]
    ),
    "parameters of a launch file": launch('<node pkg="p" exec="e"><param from="{home}/known.yaml"/></node>'),
    "misspelt parameters of a launch file": launch(
        '<node pkg="p" exec="e"><param from="{home}/CANARY5f1.yaml"/></node>'
    ),
    "an include of a launch file": launch('<include file="{home}/known.launch"/>'),
    "a robot by the argument of a launch file": Hostile(
        {
            "up.launch": '<launch><arg name="m"/><param name="robot_description" textfile="{home}/$(arg m).urdf"/>'
            '<rosparam file="{home}/$(arg m).yaml"/></launch>'
        },
        words=READING[:5],
    ),
    "files of a launch file in Python": python(
        "def generate_launch_description():\n"
        "    x = yaml.safe_load(open('{home}/known.yaml'))\n"
        "    d = open('{home}/known.urdf').read()\n"
        "    return LaunchDescription([Node(package='controller_manager', executable='ros2_control_node',\n"
        "        parameters=[x, {'robot_description': d}, '{home}/known.yaml'])])"
    ),
    "a module of a launch file in Python": python(
        "from l.known import x\nfrom ...home.known import y\n"
        "def generate_launch_description():\n    return LaunchDescription([x(), y()])",
        {"l": "{home}"},
    ),
    "a MoveIt package that is a link": python(
        "from moveit_configs_utils import MoveItConfigsBuilder\ndef generate_launch_description():\n"
        "    c = MoveItConfigsBuilder('r', package_name='known').to_moveit_configs()\n"
        "    return LaunchDescription([Node(package='moveit_ros_move_group', executable='move_group',\n"
        "        parameters=[c.to_dict()])])",
        {"known": "{home}"},
    ),
    # -- files that are read because of their place
    **{
        f"{name} that is a link": Hostile({}, {name: f"{{home}}/{target}"})
        for name, target in {
            "package.xml": "package.xml",
            "CMakeLists.txt": "CMakeLists.txt",
            "setup.py": "setup.py",
            ".gitignore": ".gitignore",
            ".git/info/exclude": ".gitignore",
            "r.srdf": f"{CANARY}.srdf",
            "other.urdf": f"{CANARY}.urdf",
            "other.yaml": f"{CANARY}.yaml",
            "other.launch": f"{CANARY}.launch",
            "plugins.xml": f"{CANARY}.urdf",
            "config": "config",
            "launch": "launch",
            "urdf": "",
            "src": "",
            "models": "",
            "meshes": "",
            "srdf": "config",
            "sub/package.xml": "package.xml",
        }.items()
    },
    "the files of MoveIt are links": Hostile(
        {"r.srdf": '<robot name="r"/>\n', "moveit_controllers.yaml": "a: 1\n"},
        dict.fromkeys(("kinematics.yaml", "joint_limits.yaml", "x_planning.yaml"), "{home}/known.yaml"),
    ),
    "the listed joints are a link": Hostile({"urdf/r.xacro": ROBOT}, {"config": "{home}"}, READING[:5]),
    "a build installs files from elsewhere": build(
        "install(FILES {home}/known.urdf ../home/known.urdf DESTINATION share/pull)"
    ),
    "a setup.py lists files from elsewhere": Hostile(
        {
            "setup.py": "from glob import glob\nfrom setuptools import setup\nsetup(name='pull', data_files=["
            "('share/pull/a', glob('../home/*')), ('share/pull/b', glob('{home}/*')), ('share/pull', glob('l*/*'))])\n",
            "r.xacro": XACRO.format('<xacro:include filename="$(find pull)/a/known.urdf"/>'),
        },
        {"l": "{home}"},
    ),
    "a package exports plugins from elsewhere": build(
        "pluginlib_export_plugin_description_file(controller_interface ../home/known.urdf)",
        **{
            "package.xml": MANIFEST.format("pull").replace(
                "<export>", '<export><x plugin="${prefix}/../home/known.urdf"/>'
            )
        },
    ),
    "a package generates parameters from elsewhere": build(
        "generate_parameter_library(parameters ../home/known.yaml)\n"
        "pluginlib_export_plugin_description_file(controller_interface plugins.xml)",
        **{"plugins.xml": PLUGIN, "own.hpp": CODE},
    ),
    # -- generated files
    "a generated file names a list of joints": made("gen-controllers {home}/known.csv --type effort --distro jazzy"),
    "a generated file names it by a relative path": made(
        "gen-controllers ../home/known.csv --type effort --distro jazzy"
    ),
    "a generated file names it by a link": made(
        "gen-controllers l.csv --type effort --distro jazzy", {"l.csv": "{home}/known.csv"}
    ),
    "a generated file names it behind an option": made(
        "gen-controllers --type effort {home}/known.csv --distro jazzy", said=OUTSIDE
    ),
    "a generated file names a misspelt robot": made(
        "gen-controllers --type effort {home}/CANARY5f1.urdf --distro jazzy", said=OUTSIDE
    ),
    "a generated file names a folder": made("gen-all --type effort {home} --distro jazzy", said=OUTSIDE),
    "a generated file names a robot to convert": made("convert {home}/known.urdf --to mjcf"),
    **{
        f"a generated file sets {word.split()[0]}": made(f"gen-controllers r.xacro --type effort {word} --distro jazzy")
        for word in (
            "--templates {home}",
            "-templates={home}",
            "--package-path {home}",
            "--workspace /",
            "--config={home}/urdfctl.toml",
            "--into {home}/known.urdf",
            "--env CANARY_VARIABLE",
            "-trust",
            "--timeout 9999",
            "--memory 99999",
        )
    },
    # -- what is kept in the repository
    "a baseline names files": Hostile(
        {
            "baseline.json": '{"version": 1, "tool": "urdfctl", "findings": [\n'
            '{"code": "UC101", "file": "{home}/.netrc", "message": "x", "mark": "0", "times": 1},\n'
            '{"code": "UC101", "file": "../home/none", "message": "y", "mark": "1", "times": 1}\n]}\n'
        },
        words=[("lint", ".", "--baseline", "baseline.json")],
    ),
    "a log names files": Hostile(
        {
            "x.log": "[ERROR] [1.0]: Could not open file {home}/known.urdf\n"
            "[ERROR] [1.0]: material 'x' is not unique. file://{home}/known.stl\n  File \"{home}/known.py\", line 1\n"
        },
        words=[("explain", "x.log"), ("explain", "x.log", "--in", ".")],
    ),
}


def laid_out(folder: Path, files: Mapping[str, str], links: Mapping[str, str], home: Path) -> None:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.replace("{home}", str(home)), encoding="utf-8")
    for name, target in links.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        path.symlink_to(target.replace("{home}", str(home)).rstrip("/"))
