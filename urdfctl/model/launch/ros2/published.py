"""What the launch files of urdf_launch start: robot_state_publisher, with the description that their arguments name."""

from __future__ import annotations

import os

from urdfctl.model.launch.ros2.simulators import package_outside
from urdfctl.source.launch.terms import Called, Constant, Items, Table, Term
from urdfctl.source.span import Place

_PACKAGE = "urdf_launch"
_FILES = ("display.launch.py", "description.launch.py")
_PUBLISHER = "robot_state_publisher"


def publisher_of(path: str, given: Table | None, at: Place) -> Called | None:
    """Return the node that an included launch file starts to publish a description; None if it is another file.

    ros/urdf_launch launch/description.launch.py, which display.launch.py includes: `xacro` of `urdf_package_path` in
    `urdf_package`.

    given: the arguments of the launch file.
    """
    names = ("urdf_package", "urdf_package_path")
    entries = given.entries if given else {}
    if package_outside(path) != _PACKAGE or os.path.basename(path) not in _FILES or not all(map(entries.get, names)):
        return None
    package, file = (entries[name] for name in names)
    folder = Called("launch_ros.substitutions.FindPackageShare", package.at, [package])
    whole = Called("launch.substitutions.PathJoinSubstitution", file.at, [Items([folder, file], file.at)])
    table = Table(at)
    command = Items([Constant("xacro ", file.at), whole], file.at)
    made = Called("launch.substitutions.Command", file.at, [command])
    value = Called("launch_ros.parameter_descriptions.ParameterValue", at, [made], {"value_type": Constant("str", at)})
    table.put(Constant("robot_description", at), value)
    words: dict[str, Term] = {"package": Constant(_PUBLISHER, at), "executable": Constant(_PUBLISHER, at)}
    return Called("Node", at, (), {**words, "parameters": Items([table], at)})
