"""The generators, and the files that each of them makes."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.errors import UserError
from urdfctl.generate.controllers.creation import controllers
from urdfctl.generate.controllers.fit import check_fit
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.files.bringup import dependencies, launch_file, launch_name, package_files
from urdfctl.generate.files.controllers_file import controllers_file
from urdfctl.generate.files.descriptions import (
    OF_TRANSMISSIONS,
    component,
    simulator_plugin,
    transmissions,
    wanted_interfaces,
)
from urdfctl.generate.files.hardware import has_host, loads_others, takes_namespace, unplanned
from urdfctl.generate.files.mjcf import MODEL, commanded, mjcf_file
from urdfctl.generate.files.moveit import moveit_file
from urdfctl.generate.files.moveit_package import moveit_dependencies, moveit_files
from urdfctl.generate.files.planned_controllers import planned_controllers
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.robot.mounting import needs_world
from urdfctl.generate.text.parse_again import checked
from urdfctl.generate.text.templates import Templates
from urdfctl.source.disk.files import named_bytes
from urdfctl.startup.records import NamedTuple


class Order(NamedTuple):
    """The input of a generator. What it kept of files that are there is added to `told`, in words."""

    joints: tuple[JointFacts, ...]
    options: GeneratorOptions
    catalog: Catalog
    robot: RobotFacts
    templates: Templates
    told: list[str] | None = None

    @property
    def title(self) -> str:
        """The robot's name in comments and titles."""
        return f"'{self.robot.name}'" if self.robot.name else "these joints"

    def controllers(self) -> tuple[GeneratedController, ...]:
        """Return the requested controllers, or the robot's own ones."""
        if self.options.own:
            return planned_controllers(self.robot, self.options, self.catalog)
        return controllers(self.joints, self.options, self.catalog, self.robot)

    def made_if_typed(self) -> tuple[GeneratedController, ...]:
        """Return the requested controllers. Empty if no type is given."""
        asked = self.options.types or self.options.requests or self.options.own
        return self.controllers() if asked else ()


def _controllers(order: Order) -> list[File]:
    return [controllers_file(_typed(order), order.options, order.templates, order.title)]


def _wrapped(order: Order, name: str, *blocks: str, includes: Sequence[str] = (), robot: str | None = None) -> File:
    """A xacro file with these blocks, or with these includes and the robot's arguments."""
    body = [block.rstrip("\n") + "\n" for block in blocks]
    text = order.templates.render(
        "xacro/file.xacro",
        command=_one_dash(order.options.command),
        blocks=body,
        includes=includes,
        arguments=order.options.arguments if includes else (),
        name=robot,
    )
    return File(name, text)


def _one_dash(command: str) -> str:
    """A command for an XML comment, which must not contain `--`: long options also work with one dash."""
    return re.sub(r"(?<= )--(?=[a-z])", "-", command)


def _transmissions(order: Order) -> list[File]:
    there = {name for name in order.robot.interfaces if name not in order.robot.generated}
    wanted = wanted_interfaces(order.made_if_typed())
    without = _commanded((joint for joint in order.joints if joint.name not in there), wanted)
    if there and not without:
        raise UserError("the robot already has transmissions for all of these joints; change their <hardwareInterface>")
    block = transmissions(without, order.options, order.templates, wanted)
    return [_wrapped(order, "urdf/transmissions.xacro", block)]


def _commanded(joints: Iterable[JointFacts], wanted: Mapping[str, str]) -> list[JointFacts]:
    """The joints that controllers command, or that are asked for with an interface; all of them without controllers."""
    return [joint for joint in joints if not wanted or joint.interface or joint.name in wanted]


def _ros2_control(order: Order) -> list[File]:
    made = order.made_if_typed()
    block = _component(order, made)
    if block is None:
        raise UserError("the robot's <ros2_control> already has all of these joints, sensors and gpios")
    return [_wrapped(order, "urdf/ros2_control.xacro", block)]


def _component(order: Order, made: Sequence[GeneratedController]) -> str | None:
    return component(
        joints=order.joints,
        options=order.options,
        catalog=order.catalog,
        templates=order.templates,
        made=made,
        robot=order.robot,
    )


def _gazebo(order: Order) -> list[File]:
    return [_wrapped(order, "urdf/gazebo.xacro", simulator_plugin(order.options, order.catalog, order.templates))]


def _launch(order: Order) -> list[File]:
    return [_launch_file(order, _typed(order))]


def _launch_file(order: Order, made: Sequence[GeneratedController]) -> File:
    options = order.options
    if options.ros == 1 or options.form == "xml":
        options = options._replace(command=_one_dash(options.command))
    movable = takes_namespace(order.robot, options, order.catalog)
    return launch_file(made, options, order.templates, order.robot, movable=movable)


def _typed(order: Order) -> tuple[GeneratedController, ...]:
    if order.options.own:
        return order.controllers()
    if not (order.options.types or order.options.requests):
        raise UserError("--type is missing: use e.g. --type effort, --type trajectory or --type diff_drive")
    made = order.controllers()
    check_fit(made, order.robot, order.options)
    if order.options.ros == 1:
        _check_joints(made, order.robot)
        for controller in made if order.options.simulated else ():
            _check_simulated(controller, order)
    return made


def _check_joints(made: Sequence[GeneratedController], robot: RobotFacts) -> None:
    """UserError if a controller of ROS 1 commands a joint that the robot does not have."""
    known = {joint.name for joint in robot.joints}
    for controller in made if known else ():
        unknown = [name for name in wanted_interfaces([controller]) if name not in known]
        if unknown:
            raise UserError(f"'{controller.type.type}' requires joint '{unknown[0]}', which the robot does not have")


def _check_simulated(controller: GeneratedController, order: Order) -> None:
    """UserError if gazebo_ros_control does not simulate an interface that a controller of ROS 1 requires."""
    known = order.catalog.hardware_interfaces(order.options.distro)
    for name in controller.type.hardware_interfaces:
        if name in known and known[name].in_gazebo in ("absent", "refused"):
            raise UserError(f"'{controller.type.type}' requires '{name}', which Gazebo does not simulate")


def _all(order: Order) -> list[File]:
    """A package with the robot and everything that controls it."""
    made, robot = _typed(order), order.robot
    options = order.options._replace(description="urdf/robot.urdf.xacro")
    if options.simulator == "mujoco" and robot.skeleton:
        options = options._replace(model_path=f"$(find {options.package})/{MODEL}")
    order = order._replace(options=options)
    others = (unplanned if options.moveit else loads_others)(robot, options, order.catalog)
    if others and options.moveit:
        raise UserError(others)
    if others and order.told is not None:
        order.told.append(others)
    blocks = list(_blocks(order, made))
    includes = [order.options.robot_file]
    includes += [f"$(find {options.package})/urdf/control.xacro"] if blocks else []
    depends = dependencies(made, options, order.catalog, robot)
    moveit = moveit_file(made, options, order.templates, order.title)
    planning = _planning(order, made) if options.moveit else []
    depends = sorted({*depends, *moveit_dependencies(options)}) if options.moveit else depends
    return [
        *([] if options.own else [controllers_file(made, options, order.templates, order.title)]),
        *([moveit] if moveit else []),
        *planning,
        *([_wrapped(order, "urdf/control.xacro", *blocks)] if blocks else []),
        _wrapped(order, "urdf/robot.urdf.xacro", *_world(order), includes=includes, robot=robot.name or "robot"),
        _launch_file(order, made),
        *([File(*options.robot_text)] if options.robot_text else []),
        _settings(order),
        *_mujoco(order, made),
        *package_files(depends, options, order.templates, order.title, _one_dash(options.command)),
    ]


def _blocks(order: Order, made: Sequence[GeneratedController]) -> Iterator[str]:
    """What a robot lacks to be controlled, as blocks of its description."""
    options, robot = order.options, order.robot
    wanted = wanted_interfaces(made) if options.ros == 1 else {}
    without = _commanded((joint for joint in order.joints if joint.name not in robot.interfaces), wanted)
    if options.ros == 1 and without and (not wanted or {*wanted.values()} & {*OF_TRANSMISSIONS}):
        yield transmissions(without, options, order.templates, wanted)
    block = _component(order, made) if options.ros == 2 and not options.own else None  # noqa: PLR2004
    if block:
        yield block
    if options.simulator in ("gz", "gazebo-classic") and not has_host(robot, options, order.catalog):
        # the launch file passes the namespace; xacro takes an empty argument for a missing one
        movable = takes_namespace(robot, options, order.catalog)
        hosting = options._replace(namespace="") if movable else options
        yield simulator_plugin(hosting, order.catalog, order.templates)


def _planning(order: Order, made: Sequence[GeneratedController]) -> list[File]:
    """MoveIt's configuration."""
    options = order.options
    made_files, kept = moveit_files(made, options, order.templates, order.robot, _one_dash(options.command))
    if order.told is not None:
        order.told.extend(kept)
    return made_files


def _world(order: Order) -> list[str]:
    """What fixes a robot without wheels and legs to the world of a simulator, as a block of its description."""
    if not needs_world(order.robot, order.options):
        return []
    return [order.templates.render("xacro/world.xacro", root=order.robot.root)]


def _settings(order: Order) -> File:
    """The configuration that makes lint and smoke agree with the generator."""
    options = order.options
    text = order.templates.render(
        "package/urdfctl.toml",
        command=options.command,
        distro=options.distro,
        simulator=options.simulator,
        controllers_file="" if options.own else options.controllers_file,
        launch=launch_name(options),
    )
    return File("urdfctl.toml", text)


def _convert(order: Order) -> list[File]:
    options = order.options
    if options.to == "sdf":
        return [_sdf_file(order)]
    if options.to != "mjcf":
        told = "--to is missing: use --to mjcf or --to sdf"
        raise UserError(told if options.to is None else "--to must be mjcf, sdf")
    interfaces = commanded((), order.robot)
    if options.interface or not interfaces:
        interfaces = {joint.name: joint.interface or options.interface or "position" for joint in order.joints}
    options = options._replace(command=_one_dash(options.command))
    return [mjcf_file(order.robot, interfaces, options, order.templates, "robot.xml")]


def _sdf_file(order: Order) -> File:
    """The robot as Gazebo converts it. UserError if its links are unknown, or have names of joints."""
    skeleton = order.robot.skeleton
    if skeleton is None:
        raise UserError("an SDF model requires a robot, not a list of joints")
    names = Counter(re.findall(r'(?m)^    <(?:link|joint|frame) name="([^"]*)"', skeleton.fixed))
    twice = next((name for name, number in names.items() if number > 1), None)
    if twice:
        raise UserError(f"joint '{twice}' has the same name as a link, which Gazebo rejects; rename one of them")
    text = order.templates.render(
        "sdf/robot.sdf",
        command=_one_dash(order.options.command),
        version="1.11" if "<mimic " in skeleton.fixed else "1.9",
        name=order.robot.name or "robot",
        bodies=skeleton.fixed,
        notes=skeleton.notes,
    )
    return File("robot.sdf", text)


def _ending(path: str) -> str:
    return os.path.splitext(path)[1].lower()


def _mujoco(order: Order, made: Sequence[GeneratedController]) -> list[File]:
    """The model of the robot for mujoco_ros2_control, with its meshes."""
    if order.options.simulator != "mujoco" or order.robot.skeleton is None:
        return []
    skeleton = order.robot.skeleton
    copies = tuple((name, f"meshes/{name}{_ending(path)}", scale) for name, path, scale in skeleton.meshes)
    robot = order.robot._replace(skeleton=skeleton._replace(meshes=copies))
    options = order.options._replace(command=_one_dash(order.options.command), model_path=None)
    model = mjcf_file(robot, commanded(made, robot), options, order.templates, MODEL)
    folder = os.path.dirname(MODEL)
    return [
        model,
        *(
            File(f"{folder}/{copy}", named_bytes(path).decode("utf-8", "surrogateescape"))
            for (_, path, _), (_, copy, _) in zip(skeleton.meshes, copies, strict=True)
        ),
    ]


GENERATORS: Mapping[str, Callable[[Order], list[File]]] = {
    "gen-controllers": _controllers,
    "gen-transmissions": _transmissions,
    "gen-ros2-control": _ros2_control,
    "gen-gazebo": _gazebo,
    "gen-launch": _launch,
    "gen-all": _all,
    "gen-moveit": _all,
    "convert": _convert,
}


def files(command: str, order: Order) -> list[File]:
    """Return the files that a command generates, each checked by parsing it again. UserError if they cannot be made."""
    options = order.options
    if options.ros == 1 and options.simulator in ("gz", "mujoco"):
        raise UserError(
            f"{options.distro} does not support controllers in '{options.simulator}'; use gazebo-classic or none"
        )
    if options.ros == 1 and options.hardware:
        raise UserError(f"{options.distro} has no hardware plugins in the description; leave out --hardware")
    return [checked(file) for file in GENERATORS[command](order)]
