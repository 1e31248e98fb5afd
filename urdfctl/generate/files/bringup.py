"""Generate the files that start a robot: the launch file, and the package around it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import since
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.files.hardware import hardware, host
from urdfctl.generate.files.launch_arguments import (
    NAMESPACE,
    Argument,
    arguments_of_robot,
    arguments_of_simulator,
    namespace_argument,
    passed,
)
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.generate.text.scalars import python_text, xml_text
from urdfctl.generate.text.templates import Templates
from urdfctl.startup.records import NamedTuple


class Spawner(NamedTuple):
    """The controllers that one spawner loads, and its further options."""

    names: list[str]
    options: list[str] = []


FORMS = {"python": "launch.py", "xml": "launch.xml", "yaml": "launch.yaml"}
_ONE_A_SPAWNER = ("foxy", "galactic")
_PACKAGES = {"control_filters": "control_toolbox"}
"""The packages of plugins whose names begin with something else."""
_NAMED = re.compile(r"(?:package://|\$\(find )\s*([A-Za-z0-9_-]+)")
"""A package whose files a robot uses."""


def launch_file(
    made: Sequence[GeneratedController],
    options: GeneratorOptions,
    templates: Templates,
    robot: RobotFacts,
    *,
    movable: bool,
) -> File:
    """Return the launch file that starts the controllers, in this order. UserError if the options do not fit.

    movable: True if the namespace is an argument of the launch file.
    """
    if options.form not in FORMS:
        raise UserError(f"--form must be one of {', '.join(FORMS)}, not '{options.form}'")
    name, space = launch_name(options), options.namespace
    of_robot = arguments_of_robot(options, robot)
    own = [namespace_argument(options, robot)] if movable else []
    hosted = options.simulator in ("gz", "gazebo-classic")
    to_xacro = [*of_robot, *(own if hosted or NAMESPACE in robot.arguments else ())]
    names = [controller.name for controller in made if not controller.waits]
    generated = options.package or "my_robot_control", options.controllers_file
    controllers_package, controllers_file = (robot.own_file if options.own else None) or generated
    text = templates.render(
        f"launch/ros{options.ros}.{name.partition('.')[2]}",
        command=options.command,
        file=options.launch or name,
        package=generated[0],
        robot_file=options.description or "urdf/robot.urdf.xacro",
        arguments=[
            *of_robot,
            *own,
            *_model_argument(options, robot),
            *arguments_of_simulator(options, robot, movable=movable),
        ],
        of_robot=to_xacro,
        passed_xml=passed(to_xacro, "var"),
        passed_ros1=passed(to_xacro, "arg"),
        controllers_package=controllers_package,
        controllers_file=controllers_file,
        simulated=options.simulated,
        simulator=options.simulator,
        movable=movable,
        space=space,
        **_namespaces(options, robot, movable=movable),
        controllers=names,
        spawned=[*_spawned(names, options), *_waiting(made, options)],
        waiting=[controller.name for controller in made if controller.waits],
        spawner=spawner(options.distro),
        manager_option="--controller-manager",
        manager="controller_manager" if movable else f"{'/' * bool(space)}{space}/controller_manager",
        param_file=takes_param_file(options.distro) and not (options.own and robot.own_file is None),
        description=_description(options.distro),
        gz=gz_names(options.distro),
        model_path=_model_path(options),
        mesh_packages=robot.mesh_packages if options.distro in since("humble") else (),
    )
    return File(f"launch/{name}", text)


def _model_argument(options: GeneratorOptions, robot: RobotFacts) -> list[Argument]:
    """ROS 1 has no expression for the robot's name in the simulator that all of its distros read: it is an argument."""
    if options.ros == 2 or not options.simulated:  # noqa: PLR2004
        return []
    name = options.namespace or robot.name or "robot"
    return [Argument("model", name, "name of the robot in the simulator; another one for a second robot")]


def _namespaces(options: GeneratorOptions, robot: RobotFacts, *, movable: bool) -> dict[str, str]:
    """The namespace of nodes, and the name of the robot in the simulator, in each form of launch file.

    Two robots in one world have different names: those of their namespaces.
    """
    space, name = options.namespace, robot.name or "robot"
    fixed = python_text(space or name)
    otherwise = f"' or '{_within_quotes(name)}'"
    by_space = f"""PythonExpression(["'", namespace, {python_text(otherwise)}])"""
    expression = f'$(eval "\'$(var namespace){otherwise}")' if movable else space or name
    text = "$(var namespace)" if movable else space
    return {
        "namespace": "namespace" if movable else python_text(space) if space else "",
        "namespaced": f' namespace="{xml_text(text)}"' if text else "",
        "space_text": text,
        "model": by_space if movable else fixed,
        "model_text": "$(arg model)" if options.ros == 1 else expression,
        "description_topic": "robot_description" if movable else f"{'/' * bool(space)}{space}/robot_description",
    }


def _within_quotes(name: str) -> str:
    """A name as Python writes it between quotes of any kind."""
    written = name.encode("unicode_escape").decode() if not name.isprintable() else name.replace("\\", "\\\\")
    return written.replace("'", "\\x27").replace('"', "\\x22")


def launch_name(options: GeneratorOptions) -> str:
    """Return the name of the launch file."""
    return f"control.{FORMS[options.form] if options.ros == 2 else 'launch'}"  # noqa: PLR2004


def planning_launch_name(options: GeneratorOptions) -> str:
    """Return the name of the launch file that starts MoveIt."""
    return "moveit.launch.py" if options.ros == 2 else "moveit.launch"  # noqa: PLR2004


def plain_name(path: str | None) -> str | None:
    """Return the name of a file that is written under another than its usual one; None for one with odd characters."""
    name = os.path.basename(path or "")
    return name if re.fullmatch(r"\w+(\.\w+)*", name, re.ASCII) else None


def spawner(distro: str) -> str:
    """Return the name of the controller manager's spawner program in ROS 2."""
    return "spawner.py" if distro == "foxy" else "spawner"


def takes_param_file(distro: str) -> bool:
    """Return whether the spawner passes a controller file to the controllers that it starts."""
    return distro in since("jazzy")


def _spawned(names: list[str], options: GeneratorOptions) -> list[Spawner]:
    """The controllers that each spawner starts."""
    if options.distro in _ONE_A_SPAWNER:
        return [Spawner([name]) for name in names]
    parts = [part for part in (names[:1], names[1:]) if part] if options.form == "python" else [names]
    return [Spawner(part) for part in parts]


def _waiting(made: Sequence[GeneratedController], options: GeneratorOptions) -> list[Spawner]:
    """The spawners of controllers that are loaded and not started."""
    names = [controller.name for controller in made if controller.waits]
    words = ["--stopped"] if options.distro in _ONE_A_SPAWNER else ["--inactive"]
    lists = [[name] for name in names] if options.distro in _ONE_A_SPAWNER else [names] if names else []
    return [Spawner(part, words) for part in lists]


def _description(distro: str) -> str:
    """How the controller manager gets the description: as a `parameter`, or by the `topic`, `remapped` or not."""
    if distro in _ONE_A_SPAWNER:
        return "parameter"
    return "topic" if distro in since("jazzy") else "remapped"


def gz_names(distro: str) -> dict[str, str]:
    """Return the names that the packages and messages of gz have in a distro."""
    if distro in _ONE_A_SPAWNER:
        names = ("ros_ign_gazebo", "ign_gazebo.launch.py", "ign_args", "ros_ign_bridge", "ignition.msgs")
    else:
        messages = "gz.msgs" if distro in since("jazzy") else "ignition.msgs"
        names = ("ros_gz_sim", "gz_sim.launch.py", "gz_args", "ros_gz_bridge", messages)
    return dict(zip(("package", "launch", "argument", "bridge", "messages"), names, strict=True))


def _model_path(options: GeneratorOptions) -> str:
    """The environment variable with the folders in which a simulator looks for packages with meshes."""
    if options.simulator != "gz":
        return "GAZEBO_MODEL_PATH"
    return "GZ_SIM_RESOURCE_PATH" if options.distro in since("jazzy") else "IGN_GAZEBO_RESOURCE_PATH"


def dependencies(
    made: Sequence[GeneratedController], options: GeneratorOptions, catalog: Catalog, robot: RobotFacts
) -> list[str]:
    """Return the packages that are required to start the robot, sorted."""
    packages = {"controller_manager", "robot_state_publisher", "xacro"}
    packages |= {package for controller in made for package in _packages_of(controller)}
    if options.robot_text:
        packages |= {*_NAMED.findall(options.robot_text[1])}
    packages.add(robot.package or "")
    if options.own and robot.own_file:
        packages.add(robot.own_file[0])
    if options.simulator in ("gz", "gazebo-classic"):
        packages.add(host(options, catalog).package or "")
        gz = gz_names(options.distro)
        packages |= {gz["package"], gz["bridge"]} if options.simulator == "gz" else {"gazebo_ros"}
    if options.ros == 2:  # noqa: PLR2004
        package = hardware(options, catalog).package
        packages.add("hardware_interface" if package in ("mock_components", "fake_components") else package)
        packages |= {"launch_ros", {"python": "launch"}.get(options.form, f"launch_{options.form}")}
    return sorted(name for name in packages if name and name != options.package)


def _packages_of(controller: GeneratedController) -> Iterator[str]:
    """The package of a controller, and those of the plugins and filters that its parameters name."""
    yield controller.type.package
    for setting in controller.settings:
        filters = setting.value.values() if isinstance(setting.value, Mapping) else ()
        named = [setting.value] if setting.name.endswith("plugin_name") else [one["type"] for one in filters]
        for name in named:
            package = str(name).partition("/")[0]
            yield _PACKAGES.get(package, package)


def package_files(
    depends: Sequence[str], options: GeneratorOptions, templates: Templates, title: str, xml_command: str
) -> list[File]:
    """Return package.xml and CMakeLists.txt of the generated package. `xml_command` is the command for a comment."""
    mujoco = options.simulator == "mujoco" and bool(options.model_path)
    values = {"mujoco": mujoco, "ros": options.ros, "package": options.package, "title": title}
    return [
        File("package.xml", templates.render("package/package.xml", **values, command=xml_command, depends=depends)),
        File("CMakeLists.txt", templates.render("package/CMakeLists.txt", **values, command=options.command)),
    ]
