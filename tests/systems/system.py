"""A system: robots with their controllers, what runs them, and what is wrong in it, if anything."""

from __future__ import annotations

from dataclasses import dataclass

GZ, CLASSIC = "gz", "gazebo-classic"
BROADCASTER, TRAJECTORY, GROUP, FORWARD, DRIVE = "broadcaster", "trajectory", "group", "forward", "drive"


@dataclass(frozen=True)
class Joint:
    """A joint that moves.

    name: without the prefix of its robot.
    kind: "revolute", "continuous" or "prismatic".
    commands: its command interfaces.
    parent: the joint whose link it moves on; empty for the base.
    """

    name: str
    kind: str
    commands: tuple[str, ...]
    parent: str = ""


@dataclass(frozen=True)
class Controller:
    """A controller that the parameters declare.

    family: what it does; the type follows from it, from its interface and from the generation of ROS.
    joints: without the prefix of its robot.
    interface: the command interface that it claims of each joint; empty for a broadcaster.
    typed: whether its type is written.
    """

    name: str
    family: str
    joints: tuple[str, ...] = ()
    interface: str = ""
    typed: bool = True


@dataclass(frozen=True)
class Spawn:
    """A controller that is spawned, active or not."""

    name: str
    active: bool = True


@dataclass(frozen=True)
class Robot:
    """A robot that is started.

    name: of the robot, and of its files.
    model: of the description; several robots may share it.
    prefix: before the names of its links and joints.
    namespace: of all its nodes, without slashes; empty for the root.
    manager: the name of its controller manager.
    section: the namespace that its parameters are written for; that of the robot if nothing is wrong.
    asked: the name of the manager that its spawners ask; that of its manager if nothing is wrong.
    """

    name: str
    model: str
    joints: tuple[Joint, ...]
    controllers: tuple[Controller, ...]
    spawned: tuple[Spawn, ...]
    prefix: str = ""
    namespace: str = ""
    manager: str = "controller_manager"
    section: str = ""
    asked: str = "controller_manager"

    def controller(self, name: str) -> Controller | None:
        """Return the declared controller of a name."""
        return next((one for one in self.controllers if one.name == name), None)

    @property
    def active(self) -> tuple[Controller, ...]:
        """The declared controllers that are spawned active."""
        found = (self.controller(spawn.name) for spawn in self.spawned if spawn.active)
        return tuple(one for one in found if one is not None)


@dataclass(frozen=True)
class Fault:
    """A planted inconsistency.

    kind: what is wrong, as in `faults.FAULTS`.
    names: what a finding has to name, one of them: the joint, controller, manager or section.
    touched: what else findings may name that follow from it.
    """

    kind: str
    names: tuple[str, ...]
    touched: tuple[str, ...] = ()


@dataclass(frozen=True)
class System:
    """Robots that are started, and what runs them.

    generation: of ROS, 1 or 2.
    simulator: that runs the controllers; empty for real or mock hardware.
    moveit: whether the robot is started by MoveIt's demo.
    """

    seed: int
    generation: int
    distro: str
    simulator: str
    robots: tuple[Robot, ...]
    moveit: bool = False
    fault: Fault | None = None

    @property
    def is_simulated(self) -> bool:
        """Whether a simulator runs the controllers."""
        return bool(self.simulator)

    @property
    def is_fleet(self) -> bool:
        """Whether it has several robots."""
        return len(self.robots) > 1


_SINGLE = {
    "position": "JointPositionController",
    "velocity": "JointVelocityController",
    "effort": "JointEffortController",
}


def type_of(controller: Controller, generation: int) -> str:
    """Return the type of a controller."""
    first, interface = generation == 1, controller.interface
    if controller.family == BROADCASTER:
        return (
            "joint_state_controller/JointStateController" if first else "joint_state_broadcaster/JointStateBroadcaster"
        )
    if controller.family == TRAJECTORY:
        return f"{f'{interface}_controllers' if first else 'joint_trajectory_controller'}/JointTrajectoryController"
    if controller.family == FORWARD:
        single = f"{interface}_controllers/{_SINGLE[interface]}"
        return single if first else "forward_command_controller/ForwardCommandController"
    if controller.family == DRIVE:
        return "diff_drive_controller/DiffDriveController"
    return f"{interface}_controllers/{_SINGLE[interface].replace('Joint', 'JointGroup')}"
