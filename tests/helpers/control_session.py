"""Build a controller manager session from parts of a small arm and a controller file."""

from __future__ import annotations

from urdfctl.control.lifecycle import Life, lives
from urdfctl.control.session import Session, session_of
from urdfctl.model.controllers.build_controllers import Loaded, controllers_of
from urdfctl.model.project import Project
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.rules.examples import completed
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.tree import read_yaml

POSITION = '<command_interface name="position"/>'
VELOCITY = '<command_interface name="velocity"/>'
STATES = '<state_interface name="position"/><state_interface name="velocity"/>'


def component(inside: str, plugin: str = "mock_components/GenericSystem", kind: str = "system") -> str:
    """Return a `<ros2_control>` element."""
    return (
        f'<ros2_control name="hw" type="{kind}"><hardware><plugin>{plugin}</plugin></hardware>{inside}</ros2_control>'
    )


def joint(name: str, interfaces: str = POSITION + STATES) -> str:
    """Return a joint of a component."""
    return f'<joint name="{name}">{interfaces}</joint>'


ARM = component(joint("shoulder") + joint("elbow"))


def transmission(name: str, interface: str = "PositionJointInterface") -> str:
    """Return a ROS 1 transmission."""
    return f"""
        <transmission name="{name}_trans">
          <type>transmission_interface/SimpleTransmission</type>
          <joint name="{name}"><hardwareInterface>hardware_interface/{interface}</hardwareInterface></joint>
          <actuator name="{name}_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
        </transmission>
    """


def session(
    part: str, yaml: str = "", distro: str = "jazzy", started: tuple[str, ...] | None = None, *, in_order: bool = False
) -> Session:
    """Return the session of a distro's controller manager for the arm with a part added to it.

    The arm has the links base, upper and fore, and the joints shoulder and elbow.
    """
    tree = parse(SourceText("/robot.urdf", completed("robot.urdf", part).encode()))
    root = tree.documentElement
    assert root is not None
    ros = 1 if distro in ("kinetic", "melodic", "noetic") else 2
    controllers = controllers_of([Loaded(read_yaml(SourceText("/c.yaml", yaml.encode())))], ros, started)
    project = Project(robot_of(root), distro=distro, distros=(distro,), started=started, controllers=controllers)
    project = project._replace(in_order=in_order)
    return session_of(project, distro)


def stops(life: Life) -> list[str]:
    """Return the reasons why a controller does not start, in short."""
    return [
        f"{stop.stage.value} {stop.reason.name} {stop.claim.name if stop.claim else ''}".strip() for stop in life.stops
    ]


def ways(session: Session) -> dict[str, list[str]]:
    """Return the reasons why each controller does not start, by controller."""
    return {life.controller.name: stops(life) for life in lives(session)}
