"""UC608."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced, severity_where
from urdfctl.rules.launch.common import ROS_2, launch_of, spawners
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, SOUND, launched, spawner

_GONE = {
    "spawner.py": (since("humble"), "spawner"),
    "unspawner.py": (since("humble"), "unspawner"),
    "load_start_controller": (since("galactic"), "load_controller --set-state active"),
    "load_configure_controller": (since("galactic"), "load_controller --set-state inactive"),
}
"""Programs and verbs, the distros that no longer have them, and their names there."""


@rule(
    "UC608",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("galactic"),
    options=("--distro=humble",),
    authority="ros2_control controller_manager/setup.cfg: console_scripts spawner, unspawner; galactic: ''spawner.py' is "
    "deprecated, please use 'spawner' (without .py extension)'; ros2controlcli: verbs of foxy",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER.replace('"spawner"', '"«spawner.py»"'), ARM),
        launched(
            PUBLISHER,
            MANAGER,
            spawner("arm_controller", "«unspawner.py»"),
            """
      <executable cmd="ros2 control «load_start_controller» joint_state_broadcaster"/>
      <executable cmd="ros2 control «load_configure_controller» arm_controller"/>""",
        ),
    ],
    good=[SOUND],
)
def spawner_program_gone(project: Project) -> Iterator[Finding]:
    """Launch file calls a foxy program that loads controllers.

    spawner.py was renamed to spawner in galactic, and is no longer installed since humble: the launch stops with
    'executable not found'. Since galactic, one verb of `ros2 control` with an option replaces the two verbs of foxy.
    """
    launch = launch_of(project, ROS_2)
    if launch is None:
        return
    programs = [spawn.program for spawn in spawners(launch) if spawn.program is not None]
    programs += [node.executable for node in launch.nodes if node.executable.text == "unspawner.py"]
    for program in programs:
        gone, became = _GONE.get(program.text, ((), ""))
        if set(gone) & set(project.distros):
            message = f"'{program.text}' does not exist in {gone[0]} and later; use '{became}'"
            fix = replaced(program.at, program.text, became)
            known = set(project.distros) != set(ROS2)
            yield Finding(program.at, message, (), fix, severity_where(project, gone) if known else Severity.WARNING)
