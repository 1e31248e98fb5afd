"""Classes of launch files and of the modules of their packages are followed, as functions are."""

from __future__ import annotations

import pytest
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.load.launch_files import read_launch
from urdfctl.load.loader import Loader
from urdfctl.model.launch import Launch

HEAD = """\
from abc import ABC
from dataclasses import dataclass, field
import dataclasses
from launch import LaunchDescription, Substitution
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def spawn(name):
    return Node(package='controller_manager', executable='spawner', arguments=[name])
"""


def launch(folder: Folder, text: str, module: str = "") -> Launch:
    """The facts of a launch file of the package p, which has a module."""
    files = {"p/package.xml": "<package><name>p</name></package>", "p/p/__init__.py": "", "p/p/parts.py": HEAD + module}
    folder.write({**files, "p/launch/l.launch.py": HEAD + text})
    path = str(folder.path / "p/launch/l.launch.py")
    found = read_launch(path, {}, *Loader(Settings()).reading(path), {}).launch
    assert found is not None
    return found


def names(found: Launch) -> list[str]:
    return [name for spawn in found.spawns for name, _ in spawn.names]


START = "\ndef generate_launch_description():\n    return LaunchDescription([%s])\n"

CLASSES = {
    "static method": (
        "class Parts:\n    @staticmethod\n    def spawner(name, **more):\n        return spawn(name)\n",
        "Parts.spawner('arm', output='screen')",
    ),
    "class method": (
        "class Parts:\n    NAME = 'arm'\n    @classmethod\n    def spawner(cls):\n        return spawn(cls.NAME)\n",
        "Parts.spawner()",
    ),
    "attribute": ("class Parts(object):\n    ARM: str = 'arm'\n", "spawn(Parts.ARM)"),
    "object": (
        (
            "class Part:\n    def __init__(self, name='leg'):\n        self.name = name\n"
            "    def spawner(self):\n        return spawn(self.name)\n"
        ),
        "Part('arm').spawner()",
    ),
    "property": (
        (
            "class Part(ABC):\n    def __init__(self):\n        self.side = 'a'\n"
            "    @property\n    def name(self):\n        return self.side + 'rm'\n"
        ),
        "spawn(Part().name)",
    ),
    "base": (
        (
            "class Base:\n    def name(self):\n        return self.part\n"
            "class Arm(Base):\n    part = 'arm'\n    def spawner(self):\n        return spawn(self.name())\n"
        ),
        "Arm().spawner()",
    ),
    "overridden": (
        "class A:\n    def name(_):\n        return 'leg'\nclass Arm(A):\n    def name(_):\n        return 'arm'\n",
        "spawn(Arm().name())",
    ),
    "dataclass": (
        "@dataclass(frozen=True)\nclass Part:\n    package: str\n    name: str = 'leg'\n",
        "spawn(Part('p', name='arm').name)",
    ),
    "default of a dataclass": (
        "@dataclass()\nclass P:\n    all: list = field(default_factory=list)\n    name: str = field(default='arm')\n",
        "spawn(P().name)",
    ),
    "list of an object": (
        (
            "class Parts:\n    def __init__(self):\n        self.all = []\n    def add(self, name):\n"
            "        self.all.append(spawn(name))\n        return self\n"
        ),
        "*Parts().add('arm').all",
    ),
}


@pytest.mark.parametrize(("classes", "action"), CLASSES.values(), ids=CLASSES)
def test_what_a_class_makes_is_started(classes: str, action: str, folder: Folder) -> None:
    found = launch(folder, classes + START % action)
    assert (names(found), found.complete) == (["arm"], True)


@pytest.mark.parametrize(
    "imported",
    ["from p.parts import Part", "from p import parts\nPart = parts.Part", "import p.parts as q\nPart = q.Part"],
)
def test_a_class_of_an_own_module_is_followed(imported: str, folder: Folder) -> None:
    module = "class Part:\n    @staticmethod\n    def spawner():\n        return spawn('arm')\n"
    assert names(launch(folder, imported + START % "Part.spawner()", module)) == ["arm"]


def test_an_object_may_hold_a_launch_argument(folder: Folder) -> None:
    module = """
class Argument:
    def __init__(self, name, default):
        self.name, self.default = name, default
    def declaration(self):
        return DeclareLaunchArgument(self.name, default_value=self.default)
    def text(self, context):
        return LaunchConfiguration(self.name).perform(context)
"""
    text = """
from p.parts import Argument
controller = Argument("controller", "arm")

def setup(context):
    return [spawn(controller.text(context))]
"""
    found = launch(folder, text + START % "controller.declaration(), OpaqueFunction(function=setup)", module)
    assert (names(found), found.arguments) == (["arm"], (("controller", "arm"),))


UNKNOWN_CLASSES = {
    "base of another package": ("class Part(Substitution):\n    name = 'arm'\n", "spawn(Part.name)"),
    "decorator": ("@register\nclass Part:\n    name = 'arm'\n", "spawn(Part.name)"),
    "decorated method": (
        "class Part:\n    @cached\n    def name(self):\n        return 'arm'\n",
        "spawn(Part().name())",
    ),
    "attribute": ("class Part:\n    pass\n", "spawn(Part().name)"),
    "an object as an action": ("class Part:\n    pass\n", "Part()"),
    "itself without end": ("class Part:\n    def __init__(self):\n        self.next = Part()\n", "spawn(Part().next)"),
}


@pytest.mark.parametrize(("classes", "action"), UNKNOWN_CLASSES.values(), ids=UNKNOWN_CLASSES)
def test_what_is_not_understood_of_a_class_is_unknown(classes: str, action: str, folder: Folder) -> None:
    found = launch(folder, classes + START % action)
    assert "arm" not in names(found)
    assert not found.complete or not all(spawn.complete for spawn in found.spawns)


def test_an_attribute_that_a_condition_sets_is_one_of_both(folder: Folder) -> None:
    text = """
class Part:
    def __init__(self, name):
        self.name = name

def generate_launch_description():
    part = Part('arm')
    if unknown():
        part.name = 'leg'
    return LaunchDescription([spawn(part.name)])
"""
    assert not all(spawn.complete for spawn in launch(folder, text).spawns)
