"""The file for ros_gz_bridge, which is found by launch files that start the bridge."""

from __future__ import annotations

import os

from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE
from urdfctl.source.workspaces.packages import package_around, package_name


def bridge_file_of(packages: MigratedPackages, launch: str) -> str | None:
    """Return the package with the file for the bridge: that of a launch file, or the only other one; None if none."""
    found = [path for path in packages.files("bridge.yaml") if path.endswith(BRIDGE_FILE)]
    own = package_around(os.path.dirname(launch)) or ""
    beside = [path for path in found if path.startswith(own + os.sep)]
    chosen = beside or found
    folder = package_around(os.path.dirname(chosen[0])) if len(chosen) == 1 else None
    return package_name(os.path.join(folder, "package.xml")) if folder else None
