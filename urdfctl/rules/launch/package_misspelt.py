"""UC642."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, SOUND, launched

_OTHER = """
      <node pkg="arm_teleop" exec="teleop"/>"""


@rule(
    "UC642",
    severity=Severity.WARNING,
    runtime="refuses",
    because="the package may be installed",
    authority="roslaunch substitution_args.py _find(): rospkg ResourceNotFound; launch_ros FindPackageShare: "
    "\"package 'amr' not found, searching: ...\"",
    bad=[
        launched(PUBLISHER.replace("(find-pkg-share arm)", "(find-pkg-share «armm»)", 1), MANAGER, BROADCASTER, ARM),
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM.replace('"controller_manager"', '"«contoller_manager»"')),
    ],
    good=[SOUND, launched(PUBLISHER, MANAGER, BROADCASTER, ARM, _OTHER)],
)
def package_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt package in a launch file.

    The package is not in the workspace, package.xml does not declare it, and a package of the workspace, or one that many
    launch files use, has almost the same name. The launch stops there if no such package is installed. One letter wrong
    in the name of the own package, or of one that package.xml declares, is an error.
    """
    for word, meant in project.launch.misspelt if project.launch else ():
        message = f"package '{word.text}' was not found; did you mean '{meant}'?"
        at, text = word.at, word.at.span.text
        start = text.find(word.text)
        if start >= 0 and text.count(word.text) == 1:
            at = at.part(word.text)
        package = project.launch.package if project.launch else None
        own = {package.name, *package.dependencies} if package is not None else set()
        severity = Severity.ERROR if meant in own else None
        yield Finding(at, message, fix=replaced(at, word.text, meant, safe=severity is not None), severity=severity)
