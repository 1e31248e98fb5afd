"""The options of ros2_control's spawner by distro, and those of the programs that spawn models."""

from __future__ import annotations

from urdfctl.catalog.distros import ROS2, between, since, until

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
    "-n": between("humble", "jazzy"),
    "--namespace": between("humble", "jazzy"),
    "-t": until("iron"),
    "--controller-type": until("iron"),
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
"""The distros whose current release has each option; jazzy lost --controller-type in 4.14 (ros2_control #1639)."""
INSTEAD = {
    "--stopped": "use '--inactive'",
    "-n": "use '--ros-args -r __ns:=/name'",
    "--namespace": "use '--ros-args -r __ns:=/name'",
    "-t": "set the type in the parameter file",
    "--controller-type": "set the type in the parameter file",
}
_POSE = ("x", "y", "z", "R", "P", "Y")
_BY_GFLAGS = ("help", "version", "helpfull", "helpshort", "flagfile", "fromenv", "tryfromenv", "undefok")
_OF_CREATE = ("world", "file", "param", "string", "topic", "name", "allow_renaming", "noallow_renaming", *_POSE)
OF_MODEL_SPAWNERS = {
    "create": (*_OF_CREATE, *_BY_GFLAGS),
    "spawn_entity.py": (
        *("file", "topic", "database", "stdin", "entity", "reference_frame", "gazebo_namespace", "robot_namespace"),
        *("timeout", "unpause", "wait", "spawn_service_timeout", "package_to_model", "b", "h", "help", *_POSE),
    ),
}
"""What can be written behind a hyphen, by program: ros_gz_sim src/create.cpp, gazebo_ros scripts/spawn_entity.py."""
MODEL_SOURCES = {
    "create": ("file", "param", "string", "topic"),
    "spawn_entity.py": ("file", "topic", "database", "stdin"),
    "spawn_model": ("file", "param", "database", "stdin"),
}
"""The options that say what is spawned, by program: one of them is required. The last is of ROS 1."""
