"""A session of a controller manager, made of a part of a small arm and of controllers' YAML."""

from __future__ import annotations

from urdfctl.control.life import Life, lives
from urdfctl.control.session import Session, session_of
from urdfctl.model.build_controllers import Loaded, controllers_of
from urdfctl.model.build_robot import robot_of
from urdfctl.model.project import Project
from urdfctl.rules.examples import completed
from urdfctl.source.span import SourceText
from urdfctl.source.xml import parse
from urdfctl.source.yaml import read_yaml

POSITION = '<command_interface name="position"/>'
VELOCITY = '<command_interface name="velocity"/>'
STATES = '<state_interface name="position"/><state_interface name="velocity"/>'


def component(inside: str, plugin: str = "mock_components/GenericSystem", kind: str = "system") -> str:
    """A `<ros2_control>` tag."""
    return (
        f'<ros2_control name="hw" type="{kind}"><hardware><plugin>{plugin}</plugin></hardware>{inside}</ros2_control>'
    )


def joint(name: str, interfaces: str = POSITION + STATES) -> str:
    """A joint of a component."""
    return f'<joint name="{name}">{interfaces}</joint>'


ARM = component(joint("shoulder") + joint("elbow"))


def transmission(name: str, interface: str = "PositionJointInterface") -> str:
    """A transmission of ROS 1."""
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
    """What a distro's manager makes of the arm (links base, upper and fore, joints shoulder and elbow) with a part."""
    tree = parse(SourceText("/robot.urdf", completed("robot.urdf", part).encode()))
    root = tree.documentElement
    assert root is not None
    ros = 1 if distro in ("kinetic", "melodic", "noetic") else 2
    controllers = controllers_of([Loaded(read_yaml(SourceText("/c.yaml", yaml.encode())))], ros, started)
    project = Project(robot_of(root), distro=distro, distros=(distro,), started=started, controllers=controllers)
    project = project._replace(in_order=in_order)
    return session_of(project, distro)


def stops(life: Life) -> list[str]:
    """What stops a controller, in short."""
    return [f"{s.stage.value} {s.reason.name} {s.claim.name if s.claim else ''}".strip() for s in life.stops]


def ways(made: Session) -> dict[str, list[str]]:
    """What stops each controller."""
    return {life.controller.name: stops(life) for life in lives(made)}
