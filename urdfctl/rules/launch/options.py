"""The options of ros2_control's spawner, by distro."""

from __future__ import annotations

from urdfctl.catalog.distros import ROS2, since, until

DISTROS = {
    "-h": ROS2,
    "--help": ROS2,
    "-c": ROS2,
    "--controller-manager": ROS2,
    "-p": ROS2,
    "--param-file": ROS2,
    "--load-only": ROS2,
    "-u": ROS2,
    "--unload-on-kill": ROS2,
    "--controller-manager-timeout": ROS2,
    "-n": ("humble", "iron", "jazzy"),
    "--namespace": ("humble", "iron", "jazzy"),
    "-t": until("jazzy"),
    "--controller-type": until("jazzy"),
    "--stopped": until("humble"),
    "--inactive": since("humble"),
    "--switch-timeout": since("humble"),
    "--service-call-timeout": since("humble"),
    "--activate-as-group": since("humble"),
    "--switch-asap": since("jazzy"),
    "--no-switch-asap": since("jazzy"),
    "--controller-ros-args": since("jazzy"),
    "--controller": since("jazzy"),
}
"""Of some only later releases of a distro have them; those count as having them, as do earlier ones that had."""
INSTEAD = {
    "--stopped": "'--inactive' says the same",
    "-n": "'--ros-args -r __ns:=/name' says the same",
    "--namespace": "'--ros-args -r __ns:=/name' says the same",
    "-t": "the type belongs in the parameters' file",
    "--controller-type": "the type belongs in the parameters' file",
}
