"""Launch files in Python use modules and YAML files of their own workspace, which are read and never run."""

from __future__ import annotations

from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.load.launch_files import read_launch
from urdfctl.load.loader import Loader
from urdfctl.model.launch import Launch

PACKAGE = {
    "p/package.xml": "<package><name>p</name></package>",
    "p/p/__init__.py": "DEFAULT = 'arm'\n",
    "p/p/common/spawning.py": """\
from launch.actions import GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from ..more import names

def spawn(name):
    return Node(package='controller_manager', executable='spawner', arguments=[name])

def spawn_all(context):
    return [spawn(name) for name in names()] + [spawn(LaunchConfiguration('extra').perform(context))]

undefined_function()
""",
    "p/p/more.py": "def names():\n    return ['one', 'two']\n",
    "p/config/names.yaml": "controllers: [jsb, 'hand']\nrate: 100\n",
}


def launch(folder: Folder, body: str) -> Launch:
    """The facts of a launch file of the package p whose function has a body."""
    lines = "".join(f"    {line.strip()}\n" for line in body.strip().splitlines())
    text = f"from launch import *\nfrom p.common.spawning import spawn, spawn_all\n{IMPORTS}\n{FUNCTION}{lines}"
    folder.write({**PACKAGE, "p/launch/l.launch.py": text})
    path = str(folder.path / "p/launch/l.launch.py")
    found = read_launch(path, {}, *Loader(Settings()).reading(path), {}).launch
    assert found is not None
    return found


IMPORTS = "import os, yaml, p\nfrom ament_index_python.packages import get_package_share_directory"
FUNCTION = "def generate_launch_description():\n"


def names(found: Launch) -> list[str]:
    return [name for spawn in found.spawns for name, _ in spawn.names]


def test_functions_of_an_own_package_are_followed(folder: Folder) -> None:
    assert names(launch(folder, "return LaunchDescription([spawn('arm')])")) == ["arm"]


def test_constants_of_an_own_package_are_known(folder: Folder) -> None:
    assert names(launch(folder, "return LaunchDescription([spawn(p.DEFAULT)])")) == ["arm"]


def test_an_own_function_with_the_launch_context_imports_others(folder: Folder) -> None:
    body = """
    declared = DeclareLaunchArgument('extra', default_value='three')
    return LaunchDescription([declared, OpaqueFunction(function=spawn_all)])
    """
    assert names(launch(folder, body)) == ["one", "two", "three"]


def test_names_are_read_from_a_yaml_file(folder: Folder) -> None:
    body = """
    path = os.path.join(get_package_share_directory('p'), 'config', 'names.yaml')
    with open(path) as file: content = yaml.safe_load(file)
    return LaunchDescription([spawn(name) for name in content['controllers']])
    """
    made = launch(folder, body)
    assert names(made) == ["jsb", "hand"]


def test_modules_that_are_missing_or_import_each_other_are_unknown(folder: Folder) -> None:
    folder.write({"p/p/a.py": "from p.b import x\ny = 1\n", "p/p/b.py": "from p.a import y\nx = y\n"})
    assert not launch(folder, "from p.a import x\nfrom q.z import w\nreturn LaunchDescription([w(x)])").complete
