"""Options that several commands have, each declared once."""

from __future__ import annotations

from urdfctl.catalog.distros import ALL, SIMULATORS
from urdfctl.commands.declaring import CHECKED_FOR, EXIT, LIMITS, OUTPUT, Options, Reads, argument, option
from urdfctl.diagnostic import Severity

SEVERITIES = tuple(severity.value for severity in Severity)
TEXT_OR_JSON = ("text", "json")
FORMAT = "Output format. FORMAT=FILE writes a file."


class ReadingOptions(Options):
    """Options of every command that reads a robot."""

    workspace: str | None = option(LIMITS, "Folder outside of which nothing is read.", metavar="FOLDER")
    package_path: tuple[str, ...] = option(
        LIMITS, "Folder with packages, searched first.", metavar="FOLDER", reads=Reads.PLACE
    )
    env: tuple[str, ...] = option(LIMITS, "Environment variable that $(env NAME) may read.", metavar="NAME")
    trust: bool = option(LIMITS, "Read any file and evaluate any expression.")
    timeout: float = option(LIMITS, "Processor time for one robot, in seconds.", default=20.0, metavar="SECONDS")
    memory: int = option(LIMITS, "Memory limit for one robot, in MiB.", default=2048, metavar="MIB")
    config: str | None = option(
        LIMITS,
        "Configuration file. Default: the nearest urdfctl.toml or pyproject.toml.",
        metavar="FILE",
        reads=Reads.PLACE,
    )


class TargetOptions(ReadingOptions):
    """Options of every command that checks a robot for a distro and a simulator."""

    distro: str | None = option(
        CHECKED_FOR,
        f"ROS distro: {', '.join(ALL)}. Default: detected from the files.",
        choices=ALL,
        metavar="DISTRO",
    )
    simulator: str | None = option(
        CHECKED_FOR, "Simulator to check against. Default: detected from plugins.", choices=SIMULATORS
    )


class StartOptions(TargetOptions):
    """Options of every command that is about robots and what is started together."""

    paths: tuple[str, ...] = argument(
        "Robots, controller files, launch files, folders, and name:=value arguments. Default: the package around the "
        "current folder.",
        metavar="[PATH]... [NAME:=VALUE]...",
    )
    start: str | None = option(
        CHECKED_FOR, "Controllers that are started together, in this order: NAME,NAME, or all.", metavar="NAME,..."
    )


class CheckOptions(StartOptions):
    """Options of every command that checks many robots."""

    jobs: int = option(
        LIMITS,
        "How many robots to check at the same time. 0: one for each processor.",
        default=0,
        metavar="N",
    )
    shard: str | None = option(LIMITS, "Check only one of N equal shares of the files, e.g. 2/5.", metavar="K/N")


class ReportOptions(Options):
    """Options of the commands that report findings: how, and what makes them fail."""

    formats: tuple[str, ...] = option(OUTPUT, FORMAT, "--format", choices=TEXT_OR_JSON)
    output_file: str | None = option(
        OUTPUT,
        "Write the report to this file, not to standard output.",
        "-o",
        "--output-file",
        metavar="FILE",
    )
    quiet: bool = option(OUTPUT, "Show only the findings.", "-q", "--quiet")
    verbose: bool = option(OUTPUT, "Show info too where there are errors or warnings.", "-v", "--verbose")
    statistics: bool = option(OUTPUT, "Count the findings of each rule.")
    report: str | None = option(
        OUTPUT,
        "Write an HTML page with the robots, what is wired to what, and the findings to this file.",
        metavar="FILE",
    )
    fail_on: str | None = option(
        EXIT,
        "Exit with status 1 on findings of this severity or worse. Default: error.",
        choices=SEVERITIES,
    )
    baseline: str | None = option(
        EXIT,
        "Hide the findings listed in this file, and report those that are fixed.",
        metavar="FILE",
        reads=Reads.PLACE,
    )
    write_baseline: str | None = option(
        EXIT, "Write all findings to this file, for --baseline.", metavar="FILE", reads=Reads.TARGET
    )
    exit_zero: bool = option(EXIT, "Exit with status 0 whatever is found.")
