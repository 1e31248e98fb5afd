"""UC616."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import Reference
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.launch.samples import BROADCASTER, MANAGER, PUBLISHER, SOUND, launched, spawner

_NEEDED = ("description", "parameters", "include")


@rule(
    "UC616",
    severity=Severity.ERROR,
    authority="roslaunch: 'file does not exist'; launch: 'The following exception occurred ... No such file or directory'; "
    "rcl: 'Error opening YAML file'; xacro: 'No such file or directory'",
    bad=launched(
        PUBLISHER,
        MANAGER,
        BROADCASTER,
        spawner("arm_controller -p «$(find-pkg-share arm)/controler.yaml»"),
    ),
    good=SOUND,
)
def launched_file_missing(project: Project) -> Iterator[Finding]:
    """A launch file names a file that does not exist.

    The launch ends there, or the node that is to read it: the robot's description, a parameter file, or another launch
    file.
    """
    for reference in project.launch.references if project.launch else ():
        if reference.file.exists is False and reference.use in _NEEDED:
            severity = None if reference.sure else Severity.WARNING
            yield Finding(reference.file.at, f"no such file: '{_shown(reference, project)}'", severity=severity)


def _shown(reference: Reference, project: Project) -> str:
    """A file's path, from the package's folder on where it is in that."""
    path = reference.file.path or reference.file.text
    package = project.launch.package if project.launch else None
    if package is None or not path.startswith(f"{package.folder}/"):
        return path
    return f"{package.name}/{path.removeprefix(package.folder).lstrip('/')}"
