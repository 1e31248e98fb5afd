"""What starts a robot: the launch file, and the package that holds it all."""

from __future__ import annotations

import shlex
from collections.abc import Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import since
from urdfctl.errors import UserError
from urdfctl.generate.hardware import hardware, host
from urdfctl.generate.options import File, Options
from urdfctl.generate.parameters import Controller
from urdfctl.generate.templates import Templates

FORMS = {"python": "launch.py", "xml": "launch.xml", "yaml": "launch.yaml"}
_ONE_A_SPAWNER = ("foxy", "galactic")


def launch_file(made: Sequence[Controller], options: Options, templates: Templates, model: str) -> File:
    """The launch file of some controllers, the first of which is started first."""
    if options.form not in FORMS:
        raise UserError(f"--form is one of {', '.join(FORMS)}; not '{options.form}'")
    ending = FORMS[options.form] if options.ros == 2 else "launch"  # noqa: PLR2004
    name, space = f"control.{ending}", options.namespace
    names = [one.name for one in made]
    text = templates.render(
        f"launch/ros2.{ending}" if options.ros == 2 else "launch/ros1.launch",  # noqa: PLR2004
        command=options.command,
        file=name,
        package=options.package or "my_robot_control",
        robot_file=options.description or "urdf/robot.urdf.xacro",
        arguments=_arguments(options),
        controllers_file=options.controllers_file,
        simulated=options.simulated,
        simulator=options.simulator,
        namespace=space,
        prefix=f"/{space}/" if space else "",
        model=model,
        controllers=names,
        spawned=_spawned(names, options),
        spawner=spawner(options.distro),
        manager_option="--controller-manager",
        manager=f"/{space}/controller_manager" if space else "/controller_manager",
        param_file=takes_param_file(options.distro),
        description=_description(options.distro),
        gz=_gz(options.distro),
    )
    return File(f"launch/{name}", text)


def _arguments(options: Options) -> str:
    """What xacro is given besides the file, as a shell reads it. UserError where the form cannot hold it."""
    words = [f"{name}:={value}" for name, value in options.arguments]
    quoted = [word for word in words if shlex.quote(word) != word]
    if quoted and options.ros == 2 and options.form != "python":  # noqa: PLR2004
        raise UserError(f"a launch file in {options.form} cannot pass '{quoted[0]}' on; take --form python, or gen-all")
    return "".join(f" {shlex.quote(word)}" for word in words)


def spawner(distro: str) -> str:
    """What the controller manager's spawner is called in ROS 2."""
    return "spawner.py" if distro == "foxy" else "spawner"


def takes_param_file(distro: str) -> bool:
    """Whether the spawner gives a controllers' file to the controllers that it starts."""
    return distro in since("jazzy")


def _spawned(names: list[str], options: Options) -> list[list[str]]:
    """The controllers that each spawner starts."""
    if options.distro in _ONE_A_SPAWNER:
        return [[name] for name in names]
    return [part for part in (names[:1], names[1:]) if part] if options.form == "python" else [names]


def _description(distro: str) -> str:
    """How the controller manager learns the robot: by a `parameter`, by a topic to be `remapped`, or by the `topic`."""
    if distro in _ONE_A_SPAWNER:
        return "parameter"
    return "topic" if distro in since("jazzy") else "remapped"


def _gz(distro: str) -> dict[str, str]:
    """The packages that bring gz to ROS, by the names that they have in a distro."""
    if distro in _ONE_A_SPAWNER:
        names = ("ros_ign_gazebo", "ign_gazebo.launch.py", "ign_args", "ros_ign_bridge", "ignition.msgs")
    else:
        messages = "gz.msgs" if distro in since("jazzy") else "ignition.msgs"
        names = ("ros_gz_sim", "gz_sim.launch.py", "gz_args", "ros_gz_bridge", messages)
    return dict(zip(("package", "launch", "argument", "bridge", "messages"), names, strict=True))


def dependencies(
    made: Sequence[Controller], options: Options, catalog: Catalog, robot_package: str | None
) -> list[str]:
    """The packages that must be there when the robot is started."""
    found = {"controller_manager", "robot_state_publisher", "xacro", *(one.type.package for one in made)}
    if robot_package:
        found.add(robot_package)
    if options.simulator in ("gz", "gazebo-classic"):
        found.add(host(options, catalog).package or "")
        gz = _gz(options.distro)
        found |= {gz["package"], gz["bridge"]} if options.simulator == "gz" else {"gazebo_ros"}
    if options.ros == 2:  # noqa: PLR2004
        package = hardware(options, catalog).package
        found.add("hardware_interface" if package in ("mock_components", "fake_components") else package)
    return sorted(name for name in found if name and name != options.package)


def package_files(depends: Sequence[str], options: Options, templates: Templates, title: str) -> list[File]:
    """The package's manifest, and how it is installed."""
    values = {"command": options.command, "ros": options.ros, "package": options.package, "title": title}
    return [
        File("package.xml", templates.render("package/package.xml", **values, depends=depends)),
        File("CMakeLists.txt", templates.render("package/CMakeLists.txt", **values)),
    ]
