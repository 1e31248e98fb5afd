"""`urdfctl doctor`: what is wrong in a running system."""

from __future__ import annotations

from urdfctl.commands.declaring import OUTPUT, Command, argument, option
from urdfctl.commands.options import TEXT_OR_JSON, TargetOptions
from urdfctl.commands.robot_targets import robots_of
from urdfctl.commands.words import configured, output_of, settings_from, split_arguments
from urdfctl.doctor.recording import read_recording
from urdfctl.doctor.report import json_of, text_of
from urdfctl.doctor.run import doctor
from urdfctl.errors import UserError
from urdfctl.output.printing import print_text
from urdfctl.output.writing import write_file


class DoctorOptions(TargetOptions):
    """Say what is wrong in a running system: compare a recording of it with the files, and name the cause first.

    \b
    Example: urdfctl doctor snapshot.json
    """

    words: tuple[str, ...] = argument(
        "The recording, then the files or folders of what was started (default: the package around the current "
        "folder), and name:=value arguments.",
        metavar="SNAPSHOT.json [PATH]... [NAME:=VALUE]...",
        is_required=True,
    )
    output_format: str = option(
        OUTPUT,
        "Output format: text or json. FORMAT=FILE writes a file.",
        "--format",
        default="text",
        choices=TEXT_OR_JSON,
    )


def run_doctor(options: DoctorOptions) -> int:
    """Print what is wrong, and return the exit status: 1 if anything is, otherwise 0."""
    paths, arguments = split_arguments(options.words)
    output, file = output_of(options.output_format, TEXT_OR_JSON)
    if not paths:
        raise UserError("doctor needs a recording: urdfctl doctor SNAPSHOT.json")
    recording = read_recording(paths[0])
    config = configured(paths[1:], options)
    distro = options.distro or config.distro or recording.distro
    settings = settings_from(config, options, distro=distro, simulator=options.simulator, named=paths[1:])
    given = [f"{name}:={value}" for name, value in arguments.items()]
    report = doctor(recording, robots_of([*paths[1:], *given], config, settings), settings)
    text = json_of(report) if output == "json" else text_of(report)
    if file is not None:
        write_file(file, text, force=True)
    else:
        print_text(text)
    return int(bool(report.ailments))


command = Command(DoctorOptions, run_doctor)
