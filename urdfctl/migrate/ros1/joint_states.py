"""The controller of joint states that ROS 1's package joint_state_controller declares in a file of its own."""

from __future__ import annotations

from urdfctl.migrate.packages import MigratedPackages

DECLARED_IN = "$(find joint_state_controller)/joint_state_controller.yaml"
OLD_NAME = "joint_state_controller"
NEW_NAME = "joint_state_broadcaster"


def loads_declaration(packages: MigratedPackages) -> bool:
    """Return whether a launch file loads the file of the package, which ROS 2 does not have."""
    return any(DECLARED_IN.encode() in packages.read(path).data for path in packages.files(".launch", ".xml"))
