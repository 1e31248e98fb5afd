"""The install rule of the file for ros_gz_bridge, and what is said of one that no launch file hands to a bridge."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE, in_setup, install_rule, installs
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.workspaces.install_maps import read_install_map
from urdfctl.source.workspaces.packages import package_name
from urdfctl.source.workspaces.setup_files import is_plain_setup

_AUTHORITY = "ros_gz_bridge README: config_file"
_IDLE = "no launch file starts a bridge with this file: start parameter_bridge with it as config_file"


def _installed(packages: MigratedPackages) -> Iterator[Proposal]:
    """Install the file for the bridge with its package, unless a rule does."""
    for path in packages.files(BRIDGE_FILE) if goes_to_gz(packages) else ():
        folder = os.path.dirname(os.path.dirname(path))
        edit = _rule(packages, folder) or _in_setup(packages, folder)
        if edit is not None:
            file = edit.span.source.path
            entry = ReportEntry(EntryKind.DONE, f"{BRIDGE_FILE} is installed", file=file, authority=_AUTHORITY)
            yield Proposal((edit,), entries=(entry,))
        if _is_idle(packages, path):
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, _IDLE, file=path, authority=_AUTHORITY),))


def _rule(packages: MigratedPackages, folder: str) -> Edit | None:
    """The edit that adds an install rule to the CMakeLists.txt of a package that has none for the file."""
    source = packages.read(os.path.join(folder, "CMakeLists.txt"))
    at = source.data.rfind(b"ament_package(")
    if at < 0 or installs(source.data.decode("utf-8", "surrogateescape"), os.path.dirname(BRIDGE_FILE)):
        return None
    return Edit(SourceSpan(source, at, at), f"{install_rule(os.path.dirname(BRIDGE_FILE))}\n")


def _in_setup(packages: MigratedPackages, folder: str) -> Edit | None:
    """The edit of the setup.py of a package that surely does not install the file."""
    name = package_name(os.path.join(folder, "package.xml")) or ""
    source = packages.read(os.path.join(folder, "setup.py"))
    is_known = bool(name) and is_plain_setup(source.data.decode("utf-8", "surrogateescape"), name)
    if not is_known or read_install_map(folder, name).source_of(BRIDGE_FILE) is not None:
        return None
    return in_setup(source, name, [BRIDGE_FILE])


def _is_idle(packages: MigratedPackages, path: str) -> bool:
    """Whether launch files start gz or robots in it, and none hands a file for the bridge to a bridge."""
    folder = os.path.dirname(os.path.dirname(path))
    name = (package_name(os.path.join(folder, "package.xml")) or "").encode()
    texts = [packages.read(each).data for each in packages.files(".py", ".xml", ".launch")]
    starts = [text for text in texts if b"ros_gz_sim" in text and b"launch" in text]
    return bool(starts and name) and not any(name in text and BRIDGE_FILE.encode() in text for text in texts)


BRIDGE_INSTALL = Step(
    "bridge-install",
    Part.MANIFEST,
    "The install rule of the file for ros_gz_bridge",
    _installed,
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "config/bridge.yaml": """
                - ros_topic_name: scan
                  gz_topic_name: scan
                  ros_type_name: sensor_msgs/msg/LaserScan
                  gz_type_name: gz.msgs.LaserScan
                  direction: GZ_TO_ROS
            """,
            "CMakeLists.txt": """
                project(arm)
                find_package(ament_cmake REQUIRED)
                install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
                ament_package()
            """,
        },
    ],
    after=[
        {
            "CMakeLists.txt": """
                project(arm)
                find_package(ament_cmake REQUIRED)
                install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
                install(DIRECTORY config
                  DESTINATION share/${PROJECT_NAME}
                )

                ament_package()
            """,
        },
    ],
)
