"""Values that launch arguments hold, or that stand where they are used."""

from __future__ import annotations

from dataclasses import dataclass, field

from systems.possible import Idioms
from systems.render.actions import Arg, Description, Share, Value
from systems.render.description import ADDRESS, CHOICE, FILE_ARGUMENTS, xacro_arguments
from systems.render.places import Places, config_folder, description_name, is_text, parameter_names, pick
from systems.system import Robot, System

EXAMPLE = "example"
"""The name of files that are the default of an argument which always has another value."""


@dataclass
class Values:
    """The values of a robot's launch files.

    right: of the arguments that are used, what they have to be.
    wrong: what their default may be where they are always given.
    """

    system: System
    idioms: Idioms
    places: Places
    robot: Robot
    right: dict[str, Value] = field(default_factory=dict)
    wrong: dict[str, Value] = field(default_factory=dict)

    def given(self, what: str, name: str, value: Value, wrong: Value) -> Value:
        """Return an argument of a name if the switch says so for this kind of value, otherwise the value itself."""
        argued = self.idioms["argued"]
        own = self.idioms["fleet"] == "shared" and what in ("namespace", "prefix", "controllers")
        if argued not in (what, "all") and not own:
            return value
        self.right[name], self.wrong[name] = value, wrong
        return (Arg(name),)

    @property
    def namespace(self) -> Value:
        """The namespace, without slashes; nothing for the root."""
        if not self.robot.namespace:
            return ()
        name = pick(self.system, "namespace", ("namespace", "robot_namespace", "ns", "robot_name"))
        return self.given("namespace", name, (self.robot.namespace,), ("",))

    @property
    def model(self) -> Value:
        """The name of the robot in the simulator, which refuses another one of that name."""
        is_shared = self.idioms["fleet"] == "shared" and self.robot.namespace
        return self.namespace if is_shared else (self.robot.name,)

    @property
    def controller(self) -> Value:
        """The name of the main controller that is spawned."""
        name = pick(self.system, "controller", ("robot_controller", "controller", "initial_joint_controller"))
        return self.given("spawned", name, (self.robot.spawned[1].name,), ("scaled_controller",))

    @property
    def files(self) -> tuple[Value, ...]:
        """The paths of the files of parameters, the manager's first."""
        system = self.system
        names = parameter_names(system, self.idioms, self.robot)
        order = FILE_ARGUMENTS[: len(names)][::-1]
        return tuple(self._file(argument, name) for argument, name in zip(order, names, strict=True))

    def _file(self, argument: str, name: str) -> Value:
        folder = config_folder(self.system)
        wrong = f"{EXAMPLE}_controllers.yaml"

        def at(file: Value) -> Value:
            return (Share((self.places.control,), ((folder,), file)),)

        if pick(self.system, "file argument", ("name", "path")) == "name":
            return at(self.given("controllers", argument, (name,), (wrong,)))
        return self.given("controllers", argument, at((name,)), at((wrong,)))

    @property
    def description(self) -> Description:
        """The robot's description with its arguments."""
        system, idioms, places = self.system, self.idioms, self.places
        name = description_name(system, idioms, self.robot)
        wrong = f"{EXAMPLE}.urdf" if is_text(idioms) else f"{EXAMPLE}.urdf.xacro"
        file = self.given("description", "description_file", (name,), (wrong,))
        package: Value = (places.description,)
        if system.generation == 2:
            package = self.given("package", "description_package", package, package)
        mappings = tuple(
            (argument, self._mapping(argument)) for argument in xacro_arguments(system, idioms, self.robot)
        )
        path = (Share(package, (("urdf",), file)),)
        return Description(path, mappings, is_text(idioms))

    @property
    def example(self) -> Description:
        """Another description, that the right one replaces."""
        is_plain = is_text(self.idioms)
        name = f"{EXAMPLE}.urdf" if is_plain else f"{EXAMPLE}.urdf.xacro"
        return Description((Share((self.places.description,), (("urdf",), (name,))),), (), is_plain)

    def _mapping(self, argument: str) -> Value:
        if argument in FILE_ARGUMENTS:
            return self.files[::-1][FILE_ARGUMENTS.index(argument)]
        if argument in (ADDRESS, CHOICE):
            return (Arg(argument),)
        if argument == "namespace":
            return self.namespace or ("",)
        name = pick(self.system, "prefix", ("prefix", "tf_prefix", "joint_prefix"))
        return self.given("prefix", name, (self.robot.prefix,), ("",))
