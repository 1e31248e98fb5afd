"""`urdfctl schema`."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from urdfctl.catalog.distros import ALL, generation
from urdfctl.commands.answering import AnswerOptions, answered
from urdfctl.commands.declaring import CHECKED_FOR, OUTPUT, Command, Reads, argument, option
from urdfctl.config.settings import Settings, validate_settings
from urdfctl.errors import UserError
from urdfctl.output.answer import CommandAnswer
from urdfctl.output.printing import visible
from urdfctl.report.common import shown
from urdfctl.schemas.controllers import controllers_schema
from urdfctl.schemas.robot import ros2_control_schema, urdf_schema
from urdfctl.source.disk.files import FileProblem, Files, is_yaml

if TYPE_CHECKING:
    from urdfctl.schemas.checking import SchemaFault
    from urdfctl.source.span import SourceText

KINDS = ("controllers", "ros2_control", "urdf")
_CONTROL = re.compile(rb"<ros2_control\b")


class SchemaOptions(AnswerOptions):
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
    return answered("schema", options, lambda answer: _schema_or_faults(options, answer))


def _schema_or_faults(options: SchemaOptions, answer: CommandAnswer) -> int:
    if options.kind is not None and options.kind not in KINDS:
        raise UserError(f"there is no schema of '{options.kind}'; known are {', '.join(KINDS)}")
    if not options.checked:
        if options.kind is None:
            raise UserError(f"name what the schema is of: {', '.join(KINDS)}; or a file with --check")
        text = _schema(options.kind, options)
        if answer.is_kept and options.kind == "controllers":
            answer.add(schema=json.loads(text))
        else:
            answer.text(text)
        return 0
    faults = [fault for path in options.checked for fault in _placed_faults(_source(path), options)]
    answer.add(faults=faults)
    if not answer.is_kept:
        lines = (f"{at['file']}:{at['line']}:{at['column']}: {at['message']}" for at in faults)
        answer.text("".join(f"{visible(line)}\n" for line in lines))
    return 1 if faults else 0


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


def _placed_faults(source: SourceText, options: SchemaOptions) -> Iterator[dict[str, Any]]:
    """Yield what does not fit in a file, each with its place, as plain data."""
    for fault in _faults(source, options):
        at = source.position(fault.at.start)
        yield {"file": shown(source.path), "line": at.line, "column": at.column, "message": fault.message}


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
