"""`urdfctl schema`."""

from __future__ import annotations

import json
import os
import re
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import ALL, generation
from urdfctl.commands.declaring import CHECKED_FOR, OUTPUT, Command, Options, Reads, argument, option
from urdfctl.config.settings import Settings, validate_settings
from urdfctl.errors import UserError
from urdfctl.output.printing import print_text, visible
from urdfctl.report.common import shown
from urdfctl.schemas.controllers import controllers_schema
from urdfctl.schemas.robot import ros2_control_schema, urdf_schema
from urdfctl.source.disk.files import FileProblem, Files, is_yaml

if TYPE_CHECKING:
    from urdfctl.schemas.checking import SchemaFault
    from urdfctl.source.span import SourceText

KINDS = ("controllers", "ros2_control", "urdf")
_CONTROL = re.compile(rb"<ros2_control\b")


class SchemaOptions(Options):
    """Print a schema of controller files, <ros2_control> or URDF for your editor, or check files with it.

    \b
    Example: urdfctl schema controllers --distro jazzy > controllers.schema.json
             urdfctl schema --check config/controllers.yaml --distro jazzy
    """

    kind: str | None = argument(
        "controllers: JSON Schema 2020-12 of controller files; ros2_control: XML Schema of a robot with "
        "<ros2_control>; urdf: XML Schema of URDF. Default with --check: from the file.",
        choices=KINDS,
        reads=Reads.NOTHING,
    )
    distro: str | None = option(CHECKED_FOR, "ROS distro. Default: $ROS_DISTRO.", choices=ALL, metavar="DISTRO")
    checked: tuple[str, ...] = option(
        OUTPUT, "Check this file, and print what does not fit.", "--check", metavar="FILE", reads=Reads.WORKSPACE
    )


def run_schema(options: SchemaOptions) -> int:
    """Print a schema, or what does not fit it; return the exit status: 1 if anything does not fit."""
    if options.kind is not None and options.kind not in KINDS:
        raise UserError(f"there is no schema of '{options.kind}'; known are {', '.join(KINDS)}")
    if not options.checked:
        if options.kind is None:
            raise UserError(f"name what the schema is of: {', '.join(KINDS)}; or a file with --check")
        print_text(_schema(options.kind, options))
        return 0
    sources = [_source(path) for path in options.checked]
    lines = [line for source in sources for line in _lines(source, options)]
    print_text("".join(f"{visible(line)}\n" for line in lines))
    return 1 if lines else 0


def _schema(kind: str, options: SchemaOptions) -> str:
    if kind == "urdf":
        return urdf_schema()
    if kind == "ros2_control":
        return ros2_control_schema(_distro(options))
    return json.dumps(controllers_schema(_distro(options)), indent=1, ensure_ascii=False) + "\n"


def _distro(options: SchemaOptions) -> str:
    distro = options.distro or os.environ.get("ROS_DISTRO")
    if not distro:
        raise UserError("the schema depends on the distro; name it: --distro jazzy")
    validate_settings(Settings(distro=distro))
    return distro


def _source(path: str) -> SourceText:
    try:
        return Files().read(path)
    except FileProblem as problem:
        raise UserError(str(problem)) from None


def _lines(source: SourceText, options: SchemaOptions) -> list[str]:
    lines = []
    for fault in _faults(source, options):
        position = source.position(fault.at.start)
        lines.append(f"{shown(source.path)}:{position.line}:{position.column}: {fault.message}")
    return lines


def _faults(source: SourceText, options: SchemaOptions) -> list[SchemaFault]:
    from urdfctl.schemas.checking import faults_in_controllers, faults_in_robot

    if (options.kind or "controllers") == "controllers" and is_yaml(source.path):
        return faults_in_controllers(source, _distro(options))
    if options.kind == "controllers":
        raise UserError(f"{source.path} is not a YAML file")
    has_control = options.kind is None and _CONTROL.search(source.data) is not None
    if options.kind == "ros2_control" or (has_control and generation(_distro(options)) == 2):  # noqa: PLR2004
        return faults_in_robot(source, ros2_control_schema(_distro(options)))
    return faults_in_robot(source, urdf_schema())


command = Command(SchemaOptions, run_schema)
