"""UC609."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, in_words
from urdfctl.control.parameters.spawner_options import DISTROS, INSTEAD
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.launch.common import ROS_2, is_spawner, launch_of, spawners
from urdfctl.rules.launch_samples import BROADCASTER, FILE, MANAGER, PUBLISHER, SOUND, launched, spawner


@rule(
    "UC609",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control spawner.py: argparse ends the program where it does not know an option: 'unrecognized "
    "arguments'; the options of each distro's branch",
    bad=[launched(PUBLISHER, MANAGER, BROADCASTER, spawner(f"arm_controller «--controller_manager» /cm {FILE}"))],
    good=[SOUND],
)
def spawner_option_unknown(project: Project) -> Iterator[Finding]:
    """Unknown option of the spawner.

    The spawner exits at once and loads nothing. Some options were removed over time. `--stopped` is now `--inactive`,
    the controller's type comes from its parameters, and its namespace is that of the spawner node.
    """
    launch = launch_of(project, ROS_2)
    for spawn in spawners(launch) if launch else ():
        for option in spawn.options if is_spawner(spawn) else ():
            name = option.name
            begun = [known for known in DISTROS if name.startswith("--") and known.startswith(name)]
            has = {distro for known in ([name] if name in DISTROS else begun) for distro in DISTROS[known]}
            lacking = [distro for distro in project.distros if distro not in has]
            if not is_known(name) or not lacking or name.lstrip("-")[:1].isdigit():
                continue
            if len(lacking) == len(project.distros):
                meant = nearest(name, [known for known in DISTROS if known.startswith("--")])
                hint = f"; {INSTEAD[name]}" if name in INSTEAD else f"; did you mean '{meant}'?" if meant else ""
                fix = replaced(option.at, name, meant) if meant and name not in DISTROS else None
                yield Finding(option.at, f"the spawner has no option '{name}'{hint}", (), fix)
            elif name in INSTEAD and lacking[-1] == project.distros[-1]:
                message = f"the spawner has no option '{name}' in {in_words(lacking)}; {INSTEAD[name]}"
                fix = replaced(option.at, name, "--inactive") if name == "--stopped" else None
                yield Finding(option.at, message, (), fix, Severity.WARNING)
