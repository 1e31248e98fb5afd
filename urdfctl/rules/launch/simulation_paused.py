"""UC612."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, launch_of
from urdfctl.rules.launch_samples import ARM, BROADCASTER, PUBLISHER, SOUND, launched

_HOW = {"gz": "Add '-r' to gz_args", "gazebo-classic": "Set 'pause' to 'false'"}


@rule(
    "UC612",
    runtime="refuses",
    because="it goes on when someone presses play",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="gz sim --help: '-r: Run simulation on start'; ros2_control: 'Switch controller timed out after 5.000000 "
    "seconds!' (gz_ros2_control#421)",
    bad=[
        launched(PUBLISHER, '\n      «<executable cmd="gz sim empty.sdf"/>»', BROADCASTER, ARM),
        launched(
            PUBLISHER,
            """
      «<include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py">»<arg name="pause" value="true"/></include>""",
            BROADCASTER,
        ),
    ],
    good=[SOUND],
)
def simulation_paused(project: Project) -> Iterator[Finding]:
    """Simulation is started paused, but controllers are spawned in it.

    In a paused simulation time does not advance, and the plugin's controller manager is not updated. Nothing can be
    activated before someone presses play: the request waits, and the spawner gives up after five seconds.
    """
    launch = launch_of(project, ROS_2)
    if launch is None:
        return
    waiting = [spawn for spawn in launch.spawns if spawn.sure and spawn.active and not spawn.option("--switch-timeout")]
    for simulation in launch.simulations:
        if simulation.paused and simulation.sure and waiting:
            message = (
                f"the simulation is started paused, so no controller can be activated. {_HOW[simulation.simulator]}"
            )
            yield Finding(simulation.at, message, (Note("controllers are spawned here", waiting[0].at),))
