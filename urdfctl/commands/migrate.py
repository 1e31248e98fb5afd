"""`urdfctl migrate`."""

from __future__ import annotations

import gc
import json
import os
from collections.abc import Sequence
from contextlib import closing

from urdfctl.catalog.distros import ALL, MAINTAINED, ROS2, SIMULATORS
from urdfctl.commands.answering import AnswerOptions, answered
from urdfctl.commands.declaring import CHECKED_FOR, CONTROLLERS, OTHER, OUTPUT, Command, Reads, argument, option
from urdfctl.commands.options import ReadingOptions
from urdfctl.commands.progress import with_progress
from urdfctl.commands.words import configured, settings_from
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.migrate.commits import check_repositories, commit_steps
from urdfctl.migrate.engine import MENDING, Migration, migrate
from urdfctl.migrate.fleet import PackageRow, as_page, as_text, rows_of
from urdfctl.migrate.fleet import as_json as table_as_json
from urdfctl.migrate.options import MigrationOptions, Part
from urdfctl.migrate.proof import commands_for
from urdfctl.migrate.report import as_json, as_markdown
from urdfctl.migrate.step import EntryKind
from urdfctl.migrate.steps import STEPS
from urdfctl.migrate.trial.linting import Lint
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.migrate.writing import write_changes, write_copy
from urdfctl.names import did_you_mean
from urdfctl.output.answer import CommandAnswer, FileState
from urdfctl.output.change import Change
from urdfctl.output.journal import restore_unfinished
from urdfctl.output.links import check_output
from urdfctl.output.patch import patch
from urdfctl.output.printing import print_bytes
from urdfctl.output.writing import encoded
from urdfctl.report.common import shown
from urdfctl.run.git import has_changes
from urdfctl.source.disk.gate import exists
from urdfctl.source.workspaces.package_folders import package_folders
from urdfctl.source.workspaces.packages import package_around
from urdfctl.startup.records import NamedTuple

REPORT = "MIGRATION.md"
_LAUNCH_FORMS = ("py", "xml")
_OBJECTS = 50_000
"""So many new objects start a garbage collection. Saves: a tenth of a run, which holds the models of all robots."""


_TARGETS = [distro for distro in MAINTAINED if distro != "noetic"]


class MigrateOptions(ReadingOptions, AnswerOptions):
    """Migrate packages to another ROS distro: from one ROS 2 distro to a later one, from Gazebo Classic to gz, from
    ROS 1 to ROS 2. Shows a diff and writes nothing, unless --in-place or -o is given.

    \b
    Example: urdfctl migrate . --to kilted
    """

    paths: tuple[str, ...] = argument(
        "Packages, or folders with packages. Default: the package around the current folder.", metavar="[PATH]..."
    )
    to: str | None = option(
        CHECKED_FOR, f"ROS distro to migrate to: {', '.join(_TARGETS)}.", choices=_TARGETS, metavar="DISTRO"
    )
    source: str | None = option(
        CHECKED_FOR,
        "ROS distro to migrate from. Default: detected from the files.",
        "--from",
        choices=ALL,
        metavar="DISTRO",
    )
    simulator: str | None = option(
        CHECKED_FOR,
        "Simulator after the migration. Default: the present one, or gz if that does not exist.",
        choices=SIMULATORS,
    )
    hardware: str | None = option(CONTROLLERS, "Plugin of the real hardware: PACKAGE/CLASS.", metavar="PLUGIN")
    diff: bool = option(OUTPUT, "Show the changes as a diff, the default. Exit with status 1 if there are any.")
    in_place: bool = option(OUTPUT, "Change the files.")
    commits: bool = option(
        OUTPUT, "Change the files, with one commit for each step. Nothing may be uncommitted before."
    )
    force: bool = option(OUTPUT, "Change files with uncommitted changes, and write to a folder that is not empty.")
    output: str | None = option(
        OUTPUT,
        "Write the migrated packages to this folder.",
        "-o",
        "--output",
        metavar="DIR",
        reads=Reads.TARGET,
    )
    only: tuple[str, ...] = option(
        CHECKED_FOR,
        "Migrate only these parts: urdf, yaml, launch, manifest, moveit; NAME,NAME.",
        choices=tuple(part.value for part in Part),
        metavar="NAME,...",
    )
    step: tuple[str, ...] = option(
        CHECKED_FOR, "Take only these steps, which --list names; NAME,NAME.", is_open=True, metavar="NAME,..."
    )
    skip: tuple[str, ...] = option(
        CHECKED_FOR, "Leave out these steps, which --list names; NAME,NAME.", is_open=True, metavar="NAME,..."
    )
    fail_on: str | None = option(
        OUTPUT, "Exit with status 1 if anything is left to a person: left.", choices=("left",), metavar="LEVEL"
    )
    launch: str = option(OTHER, "Form of new launch files: py or xml.", default="py", choices=_LAUNCH_FORMS)
    keep_classic: bool = option(OTHER, "Keep Gazebo Classic beside gz, behind a xacro argument.")
    report: str | None = option(
        OUTPUT,
        "Write the report to this file (.md or .json). Default: MIGRATION.md beside the packages.",
        metavar="FILE",
    )
    table: str | None = option(
        OUTPUT,
        "Write a table of the packages to this file: a page (.html), .json, or text. '-' prints it.",
        metavar="FILE",
    )
    list_changes: bool = option(
        OTHER, "List the changes between two distros with their authority, then exit.", "--list"
    )


def run_migrate(options: MigrateOptions) -> int:
    """Migrate packages, or show how, and return the exit status."""
    return answered("migrate", options, lambda answer: _migrate(options, answer))


def _migrate(options: MigrateOptions, answer: CommandAnswer) -> int:
    migration = migration_of(options)
    if options.list_changes:
        from urdfctl.migrate.table import table

        answer.text(table(STEPS, migration))
        return 0
    gc.set_threshold(_OBJECTS)
    paths = options.paths or [os.curdir]
    if sum([options.diff, options.in_place, options.commits, options.output is not None]) > 1:
        raise UserError("--diff, --in-place, --commits and -o exclude each other")
    answer.messages(restore_unfinished())
    with closing(Scratch(paths)) as scratch:
        _check_destination(options, [scratch.real(folder) for folder in scratch.folders])
        real = [scratch.real(folder) for folder in scratch.folders]
        if not any(package_around(folder) or next(package_folders(folder), None) for folder in real):
            where = ", ".join(paths)
            raise UserError(
                f"no package in {where}: migrate needs a package.xml, which says what ROS builds and installs"
            )
        migration = with_own_names(migration, scratch, options)
        result = migrate(scratch, migration, settings_in(scratch, options), Lint(scratch, with_progress), STEPS)
        return _finish(result, scratch, options, migration, answer)


def settings_in(scratch: Scratch, options: MigrateOptions) -> Settings:
    """Return the settings with which the copy of the packages is linted."""
    real = [scratch.real(folder) for folder in scratch.folders]
    settings = settings_from(configured(real, options), options)
    return settings._replace(
        distro=None, simulator=None, workspace=scratch.root, package_paths=(*settings.package_paths, *scratch.others)
    )


def with_own_names(migration: MigrationOptions, scratch: Scratch, options: MigrateOptions) -> MigrationOptions:
    """Return a migration that also knows the names of the project's own, and their successors."""
    config = configured([scratch.real(folder) for folder in scratch.folders], options)
    return migration._replace(successors=dict(config.successors))


def migration_of(options: MigrateOptions) -> MigrationOptions:
    """Return the migration that the options ask for. Raises UserError if they do not fit together."""
    if options.to is None:
        raise UserError("--to requires the distro to migrate to, e.g. --to jazzy")
    for name, distro, known in (("--to", options.to, _TARGETS), ("--from", options.source, ALL)):
        if distro is not None and distro not in known:
            raise UserError(f"{name}: {_why_not(distro, known)}; known are {', '.join(known)}")
    if options.source in ROS2 and ROS2.index(options.source) > ROS2.index(options.to):
        raise UserError(f"'{options.to}' is earlier than '{options.source}'; urdfctl migrates to later distros only")
    if options.simulator is not None and options.simulator not in SIMULATORS:
        near = did_you_mean(options.simulator, SIMULATORS)
        raise UserError(f"unknown simulator '{options.simulator}'{near}; known are {', '.join(SIMULATORS)}")
    if options.launch not in _LAUNCH_FORMS:
        raise UserError(f"--launch must be py or xml, not '{options.launch}'")
    if options.fail_on not in (None, "left"):
        raise UserError(f"--fail-on must be left, not '{options.fail_on}'")
    return MigrationOptions(
        target=options.to,
        source=options.source,
        simulator=options.simulator,
        hardware=options.hardware,
        launch=options.launch,
        keep_classic=options.keep_classic,
        only=_parts(options.only),
        steps=_steps("--step", options.step),
        skipped=_steps("--skip", options.skip),
    )


def _why_not(distro: str, known: Sequence[str]) -> str:
    """Why a distro is none to migrate to, or from."""
    if distro in ROS2:
        return f"support for '{distro}' has ended"
    return (
        f"'{distro}' is a distro of ROS 1"
        if distro in ALL
        else f"unknown distro '{distro}'{did_you_mean(distro, known)}"
    )


def _parts(texts: Sequence[str]) -> frozenset[Part]:
    names = [name.strip() for text in texts for name in text.split(",") if name.strip()]
    known = [part.value for part in Part]
    for name in names:
        if name not in known:
            raise UserError(f"--only: unknown part '{name}'{did_you_mean(name, known)}; known are {', '.join(known)}")
    return frozenset(map(Part, names))


def _steps(option_name: str, texts: Sequence[str]) -> frozenset[str]:
    names = [name.strip() for text in texts for name in text.split(",") if name.strip()]
    known = [*(step.name for step in STEPS), *MENDING]
    for name in names:
        if name not in known:
            raise UserError(f"{option_name}: unknown step '{name}'{did_you_mean(name, known)}; --list names the steps")
    return frozenset(names)


def _check_destination(options: MigrateOptions, folders: Sequence[str]) -> None:
    """Raise UserError if files would be lost, or written outside of the workspace."""
    check_output(options.output, options.report, None if options.table == "-" else options.table)
    if options.commits:
        check_repositories(folders)
    if options.force:
        return
    if options.output is not None and os.path.isdir(options.output) and os.listdir(options.output):
        raise UserError(f"folder '{options.output}' is not empty; --force writes to it")
    if options.in_place and (dirty := [folder for folder in folders if has_changes(folder)]):
        raise UserError(f"'{dirty[0]}' has changes that are not committed; commit them, or use --force")


class _Written(NamedTuple):
    """What is written of a migration, and where to: the folder that paths are relative to, the report, its commands."""

    base: str
    report: tuple[str, bytes] | None
    proof: Sequence[str]


def _finish(
    result: Migration, scratch: Scratch, options: MigrateOptions, migration: MigrationOptions, answer: CommandAnswer
) -> int:
    """Write the result where the user wants it, and return the exit status."""
    is_written = _is_written(options)
    made = _reported(result, scratch, options, migration)
    if options.output is not None:
        problems = write_copy(scratch, made.base, options.output, made.report)
    elif options.commits:
        problems = commit_steps(result, STEPS, migration.target, made.report)
    elif options.in_place:
        problems = write_changes(result.changes, made.report)
    else:
        _show(result.changes, answer)
        problems = write_changes((), made.report)
    if not problems and options.table:
        rows = rows_of([scratch.real(folder) for folder in scratch.folders], result.lines, made.base)
        problems = _write_table(options.table, rows, migration.target, answer)
    answer.messages(problems)
    if problems:
        return 2
    text = as_json(result.lines, migration.source, migration.target, made.base, made.proof)
    answer.add(migration=json.loads(text))
    _keep_written(result.changes if is_written else (), made, options.output, answer)
    counts = {kind: sum(line.kind is kind for line in result.lines) for kind in EntryKind}
    verb = "changed" if is_written else "would change"
    files = f"{len(result.changes)} file{'s' * (len(result.changes) != 1)}"
    decided = counts[EntryKind.DECIDED]
    answer.message(
        f"{verb} {files}: {counts[EntryKind.DONE]} applied, {decided} choice{'s' * (decided != 1)} made, "
        f"{counts[EntryKind.FOR_YOU]} left to you{f' (see {made.report[0]})' if made.report else ''}"
    )
    is_failed = options.fail_on == "left" and counts[EntryKind.FOR_YOU] > 0
    return int(is_failed or (bool(result.changes) and not is_written))


def _write_table(path: str, rows: Sequence[PackageRow], target: str, answer: CommandAnswer) -> list[str]:
    """Write the table of the packages, or print it; return what prevented it."""
    if path == "-":
        answer.text(as_text(rows))
        return []
    is_page, is_json = path.endswith((".html", ".htm")), path.endswith(".json")
    text = as_page(rows, target) if is_page else table_as_json(rows, target) if is_json else as_text(rows)
    problems = write_changes((), (path, encoded(text)))
    if not problems:
        answer.file(path, FileState.WRITTEN)
    return problems


def _is_written(options: MigrateOptions) -> bool:
    return options.in_place or options.commits or options.output is not None


def _reported(result: Migration, scratch: Scratch, options: MigrateOptions, migration: MigrationOptions) -> _Written:
    """The report of a migration, if there is one to write. UserError if it cannot be written there."""
    scratch.check()
    base = os.path.commonpath([scratch.real(folder) for folder in scratch.folders])
    is_written = _is_written(options)
    path = options.report or (os.path.join(options.output or base, REPORT) if is_written else None)
    check_output(path)
    proof = commands_for(scratch, result.changes, migration.target, base)
    is_new = path is not None and (bool(options.report) or not exists(path))
    if path is None or not (result.changes or (is_new and result.lines)):
        return _Written(base, None, proof)
    if os.path.isdir(path):
        raise UserError(f"'{path}' is a folder")
    render = as_json if path.endswith(".json") else as_markdown
    text = render(result.lines, migration.source, migration.target, base, proof)
    return _Written(base, (path, encoded(text)), proof)


def _show(changes: Sequence[Change], answer: CommandAnswer) -> None:
    """Print the changes as a patch, or keep those of each file."""
    if not answer.is_kept:
        print_bytes(patch(changes))
        return
    for change in changes:
        answer.out_of_date(shown(change.file), patch([change]).decode("utf-8", "surrogateescape"))


def _keep_written(changes: Sequence[Change], made: _Written, output: str | None, answer: CommandAnswer) -> None:
    """Keep which files were written, in place or in a copy."""
    for change in changes:
        path = os.path.join(output, os.path.relpath(change.file, made.base)) if output else shown(change.file)
        answer.file(path, FileState.WRITTEN)
    if made.report is not None:
        answer.file(made.report[0], FileState.WRITTEN)


command = Command(MigrateOptions, run_migrate)
