"""Options of the commands, each declared once. typer makes the command line from these classes.

Annotations are evaluated here, because typer evaluates those of inherited options in the wrong module.
`lint` and `smoke` also have a path around typer; `python -m urdfctl.cli.fast_path lint` generates a table of options.
"""

from dataclasses import dataclass
from typing import Annotated

import typer

from urdfctl.catalog.distros import ALL

REPORT_HELP = "Write an HTML page with the robots, what is wired to what, and the findings to this file."
JOBS_HELP = "How many robots to check at the same time. 0: one for each processor."


def _list(help: str, *flags: str, metavar: str | None = None) -> typer.models.OptionInfo:  # noqa: A002 (typer's own name)
    info: typer.models.OptionInfo = typer.Option(*flags, help=f"{help} Repeatable.", metavar=metavar)
    return info


Paths = Annotated[
    list[str] | None,
    typer.Argument(
        help="Robots, controller files, launch files, folders, and name:=value arguments. Default: the package around "
        "the current folder.",
        metavar="[PATH]... [NAME:=VALUE]...",
        show_default=False,
    ),
]


@dataclass(kw_only=True)
class ReadingOptions:
    """Options of every command that reads a robot."""

    workspace: Annotated[str | None, typer.Option(help="Folder outside of which nothing is read.")] = None
    package_path: Annotated[list[str] | None, _list("Folder with packages, searched first.")] = None
    env: Annotated[list[str] | None, _list("Environment variable that $(env NAME) may read.")] = None
    trust: Annotated[bool, typer.Option("--trust", help="Read any file and evaluate any expression.")] = False
    timeout: Annotated[float, typer.Option(help="Processor time for one robot, in seconds.")] = 20.0
    memory: Annotated[int, typer.Option(help="Memory limit for one robot, in MiB.")] = 2048
    config: Annotated[
        str | None,
        typer.Option(help="Configuration file. Default: the nearest urdfctl.toml or pyproject.toml."),
    ] = None


@dataclass(kw_only=True)
class TargetOptions(ReadingOptions):
    """Options of every command that checks a robot for a distro and a simulator."""

    distro: Annotated[
        str | None, typer.Option(help=f"ROS distro: {', '.join(ALL)}. Default: detected from the files.")
    ] = None
    simulator: Annotated[
        str | None,
        typer.Option(help="Simulator to check against. Default: detected from plugins."),
    ] = None


@dataclass(kw_only=True)
class CheckOptions(TargetOptions):
    """Options of both lint and smoke."""

    paths: Paths = None
    start: Annotated[
        str | None, typer.Option(help="Controllers that are started together, in this order: NAME,NAME, or all.")
    ] = None
    jobs: Annotated[int, typer.Option(help=JOBS_HELP)] = 0
    shard: Annotated[
        str | None, typer.Option(help="Check only one of N equal shares of the files, e.g. 2/5.", metavar="K/N")
    ] = None


@dataclass(kw_only=True)
class LintOptions(CheckOptions):
    """Find what keeps a robot from loading, starting and moving.

    \b
    Example: urdfctl lint urdf/robot.xacro prefix:=left_ --distro noetic
    """

    select: Annotated[list[str] | None, _list("Select rules by code or prefix, e.g. UC2,UC401.")] = None
    ignore: Annotated[list[str] | None, _list("Ignore rules by code or prefix.")] = None
    extend_select: Annotated[list[str] | None, _list("Select these rules in addition.")] = None
    formats: Annotated[
        list[str] | None,
        _list(
            "Output format. FORMAT=FILE writes a file.",
            "--format",
        ),
    ] = None
    fail_on: Annotated[
        str | None,
        typer.Option(help="Exit with status 1 on findings of this severity or worse. Default: error."),
    ] = None
    baseline: Annotated[
        str | None, typer.Option(help="Hide the findings listed in this file, and report those that are fixed.")
    ] = None
    write_baseline: Annotated[str | None, typer.Option(help="Write all findings to this file, for --baseline.")] = None
    output_file: Annotated[
        str | None, typer.Option("-o", "--output-file", help="Write the report to this file, not to standard output.")
    ] = None
    quiet: Annotated[bool, typer.Option("-q", "--quiet", help="Show only the findings, without a summary.")] = False
    statistics: Annotated[bool, typer.Option("--statistics", help="Count the findings of each rule.")] = False
    report: Annotated[str | None, typer.Option(help=REPORT_HELP)] = None
    exit_zero: Annotated[bool, typer.Option("--exit-zero", help="Exit with status 0 whatever is found.")] = False
    no_cache: Annotated[
        bool, typer.Option("--no-cache", help="Neither use results of an earlier run nor store those of this one.")
    ] = False
    show_settings: Annotated[
        bool,
        typer.Option("--show-settings", help="Show the effective settings and where each comes from, then exit."),
    ] = False
    fix: Annotated[bool, typer.Option("--fix", help="Apply safe fixes.")] = False
    unsafe_fixes: Annotated[
        bool, typer.Option("--unsafe-fixes", help="Also apply fixes that may change behaviour.")
    ] = False
    node: Annotated[
        list[str] | None,
        _list("Check the parameters of a node by their definition for generate_parameter_library: NAME=FILE."),
    ] = None
    diff: Annotated[
        bool,
        typer.Option("--diff", help="Show fixes as a diff and write nothing. Exit with status 1 if there are any."),
    ] = False


@dataclass(kw_only=True)
class ShowOptions(CheckOptions):
    """Show what is started together: launch files with their robots, arguments and controllers; and unused files.

    \b
    Example: urdfctl show urdf/robot.xacro
    """

    formats: Annotated[
        list[str] | None, _list("Output format: text or json. FORMAT=FILE writes a file.", "--format")
    ] = None


@dataclass(kw_only=True)
class SmokeOptions(CheckOptions):
    """Spawn robots without ROS, then load, activate and move each of their controllers.

    \b
    Example: urdfctl smoke urdf/robot.xacro --controllers config/controllers.yaml
    """

    controllers: Annotated[list[str] | None, _list("Controller file that belongs to each robot.")] = None
    only: Annotated[list[str] | None, _list("Test only the controllers with these names: NAME,NAME.")] = None
    engine: Annotated[
        str, typer.Option(help="Physics engine: auto, pybullet, mujoco, both, or none to move nothing.")
    ] = "auto"
    tasks: Annotated[
        str | None, typer.Option(help="YAML file with your own targets, trajectories, tolerances and start pose.")
    ] = None
    duration: Annotated[float, typer.Option(help="Seconds of simulation for each controller.")] = 2.0
    progress: Annotated[
        bool | None,
        typer.Option(
            "--progress/--no-progress",
            help="Print a line on standard error for each controller that was simulated. Default: on terminals.",
        ),
    ] = None
    gui: Annotated[bool, typer.Option("--gui", help="Show pybullet's window.")] = False
    timeout: Annotated[float, typer.Option(help="Processor time for one robot, in seconds.")] = 30.0
    formats: Annotated[
        list[str] | None,
        _list("Output format. FORMAT=FILE writes a file.", "--format", metavar="[text|json|junit|sarif|github]"),
    ] = None
    output_file: Annotated[
        str | None, typer.Option("-o", "--output-file", help="Write the report to this file, not to standard output.")
    ] = None
    quiet: Annotated[bool, typer.Option("-q", "--quiet", help="Show only the findings.")] = False
    statistics: Annotated[bool, typer.Option("--statistics", help="Count the findings of each rule.")] = False
    report: Annotated[str | None, typer.Option(help=REPORT_HELP)] = None
    select: Annotated[list[str] | None, _list("Select findings by code or prefix, e.g. UC91,UC931.")] = None
    ignore: Annotated[list[str] | None, _list("Ignore findings by code or prefix.")] = None
    fail_on: Annotated[
        str | None, typer.Option(help="Exit with status 1 on findings of this severity or worse. Default: error.")
    ] = None
    baseline: Annotated[
        str | None, typer.Option(help="Hide the findings listed in this file, and report those that are fixed.")
    ] = None
    write_baseline: Annotated[str | None, typer.Option(help="Write all findings to this file, for --baseline.")] = None
    exit_zero: Annotated[bool, typer.Option("--exit-zero", help="Exit with status 0 whatever is found.")] = False
    allow_empty: Annotated[
        bool, typer.Option("--allow-empty", help="Exit with status 0, not 5, if there is no controller to test.")
    ] = False


@dataclass(kw_only=True)
class ExpandOptions(ReadingOptions):
    """Expand xacro without ROS, byte for byte as xacro does.

    \b
    Example: urdfctl expand urdf/robot.xacro prefix:=left_ -o robot.urdf
    """

    file: Annotated[str, typer.Argument(help="The xacro file.", show_default=False)]
    arguments: Annotated[list[str] | None, typer.Argument(help="name:=value", show_default=False)] = None
    output: Annotated[str | None, typer.Option("-o", "--output", help="Write to this file.")] = None
    force: Annotated[bool, typer.Option("--force", help="Overwrite the output file.")] = False


@dataclass(kw_only=True)
class RulesOptions:
    """List the rules.

    \b
    Example: urdfctl rules --select UC2
    """

    output_format: Annotated[str, typer.Option("--format", help="Output format: text or json.")] = "text"
    select: Annotated[list[str] | None, _list("Select rules by code or prefix, e.g. UC2,UC401.")] = None


@dataclass(kw_only=True)
class ExplainOptions:
    """Explain a rule, an error message, or a whole log: why it is printed, and what to do.

    \b
    Example: urdfctl explain UC201
             urdfctl explain "No p gain specified for pid."
             urdfctl explain gazebo.log --in .
    """

    what: Annotated[
        list[str] | None,
        typer.Argument(
            help="A rule's code or name, a line of a log in quotes, or a log file (- for standard input).",
            show_default=False,
        ),
    ] = None
    folder: Annotated[
        str | None,
        typer.Option(
            "--in", help="Folder with the robot. Checks which of the causes its files have, and shows these first."
        ),
    ] = None
    distro: Annotated[
        str | None,
        typer.Option(help="ROS distro for --in. Default: the one that the log shows, or else detected from the files."),
    ] = None
    output_format: Annotated[str, typer.Option("--format", help="Output format: text or json.")] = "text"
    output_file: Annotated[
        str | None,
        typer.Option("-o", "--output-file", help="Write the explanation to this file, not to standard output."),
    ] = None
