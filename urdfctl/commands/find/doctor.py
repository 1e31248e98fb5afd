"""`urdfctl doctor`: what is wrong in a running system."""

from __future__ import annotations

import time

from urdfctl.commands.declaring import CHECKED_FOR, LIMITS, OUTPUT, Command, Reads, argument, option
from urdfctl.commands.options import TEXT_OR_JSON, TargetOptions
from urdfctl.commands.progress import with_progress
from urdfctl.commands.robot_targets import robots_of
from urdfctl.commands.words import configured, output_of, settings_from, split_arguments
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.doctor.collecting import SystemSilent, collected
from urdfctl.doctor.log import Log, read_log
from urdfctl.doctor.recording import Recording, read_recording, recording_of
from urdfctl.doctor.report import json_of, text_of
from urdfctl.doctor.run import doctor
from urdfctl.errors import UserError
from urdfctl.output.printing import print_message, print_text
from urdfctl.output.writing import write_file
from urdfctl.startup.records import NamedTuple

_PAUSE = 1.0
"""Seconds between two questions to a system that does not answer."""


class DoctorOptions(TargetOptions):
    """Say what is wrong in a running system: compare a recording of it with the files, and name the cause first.

    \b
    Example: urdfctl doctor now.json --in .
             urdfctl doctor --snapshot now.json
    """

    words: tuple[str, ...] = argument(
        "A recording (default: the system that runs here is recorded, with the Python in which ROS is sourced), and "
        "name:=value arguments of the robot.",
        metavar="[SNAPSHOT.json] [NAME:=VALUE]...",
        reads=Reads.PLACE,
    )
    folders: tuple[str, ...] = option(
        CHECKED_FOR,
        "File or folder of what was started. Default: the package around the current folder.",
        "--in",
        metavar="PATH",
        reads=Reads.WORKSPACE,
    )
    snapshot: str | None = option(
        OUTPUT, "Write what was recorded to this file.", "--snapshot", metavar="FILE.json", reads=Reads.TARGET
    )
    log: str | None = option(
        CHECKED_FOR,
        "Log of what was started: its lines say why a controller or hardware failed.",
        "--log",
        metavar="FILE",
        reads=Reads.PLACE,
    )
    watch: bool = option(OUTPUT, "Record again and again, and tell what changed, until nothing is wrong.", "--watch")
    seconds: float = option(LIMITS, "Seconds for which topics are listened to.", "--seconds", default=2.0)
    private: bool = option(
        OUTPUT, "Record private parameters too: serial numbers, names of hosts and users, passwords.", "--private"
    )
    report: str | None = option(
        OUTPUT,
        "Write a page with what is wrong, what is really wired, and the robot.",
        metavar="FILE.html",
        reads=Reads.TARGET,
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
    wanted = _wanted(options)
    paths, _ = split_arguments(options.words)
    if len(paths) > 1:
        raise UserError("doctor reads one recording: urdfctl doctor SNAPSHOT.json; --in names the files it is about")
    if not options.watch:
        return _examined(wanted, options, read_recording(paths[0]) if paths else _recorded(options))[1]
    if paths:
        raise UserError("--watch records the system that runs here; it does not go with a recording")
    return _watched(wanted, options)


class _Wanted(NamedTuple):
    """What the words and the configuration say.

    output: the format, and the file for it if it is not printed. began: when, as time.monotonic() tells it.
    """

    config: Config
    settings: Settings
    output: tuple[str, str | None]
    began: float


def _wanted(options: DoctorOptions) -> _Wanted:
    """Judge the words, before anything is read or asked."""
    output = output_of(options.output_format, TEXT_OR_JSON)
    config = configured(options.folders, options)
    settings = settings_from(config, options, distro=options.distro, simulator=options.simulator, named=options.folders)
    return _Wanted(config, settings, output, time.monotonic())


def _examined(wanted: _Wanted, options: DoctorOptions, recording: Recording, told: str = "") -> tuple[str, int]:
    """Write what is wrong, if it differs from what was told; return it, and the exit status."""
    _, arguments = split_arguments(options.words)
    config, settings, (output, file), began = wanted
    if not (options.distro or config.distro):
        settings = settings._replace(distro=recording.distro)
    log = read_log(options.log, settings.distro) if options.log else Log()
    given = [f"{name}:={value}" for name, value in arguments.items()]
    report = doctor(recording, robots_of([*options.folders, *given], config, settings), settings, log)
    if options.report is not None:
        from urdfctl.page.writing import write_doctor_page

        write_doctor_page(options.report, report, recording, settings, began=began, watch=with_progress)
    text = json_of(report) if output == "json" else text_of(report)
    if file is not None:
        write_file(file, text, force=True)
    elif text != told:
        print_text(text)
    return text, int(bool(report.ailments))


def _watched(wanted: _Wanted, options: DoctorOptions) -> int:
    """Examine the system that runs here until nothing is wrong in it, or the user has seen enough."""
    told, status = "", 1
    try:
        while status:
            try:
                told, status = _examined(wanted, options, _recorded(options), told)
            except SystemSilent as error:
                if str(error) != told:
                    told = str(error)
                    print_message(told)
                time.sleep(_PAUSE)
    except KeyboardInterrupt:
        return status
    return status


def _recorded(options: DoctorOptions) -> Recording:
    """The recording of the system that runs here, which is also written if the user wants it."""
    text = collected(options.seconds, is_private=options.private)
    if options.snapshot is not None:
        write_file(options.snapshot, text, force=True)
        if not options.watch:
            print_message(
                f"the recording is in '{options.snapshot}': urdfctl doctor {options.snapshot} reads it without ROS"
            )
    return recording_of(options.snapshot or "the recording", text)


command = Command(DoctorOptions, run_doctor)
