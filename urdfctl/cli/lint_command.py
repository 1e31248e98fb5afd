"""`urdfctl lint`."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, NamedTuple

from urdfctl.cli.progress import watched
from urdfctl.cli.wanted import Fixing, Wanted, found_in
from urdfctl.cli.words import codes, configured, settings_from, split_arguments
from urdfctl.cli.writing import print_text, write_file
from urdfctl.config import Config
from urdfctl.diagnostic import Severity
from urdfctl.discover import Found, find
from urdfctl.errors import UserError
from urdfctl.lint import Linted, Selection, worst
from urdfctl.lint import checked as checked_selection
from urdfctl.load import Target, lint_all
from urdfctl.report import FORMATS, render
from urdfctl.report.common import Report
from urdfctl.settings import Settings
from urdfctl.suggest import did_you_mean

if TYPE_CHECKING:
    from urdfctl.cli.known_findings import Baseline


def lint_words(  # noqa: PLR0913, PLR0917 (one for each option)
    paths: list[str] | None = None,
    distro: str | None = None,
    simulator: str | None = None,
    start: str | None = None,
    workspace: str | None = None,
    package_path: list[str] | None = None,
    env: list[str] | None = None,
    trust: bool = False,  # noqa: FBT001, FBT002
    timeout: float = 20.0,
    memory: int = 2048,
    select: list[str] | None = None,
    ignore: list[str] | None = None,
    extend_select: list[str] | None = None,
    formats: list[str] | None = None,
    fail_on: str | None = None,
    baseline: str | None = None,
    write_baseline: str | None = None,
    statistics: bool = False,  # noqa: FBT001, FBT002
    exit_zero: bool = False,  # noqa: FBT001, FBT002
    jobs: int = 0,
    config: str | None = None,
    fix: bool = False,  # noqa: FBT001, FBT002
    unsafe_fixes: bool = False,  # noqa: FBT001, FBT002
    diff: bool = False,  # noqa: FBT001, FBT002
) -> int:
    """Lint with the options of the command line, report it, and give the exit status."""
    if jobs < 0:
        raise UserError(f"--jobs is a number of robots, or 0 for as many as there are processors; not {jobs}")
    chosen = configured(paths, config, workspace)
    settings = settings_from(chosen, distro, simulator, start, workspace, package_path, env, trust, timeout, memory)
    wanted = Wanted(
        tuple(paths or ()),
        _selection(chosen, codes(select), codes(ignore), codes(extend_select)),
        tuple(_output(text) for text in formats or ("text",)),
        _severity(fail_on or chosen.fail_on or "error"),
        exit_zero,
        jobs,
        chosen,
        _baseline(baseline, write_baseline),
        statistics,
        Fixing(unsafe_fixes, diff) if fix or unsafe_fixes or diff else None,
    )
    return run_lint(wanted, settings)


def run_lint(wanted: Wanted, settings: Settings) -> int:
    """Lint what the words mean, report it, and give the exit status."""
    paths, arguments = split_arguments(wanted.words)
    found = find(paths, wanted.config.excludes)
    if not (found.descriptions() or found.controllers or found.launches or found.controllers_candidates):
        sys.stderr.write(f"urdfctl: no robot found in {', '.join(paths) or 'this folder'}\n")
    looked_at = _linted(found, tuple(arguments.items()), settings, wanted)
    if wanted.fixing is None:
        return _status(_report(looked_at, wanted), looked_at, wanted)
    from urdfctl.cli.fix_command import fix, tell_of

    done, before = fix(looked_at.all, settings, wanted, wanted.fixing), looked_at
    if wanted.fixing.as_diff:
        _report(looked_at, wanted)
        tell_of(done.files, before.linted, done.left, wanted, wanted.fixing)
        return 3 if looked_at.crashed else int(done.files > 0 and not wanted.exit_zero)
    looked_at = _linted(found, tuple(arguments.items()), settings, wanted) if done.files else before
    report = _report(looked_at, wanted)
    tell_of(done.files, before.linted, looked_at.linted, wanted, wanted.fixing)
    return _status(report, looked_at, wanted)


def _status(report: Report, looked_at: LookedAt, wanted: Wanted) -> int:
    if looked_at.crashed:
        return 3
    gravest = worst(report.findings)
    return int(gravest is not None and gravest.weight >= wanted.fail_on.weight and not wanted.exit_zero)


class LookedAt(NamedTuple):
    """The robots, and all that was looked at: in folders also the macro libraries, fragments and controllers' files
    that no robot uses."""

    robots: list[Linted]
    all: list[tuple[Target, Linted]]

    @property
    def linted(self) -> list[Linted]:
        """What came of each."""
        return [one for _, one in self.all]

    @property
    def crashed(self) -> bool:
        """Whether urdfctl itself was at fault anywhere."""
        return any(one.outcome.crashed for one in self.linted)


def _report(looked_at: LookedAt, wanted: Wanted) -> Report:
    """The report, told as is wanted; on standard output stands the diff, where one is shown."""
    findings = found_in(looked_at.linted, wanted)
    told = findings
    if wanted.baseline is not None:
        read = {file for linted in looked_at.linted for file in linted.files}
        told = wanted.baseline.unknown(findings, read, wanted.selection)
    others, known = len(looked_at.all) - len(looked_at.robots), len(findings) - len(told)
    report = Report(tuple(looked_at.robots), tuple(told), others, wanted.fail_on, known, wanted.statistics)
    for name, file in wanted.outputs:
        if file is not None or not (wanted.fixing and wanted.fixing.as_diff):
            _tell(report, name, file)
    return report


def _linted(found: Found, arguments: tuple[tuple[str, str], ...], settings: Settings, wanted: Wanted) -> LookedAt:
    """What the words mean, linted."""

    def linted(targets: list[Target]) -> Iterator[tuple[Target, Linted]]:
        found = lint_all(targets, settings, wanted.selection, wanted.jobs or None)
        return zip(targets, watched(found, len(targets)), strict=True)

    targets, kept = _targets(found, arguments)
    all_kept = [pair for pair, keep in zip(linted(targets), kept, strict=True) if keep(pair[1])]
    read = {file for _, one in all_kept for file in one.files}
    all_kept += linted([Target(path) for path in found.controllers if os.path.abspath(path) not in read])
    read |= {os.path.abspath(path) for path in found.controllers}
    alone = [Target(path) for path in found.controllers_candidates if os.path.abspath(path) not in read]
    rest = [Target(path, fragment=True) for path in found.unread(read)]
    robotless = {os.path.abspath(path) for path in found.launch_candidates}
    robots = [one for _, one in all_kept if one.path not in robotless]
    return LookedAt(robots, [*all_kept, *linted([*rest, *alone])])


def _targets(
    found: Found, arguments: tuple[tuple[str, str], ...]
) -> tuple[list[Target], list[Callable[[Linted], bool]]]:
    """What is to be linted, and of each what tells whether it is worth to be told of. What is named beside a single
    robot belongs to it."""
    descriptions = found.descriptions()
    targets: list[Target] = []
    kept: list[Callable[[Linted], bool]] = []
    single = len(descriptions) == 1
    controllers = tuple(found.controllers) if single else ()
    for path, named in descriptions:
        for launch in (found.launches if single else ()) or (None,):
            targets.append(Target(path, arguments, controllers=controllers, launch=launch))
            kept.append(_always if named else _is_robot)
    if not single:
        targets += [Target(path, arguments) for path in found.launches]
        kept += [_always] * len(found.launches)
    targets += [Target(path) for path in found.launch_candidates]
    kept += [_has_controllers] * len(found.launch_candidates)
    return targets, kept


def _always(_: Linted) -> bool:
    return True


def _has_controllers(linted: Linted) -> bool:
    return bool(linted.controllers)


def _is_robot(linted: Linted) -> bool:
    """Whether a file found in a folder is a robot: two links or more, whole or at least named; or nothing that could be
    read at all."""
    if linted.links is None:
        return True
    return linted.links > 1 and (linted.complete or linted.robot is not None)


def _selection(config: Config, select: tuple[str, ...], ignore: tuple[str, ...], extend: tuple[str, ...]) -> Selection:
    """The rules that the options ask for, and where they say nothing the configuration."""
    ignored = (*config.ignore, *(code for _, codes in config.per_file_ignores for code in codes))
    of_config = Selection(config.select, ignored, config.extend_select, config.severities)
    try:
        checked_selection(of_config)
    except UserError as error:
        raise UserError(f"{config.file}: {error}" if config.file else str(error)) from None
    return checked_selection(
        Selection(select or config.select, ignore or config.ignore, extend or config.extend_select, config.severities)
    )


def _baseline(path: str | None, to_write: str | None) -> Baseline | None:
    if path is None and to_write is None:
        return None
    from urdfctl.cli.known_findings import opened

    return opened(path, to_write)


def _severity(name: str) -> Severity:
    try:
        return Severity(name)
    except ValueError:
        raise UserError(f"--fail-on is one of error, warning, info; not '{name}'") from None


def _output(text: str) -> tuple[str, str | None]:
    name, mark, file = text.partition("=")
    if name not in FORMATS:
        raise UserError(f"unknown format '{name}'{did_you_mean(name, FORMATS)}; known are {', '.join(FORMATS)}")
    if mark and not file:
        raise UserError(f"--format {name}= names no file")
    return name, file or None


def _tell(report: Report, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, render(report, name), force=True)
    elif name == "text" and sys.stdout.isatty() and not os.environ.get("NO_COLOR"):
        from urdfctl.report.text import print_coloured

        print_coloured(report)
    else:
        print_text(render(report, name))
