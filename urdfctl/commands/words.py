"""Parse words and options that several commands share."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from urdfctl.commands.reach import is_in_workspace
from urdfctl.config.file import Config, config_for, config_of, with_environ
from urdfctl.config.settings import Settings, passed_on, settings_with
from urdfctl.diagnostic import Severity
from urdfctl.errors import UserError
from urdfctl.names import did_you_mean
from urdfctl.source.disk.gate import is_file

if TYPE_CHECKING:
    from urdfctl.commands.options import ReadingOptions, ReportOptions, StartOptions
    from urdfctl.discover.shards import Shard
    from urdfctl.lint.selection import Selection
    from urdfctl.report.baseline import Baseline


def codes(given: Sequence[str]) -> tuple[str, ...]:
    """Return the codes, or prefixes of codes, that a repeatable option lists."""
    return tuple(code.strip().upper() for item in given for code in item.split(",") if code.strip())


def output_of(text: str, formats: Collection[str]) -> tuple[str, str | None]:
    """Return a format and its file, None for standard output.

    Raises UserError if there is no such format, or its file leads out of the workspace.
    """
    name, mark, file = text.partition("=")
    if name not in formats:
        raise UserError(f"unknown format '{name}'{did_you_mean(name, formats)}; known are {', '.join(formats)}")
    if mark and not file:
        raise UserError(f"--format {name}= requires the name of a file")
    _check_output(file)
    return name, file or None


def _check_output(path: str | None) -> None:
    if path:
        from urdfctl.output.links import check_output

        check_output(path)


def outputs_of(formats: Sequence[str], file: str | None, known: Collection[str]) -> tuple[tuple[str, str | None], ...]:
    """Return the formats, text if there are none, each with its file; --output-file is that of the one that has none.

    Raises UserError if --output-file is given, but not exactly one format has no file.
    """
    outputs = [output_of(text, known) for text in formats or ("text",)]
    _check_output(file)
    if file is not None and sum(its_file is None for _, its_file in outputs) != 1:
        raise UserError("--output-file takes one report; give the others a file with --format FORMAT=FILE")
    return tuple((name, its_file or file) for name, its_file in outputs)


def configured(words: Sequence[str], options: ReadingOptions) -> Config:
    """Return what the configuration file and the environment set: the file that is named, or the nearest one."""
    file, paths = options.config, split_arguments(words)[0]
    if file is None:
        return with_environ(config_for(tuple(paths), options.workspace), os.environ)
    if not os.path.exists(file):
        raise UserError(f"file '{file}' does not exist")
    found = config_of(file, is_own=not is_in_workspace(file, paths))
    return with_environ(found or Config(file), os.environ)


def configurations(words: Sequence[str], options: ReadingOptions) -> list[tuple[Config, list[str]]]:
    """Return the configurations around some paths, each with those of the paths that it is the nearest one of."""
    paths, _ = split_arguments(words)
    found: dict[str | None, tuple[Config, list[str]]] = {}
    for path in paths:
        config = configured([path], options)
        found.setdefault(config.file, (config, []))[1].append(path)
    return list(found.values()) or [(configured([], options), [])]


def settings_from(
    config: Config,
    options: ReadingOptions,
    *,
    distro: str | None = None,
    simulator: str | None = None,
    start: str | None = None,
    named: Sequence[str] = (),
) -> Settings:
    """Return the settings of a run: its options first, then the configuration, then the environment.

    named: the paths on the command line; files among them are read wherever they are.
    """
    return settings_with(
        config,
        Settings(
            distro=distro,
            simulator=simulator,
            started=None if start is None else tuple(name.strip() for name in start.split(",") if name.strip()),
            workspace=options.workspace,
            package_paths=options.package_path,
            environ=passed_on(os.environ, options.env),
            trust=options.trust,
            timeout=options.timeout,
            memory=options.memory << 20,
            named_files=tuple(os.path.abspath(path) for path in named if is_file(path)),
        ),
    )


def settings_to_check(config: Config, options: StartOptions, named: Sequence[str]) -> Settings:
    """Return the settings of a run that checks robots. named: as in `settings_from`."""
    return settings_from(
        config, options, distro=options.distro, simulator=options.simulator, start=options.start, named=named
    )


def contradictions(config: Config, distro: str | None) -> Iterator[str]:
    """Yield that the command line names another distro than the project's file; a variable is meant to be replaced."""
    is_of_file = config.distro_from is not None and not config.distro_from.startswith("$")
    if distro and config.distro and is_of_file and distro != config.distro:
        yield f"--distro {distro} is used, although {config.distro_from} says '{config.distro}'"


def check_jobs(jobs: int) -> None:
    """Raise UserError if --jobs is negative."""
    if jobs < 0:
        raise UserError(f"--jobs must be a number of robots, or 0 for one for each processor; not {jobs}")


def split_arguments(words: Sequence[str]) -> tuple[list[str], dict[str, str]]:
    """Separate paths from `name:=value` arguments as xacro does, which drops arguments without a value."""
    paths, arguments = [], {}
    for word in words:
        name, mark, value = word.partition(":=")
        if not mark:
            paths.append(word)
        elif name.strip() and value.strip():
            arguments[name.strip()] = value.strip()
    return paths, arguments


def severity_named(name: str) -> Severity:
    """Return the severity with the name that --fail-on gives. Raises UserError if there is none."""
    try:
        return Severity(name)
    except ValueError:
        raise UserError(f"--fail-on must be error, warning or info, not '{name}'") from None


def baseline_of(
    options: ReportOptions, configs: Iterable[Config], selection: Selection, *, found_by: str
) -> Baseline | None:
    """Return the baseline that the options name, or else the configurations, for a run with some rules; None if none.

    UserError if it cannot be read.
    """
    configured = (config.baseline for config in configs if config.baseline is not None)
    paths = [*configured] if options.baseline is None else [options.baseline]
    if not paths and options.write_baseline is None:
        return None
    from urdfctl.report.baseline import open_baseline

    _check_output(options.write_baseline)
    return open_baseline(paths, selection, to_write=options.write_baseline, found_by=found_by)


def shard_of(text: str | None) -> Shard | None:
    """Return the share of a run that --shard names; None for all of it. UserError if there is no such share."""
    if text is None:
        return None
    from urdfctl.discover.shards import shard

    return shard(text)
