"""`urdfctl migrate`."""

from __future__ import annotations

import gc
import os
import subprocess
from collections.abc import Sequence
from contextlib import closing

from urdfctl.catalog.distros import ALL, ROS2, SIMULATORS
from urdfctl.cli.journal import restore_unfinished
from urdfctl.cli.migrate_lint import Lint
from urdfctl.cli.migrate_options import MigrateOptions
from urdfctl.cli.migrate_writing import write_changes, write_copy
from urdfctl.cli.patch import patch
from urdfctl.cli.words import configured, settings_from
from urdfctl.cli.writing import encoded, print_bytes, print_message, print_text
from urdfctl.errors import UserError
from urdfctl.migrate.engine import Migration, migrate
from urdfctl.migrate.report import as_json, as_markdown
from urdfctl.migrate.scratch import Scratch
from urdfctl.migrate.step import EntryKind
from urdfctl.migrate.steps import STEPS
from urdfctl.migrate.wishes import Part, Wishes
from urdfctl.names import did_you_mean

REPORT = "MIGRATION.md"
_OBJECTS = 50_000
"""So many new objects start a garbage collection. Saves: a tenth of a run, which holds the models of all robots."""


def run_migrate(options: MigrateOptions) -> int:
    """Migrate packages, or show how, and return the exit status."""
    wishes = _wishes(options)
    if options.list_changes:
        from urdfctl.migrate.table import table

        print_text(table(STEPS, wishes))
        return 0
    gc.set_threshold(_OBJECTS)
    paths = options.paths or [os.curdir]
    if sum([options.diff, options.in_place, options.output is not None]) > 1:
        raise UserError("--diff, --in-place and -o exclude each other")
    restore_unfinished()
    with closing(Scratch(paths)) as scratch:
        real = [scratch.real(folder) for folder in scratch.folders]
        _check_destination(options, real)
        settings = settings_from(configured(real, options), options)
        settings = settings._replace(
            distro=None,
            simulator=None,
            workspace=scratch.root,
            package_paths=(*settings.package_paths, *scratch.others),
        )
        result = migrate(scratch, wishes, settings, Lint(scratch), STEPS)
        return _finish(result, scratch, options, wishes)


def _wishes(options: MigrateOptions) -> Wishes:
    if options.to is None:
        raise UserError("--to requires the distro to migrate to, e.g. --to jazzy")
    for name, distro, known in (("--to", options.to, ROS2), ("--from", options.source, ALL)):
        if distro is not None and distro not in known:
            raise UserError(
                f"{name}: unknown distro '{distro}'{did_you_mean(distro, known)}; known are {', '.join(known)}"
            )
    if options.source in ROS2 and ROS2.index(options.source) > ROS2.index(options.to):
        raise UserError(f"'{options.to}' is earlier than '{options.source}'; urdfctl migrates to later distros only")
    if options.simulator is not None and options.simulator not in SIMULATORS:
        near = did_you_mean(options.simulator, SIMULATORS)
        raise UserError(f"unknown simulator '{options.simulator}'{near}; known are {', '.join(SIMULATORS)}")
    if options.launch not in ("py", "xml"):
        raise UserError(f"--launch must be py or xml, not '{options.launch}'")
    return Wishes(
        target=options.to,
        source=options.source,
        simulator=options.simulator,
        hardware=options.hardware,
        launch=options.launch,
        keep_classic=options.keep_classic,
        only=_parts(options.only or ()),
    )


def _parts(texts: Sequence[str]) -> frozenset[Part]:
    names = [name.strip() for text in texts for name in text.split(",") if name.strip()]
    known = [part.value for part in Part]
    for name in names:
        if name not in known:
            raise UserError(f"--only: unknown part '{name}'{did_you_mean(name, known)}; known are {', '.join(known)}")
    return frozenset(map(Part, names))


def _check_destination(options: MigrateOptions, folders: Sequence[str]) -> None:
    """Raise UserError if files would be lost."""
    if options.force:
        return
    if options.output is not None and os.path.isdir(options.output) and os.listdir(options.output):
        raise UserError(f"folder '{options.output}' is not empty; --force writes to it")
    if options.in_place and (dirty := [folder for folder in folders if _is_dirty(folder)]):
        raise UserError(f"'{dirty[0]}' has changes that are not committed; commit them, or use --force")


def _is_dirty(folder: str) -> bool:
    """Return whether git knows of uncommitted changes in a folder; False without git or a repository."""
    command = ["git", "-c", "core.fsmonitor=false", "-C", folder, "status", "--porcelain", "--", "."]
    try:
        status = subprocess.run(command, capture_output=True, check=False, env={**os.environ, "LC_ALL": "C"})  # noqa: S603 (no input of others)
    except OSError:
        return False
    return status.returncode == 0 and bool(status.stdout.strip())


def _finish(result: Migration, scratch: Scratch, options: MigrateOptions, wishes: Wishes) -> int:
    """Write the result where the user wants it, and return the exit status."""
    base = os.path.commonpath([scratch.real(folder) for folder in scratch.folders])
    is_written = options.in_place or options.output is not None
    path = options.report or (os.path.join(options.output or base, REPORT) if is_written else None)
    is_reported = path is not None and bool(result.changes or (options.report and result.lines))
    render = as_json if path and path.endswith(".json") else as_markdown
    text = encoded(render(result.lines, wishes.source, wishes.target, base)) if is_reported else b""
    report = (path, text) if path is not None and is_reported else None
    if report is not None and os.path.isdir(report[0]):
        raise UserError(f"'{report[0]}' is a folder")
    if options.output is not None:
        problems = write_copy(scratch, base, options.output, report)
    elif options.in_place:
        problems = write_changes(result.changes, report)
    else:
        print_bytes(patch(result.changes))
        problems = write_changes((), report)
    for problem in problems:
        print_message(problem)
    if problems:
        return 2
    counts = {kind: sum(line.kind is kind for line in result.lines) for kind in EntryKind}
    verb = "changed" if is_written else "would change"
    files = f"{len(result.changes)} file{'s' * (len(result.changes) != 1)}"
    print_message(
        f"{verb} {files}; {counts[EntryKind.DONE]} done, {counts[EntryKind.DECIDED]} decided, "
        f"{counts[EntryKind.FOR_YOU]} for you{f' (see {path})' if is_reported else ''}"
    )
    return int(bool(result.changes) and not is_written)
