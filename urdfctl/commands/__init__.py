"""The commands by name, in the groups and the order of `urdfctl --help`. Only the one that is run is imported."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.commands.declaring import Command

FIND = "Find faults"
UNDERSTAND = "Understand"
GENERATE = "Generate"
MIGRATE = "Migrate"
EDITOR = "Editor and CI"


class Listed(NamedTuple):
    """A command as the list of commands shows it.

    group: the heading that it stands under.
    module: with its options and what it does, in this package.
    summary: one line.
    is_short: its process does so little by itself, its workers the rest, that it needs no garbage collection.
    """

    group: str
    module: str
    summary: str
    is_short: bool = False


COMMANDS = {
    "lint": Listed(FIND, "find.lint", "Find what keeps a robot from starting and moving.", is_short=True),
    "smoke": Listed(FIND, "find.smoke", "Load, start and move each controller, without ROS.", is_short=True),
    "check": Listed(FIND, "find.check", "Lint and smoke in one run, with one report: for pipelines.", is_short=True),
    "show": Listed(FIND, "find.show", "Show what is started together."),
    "doctor": Listed(FIND, "find.doctor", "Say what is wrong in a running system, from a recording of it."),
    "why": Listed(UNDERSTAND, "understand.why", "Show where a value of a robot comes from, and what uses it."),
    "diff": Listed(UNDERSTAND, "understand.diff", "Show what changed between two robots, as models."),
    "graph": Listed(UNDERSTAND, "understand.graph", "Draw what is wired to what, with errors in red."),
    "view": Listed(UNDERSTAND, "understand.view", "Show the robot in 3-D, in one page."),
    "explain": Listed(UNDERSTAND, "understand.explain", "Explain a rule, an error message, or a whole log."),
    "rules": Listed(UNDERSTAND, "understand.rules", "List the rules."),
    "expand": Listed(UNDERSTAND, "understand.expand", "Expand xacro without ROS."),
    "gen-all": Listed(GENERATE, "generate.gen_all", "Write a package with all of it."),
    "gen-moveit": Listed(GENERATE, "generate.gen_moveit", "Write a package that plans with MoveIt."),
    "gen-controllers": Listed(GENERATE, "generate.gen_controllers", "Write the controllers' YAML file."),
    "gen-transmissions": Listed(GENERATE, "generate.gen_transmissions", "Write the ROS 1 transmissions."),
    "gen-ros2-control": Listed(GENERATE, "generate.gen_ros2_control", "Write the <ros2_control> tag of ROS 2."),
    "gen-gazebo": Listed(GENERATE, "generate.gen_gazebo", "Write the simulator plugin that runs the controllers."),
    "gen-launch": Listed(
        GENERATE, "generate.gen_launch", "Write a launch file that starts the robot and its controllers."
    ),
    "gen-check": Listed(GENERATE, "generate.gen_check", "Check that generated files are up to date."),
    "convert": Listed(GENERATE, "generate.convert", "Convert a robot to MuJoCo's own format."),
    "migrate": Listed(MIGRATE, "migrate", "Migrate packages to another ROS distro."),
    "init": Listed(EDITOR, "editor.init", "Write a configuration with the robots of a project."),
    "schema": Listed(EDITOR, "editor.schema", "Print a schema for your editor, or check files with it."),
    "server": Listed(EDITOR, "editor.server", "Serve an editor: findings while you type."),
}


def command_named(name: str) -> Command:
    """Return one of `COMMANDS`."""
    command: Command = import_module(f"{__name__}.{COMMANDS[name].module}").command
    return command
