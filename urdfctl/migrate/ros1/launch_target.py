"""What a launch file of ROS 1 is migrated to."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.migrate.ros1.included import IncludedFile
from urdfctl.migrate.ros1.spawned_names import SpawnedName
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class LaunchTarget(NamedTuple):
    """What a launch file is migrated to.

    distro: that of the migrated robot.
    simulator: what runs its controllers.
    started: the simulator that launch files start.
    own: the packages that are migrated.
    renamed: other packages, which have a successor that the user names.
    ending: the ending of migrated launch files.
    is_controllers_file: returns whether a written file name is that of a controller file.
    controllers_in: returns the names of the controllers in a controller file, by its written name.
    remaps_description: whether the controller manager reads the description from ~/robot_description.
    describes: whether robot_state_publisher may be started without a description.
    has_manager: whether the file already starts a controller manager.
    moveit: the packages whose launch files MoveIt makes.
    left: the launch files that are left to a person, by package and name.
    own_package: the package of the launch file; empty if it has none.
    publisher: the robot_state_publisher of the launch files without a description, which is started where that is set.
    spawned: the controllers that are spawned by a name with slashes, by their full names.
    files_of: returns the addresses of the controller files that have a section for a node, by the node's name.
    described_in: the namespaces in which the description is published.
    descriptions: the names of the parameters that are descriptions.
    published: the descriptions that files publish which this one includes.
    included: returns what is known of an included launch file, by its written address.
    split: the arguments of the file to which other files give several words.
    doubled: the names of the launch files that get another one, because a file beside them takes theirs.
    elsewhere: whether the description with the plugin of the simulator is in another package.
    has_controllers: whether the packages have files of controllers.
    is_expanded: returns whether a robot, by its written file name, gets `$(find)` in it, which only xacro expands.
    makes_publisher: whether MoveIt makes the launch file of robot_state_publisher beside this one.
    commands: returns whether a program of a package commands controllers of the packages, by the names of both.
    may_be_real: whether launch files that control a robot may control a real one, too.
    undeclared: returns the controllers of a controller file whose types the simulator's manager does not get.
    """

    distro: str
    simulator: str
    started: str
    own: frozenset[str]
    ending: str
    is_controllers_file: Callable[[str], bool]
    controllers_in: Callable[[str], list[str]]
    remaps_description: bool
    renamed: frozenset[str] = frozenset()
    describes: bool = False
    has_manager: bool = False
    moveit: frozenset[str] = frozenset()
    left: frozenset[tuple[str, str]] = frozenset()
    own_package: str = ""
    publisher: Element | None = None
    spawned: Mapping[str, SpawnedName] = {}
    files_of: Callable[[str], list[str]] = lambda _: []
    described_in: frozenset[str] = frozenset()
    descriptions: frozenset[str] = frozenset({"robot_description"})
    published: frozenset[str] = frozenset()
    included: Callable[[str], IncludedFile] = lambda _: IncludedFile({}, frozenset())
    split: frozenset[str] = frozenset()
    elsewhere: bool = False
    doubled: frozenset[str] = frozenset()
    has_controllers: bool = False
    is_expanded: Callable[[str], bool] = lambda _: False
    undeclared: Callable[[str], list[str]] = lambda _: []
    commands: Callable[[str, str], bool] = lambda *_: False
    may_be_real: bool = False
    makes_publisher: bool = False

    @property
    def apart(self) -> frozenset[str]:
        """The parameters that are descriptions beside robot_description: each is published on a topic of its name."""
        return self.descriptions - {"robot_description"} if "robot_description" in self.descriptions else frozenset()

    @property
    def simulated(self) -> bool:
        """Whether a simulator runs the controllers."""
        return self.simulator in ("gz", "gazebo-classic")
