"""The command line: what is asked is handed on; nothing is decided here but the exit status."""

from __future__ import annotations

from typing import Annotated

import typer

from urdfctl.cli.generate_options import add_commands
from urdfctl.cli.options import (
    Arguments,
    ConfigFile,
    Distro,
    Environment,
    Memory,
    PackagePath,
    Simulator,
    Start,
    Timeout,
    Trust,
    Workspace,
)

app = typer.Typer(
    name="urdfctl",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Lint, smoke-test, expand and explain the control configuration of robots in URDF and xacro, without ROS.",
)


def _version(wanted: bool) -> None:  # noqa: FBT001 (typer's callback)
    if wanted:
        from urdfctl import __version__

        typer.echo(f"urdfctl {__version__}")
        raise typer.Exit


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and leave.")
    ] = False,
) -> None:
    """Lint, smoke-test, expand and explain the control configuration of robots in URDF and xacro, without ROS."""


@app.command(short_help="Find what keeps a robot from starting and moving.")
def lint(
    paths: Arguments = None,
    distro: Distro = None,
    simulator: Simulator = None,
    start: Start = None,
    workspace: Workspace = None,
    package_path: PackagePath = None,
    env: Environment = None,
    trust: Trust = False,
    timeout: Timeout = 20.0,
    memory: Memory = 2048,
    select: Annotated[list[str] | None, typer.Option(help="Only rules whose code begins so: UC2,UC401.")] = None,
    ignore: Annotated[list[str] | None, typer.Option(help="Not the rules whose code begins so.")] = None,
    extend_select: Annotated[list[str] | None, typer.Option(help="These rules too.")] = None,
    formats: Annotated[
        list[str] | None,
        typer.Option(
            "--format",
            help="text, concise, json, jsonl, sarif, github, gitlab or junit; =FILE writes it there. Repeatable.",
        ),
    ] = None,
    fail_on: Annotated[
        str | None, typer.Option(help="Exit with 1 from this severity on: error (if not set), warning or info.")
    ] = None,
    baseline: Annotated[
        str | None, typer.Option(help="Hide the findings that this file knows; tell of those that are gone.")
    ] = None,
    write_baseline: Annotated[
        str | None, typer.Option(help="Write all findings to this file, for --baseline to hide.")
    ] = None,
    statistics: Annotated[bool, typer.Option("--statistics", help="Count the findings of each rule, in text.")] = False,
    exit_zero: Annotated[bool, typer.Option("--exit-zero", help="Exit with 0 whatever is found.")] = False,
    shard: Annotated[
        str | None, typer.Option(help="Only a share of the files: 2/5 is the second of five.", metavar="K/N")
    ] = None,
    jobs: Annotated[int, typer.Option(help="How many robots at once; 0: as many as there are processors.")] = 0,
    config: ConfigFile = None,
    show_settings: Annotated[
        bool, typer.Option("--show-settings", help="Lint nothing: show what is set, and what set it.")
    ] = False,
    fix: Annotated[bool, typer.Option("--fix", help="Write what is surely meant into the files.")] = False,
    unsafe_fixes: Annotated[
        bool, typer.Option("--unsafe-fixes", help="The same, and what is most likely meant.")
    ] = False,
    diff: Annotated[
        bool, typer.Option("--diff", help="Write nothing: show it as a diff, and exit with 1 where there is any.")
    ] = False,
) -> None:
    """Find what keeps a robot from loading, starting and moving.

    \b
    Example: urdfctl lint urdf/robot.xacro prefix:=left_ --distro noetic
    """
    from urdfctl.cli.lint_command import lint_words

    given = {name: value for name, value in locals().items() if name != "lint_words"}
    raise typer.Exit(lint_words(**given))


@app.command(short_help="Load, start and move each controller, without ROS.")
def smoke(
    paths: Arguments = None,
    controllers: Annotated[
        list[str] | None, typer.Option(help="A controllers' file that belongs to each robot. Repeatable.")
    ] = None,
    only: Annotated[list[str] | None, typer.Option(help="Only the controllers of these names: NAME,NAME.")] = None,
    engine: Annotated[str, typer.Option(help="auto, pybullet, mujoco, both, or none: nothing is moved then.")] = "auto",
    duration: Annotated[float, typer.Option(help="Seconds of simulation for each controller.")] = 2.0,
    gui: Annotated[bool, typer.Option("--gui", help="Show pybullet's window.")] = False,
    distro: Distro = None,
    simulator: Simulator = None,
    start: Start = None,
    workspace: Workspace = None,
    package_path: PackagePath = None,
    env: Environment = None,
    trust: Trust = False,
    timeout: Timeout = 30.0,
    memory: Memory = 2048,
    formats: Annotated[
        list[str] | None,
        typer.Option("--format", help="text, json, junit, sarif or github; =FILE writes it there. Repeatable."),
    ] = None,
    jobs: Annotated[int, typer.Option(help="How many robots at once; 0: as many as there are processors.")] = 0,
    shard: Annotated[str | None, typer.Option(help="Only one of several shares of the robots: 2/5.")] = None,
    config: ConfigFile = None,
    report: Annotated[str | None, typer.Option(help="Write a page of HTML to this file.")] = None,
) -> None:
    """Spawn robots without ROS, and take each of their controllers through its life: load, activate, move.

    \b
    Example: urdfctl smoke urdf/robot.xacro --controllers config/controllers.yaml
    """
    from urdfctl.cli.smoke_words import smoke_words

    given = {name: value for name, value in locals().items() if name != "smoke_words"}
    raise typer.Exit(smoke_words(**given))


@app.command(short_help="Expand xacro without ROS.")
def expand(
    file: Annotated[str, typer.Argument(help="The xacro file.", show_default=False)],
    arguments: Annotated[list[str] | None, typer.Argument(help="name:=value", show_default=False)] = None,
    output: Annotated[str | None, typer.Option("-o", "--output", help="Write to this file.")] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite the output file.")] = False,
    workspace: Workspace = None,
    package_path: PackagePath = None,
    env: Environment = None,
    trust: Trust = False,
    timeout: Timeout = 20.0,
    memory: Memory = 2048,
    config: ConfigFile = None,
) -> None:
    """Expand xacro without ROS, byte for byte as xacro writes it.

    \b
    Example: urdfctl expand urdf/robot.xacro prefix:=left_ -o robot.urdf
    """
    from urdfctl.cli.expand_command import run_expand
    from urdfctl.cli.words import configured, settings_from

    chosen = configured([file], config, workspace)
    settings = settings_from(chosen, None, None, None, workspace, package_path, env, trust, timeout, memory)
    raise typer.Exit(run_expand(file, arguments or [], settings, output, force=force))


@app.command()
def rules(
    output_format: Annotated[str, typer.Option("--format", help="text or json.")] = "text",
    select: Annotated[list[str] | None, typer.Option(help="Only rules whose code begins so.")] = None,
) -> None:
    """List the rules.

    \b
    Example: urdfctl rules --select UC2
    """
    from urdfctl.cli.rules_command import run_rules
    from urdfctl.cli.words import codes

    raise typer.Exit(run_rules(output_format, codes(select)))


@app.command(short_help="Tell what a rule finds, or what a message means.")
def explain(
    what: Annotated[
        list[str] | None,
        typer.Argument(
            help="A rule's code or name, a line of a log in quotes, or a log (- or a pipe).", show_default=False
        ),
    ] = None,
    output_format: Annotated[str, typer.Option("--format", help="text or json.")] = "text",
) -> None:
    """Tell what a rule finds, or what the messages of ROS and Gazebo mean: why they are printed, and what to do.

    \b
    Example: urdfctl explain UC201
             urdfctl explain "No p gain specified for pid."
             urdfctl explain gazebo.log
    """
    from urdfctl.cli.explain_command import run_explain

    raise typer.Exit(run_explain(what or [], output_format))


add_commands(app)
