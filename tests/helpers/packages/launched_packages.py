"""Findings in whole small packages with launch files."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import dedent

import robots
from folder import Folder

from urdfctl.rules.examples import completed

ALL = ("UC6",)


def found(
    folder: Folder, files: Mapping[str, str], *codes: str, distro: str | None = None, path: str | None = None
) -> list[tuple[str, str, str]]:
    """Return code, severity and message of the findings in the first file and its companions, in order of codes."""
    folder.write({name: completed(name, dedent(text).strip("\n") + "\n") for name, text in files.items()})
    findings = robots.findings(path or next(iter(files)), codes or ALL, workspace=str(folder.path), distro=distro)
    findings.sort(key=lambda finding: (finding.code, finding.order))
    return [(finding.code, finding.severity.value, finding.message) for finding in findings]


def ros1(*nodes: str, controllers: str = "", robot: str = "") -> dict[str, str]:
    """A package of ROS 1 with a launch file of some nodes, which loads controllers."""
    load = '<rosparam file="$(find arm)/controllers.yaml" command="load"/>' if controllers else ""
    return {
        "arm.launch": f"""
            <launch>
              <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
              {load}
              {"".join(nodes)}
            </launch>
        """,
        "arm.urdf": robot,
        "package.xml": "<package><name>arm</name></package>",
        **({"controllers.yaml": controllers} if controllers else {}),
    }
