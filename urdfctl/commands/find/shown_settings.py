"""`urdfctl lint --show-settings`: the effective settings and where each comes from, as urdfctl.toml."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence

from urdfctl.commands.declaring import Options
from urdfctl.config.file import Config, config_of
from urdfctl.config.robots import ConfiguredRobot
from urdfctl.diagnostic import Severity
from urdfctl.lint.run import LintRequest
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple

_WIDTH = 40


class ShownSetting(NamedTuple):
    """A setting.

    key: its name in the configuration.
    value: its effective value; None if it is not set.
    option: the name of the option that sets it.
    variable: the environment variable that sets it.
    """

    key: str
    value: str | Sequence[str] | None
    option: str | None = None
    variable: str | None = None


def settings_text(request: LintRequest, fail_on: Severity, options: Options) -> str:
    """Return all settings of a run as text."""
    return "".join(f"{line}\n" for line in _lines(request, fail_on, options))


def _lines(request: LintRequest, fail_on: Severity, options: Options) -> Iterator[str]:
    config, settings, first = request.config, request.settings, next(iter(request.paths), os.curdir)
    inside = os.path.join(first, "robot") if os.path.isdir(first) else first
    yield f"# configuration: {config.file or 'none'}"
    yield f"# workspace: {workspace_of(os.path.abspath(inside), settings.workspace)}"
    yield f"# at most {settings.timeout:g} s and {settings.memory >> 20} MiB for a robot"
    file_config = (config.file and config_of(config.file)) or Config()
    for setting in _settings(request, fail_on, getattr(options, "baseline", None) or config.baseline):
        if setting.value is None:
            yield f"# {setting.key}: not set; detected from the files of each robot"
        else:
            yield f"{f'{setting.key} = {_toml(setting.value)}':{_WIDTH}}  # {_origin(setting, options, file_config)}"
    yield from _table("severity", config.severities)
    yield from _table("per-file-ignores", config.per_file_ignores)
    for robot in config.robots:
        yield from _robot(robot)
    for kind, entries in config.additions._asdict().items():
        yield from (f"# [[{kind}]] {entry['type']}" for entry in entries)


def _settings(request: LintRequest, fail_on: Severity, baseline: str | None) -> Iterator[ShownSetting]:
    selection, settings = request.selection, request.settings
    yield ShownSetting("distro", settings.distro, "distro", "URDFCTL_DISTRO")
    yield ShownSetting("simulator", settings.simulator, "simulator", "URDFCTL_SIMULATOR")
    yield ShownSetting("package-paths", settings.package_paths, "package_path", "URDFCTL_PACKAGE_PATHS")
    yield ShownSetting("select", selection.select, "select", "URDFCTL_SELECT")
    yield ShownSetting("ignore", selection.ignore, "ignore", "URDFCTL_IGNORE")
    yield ShownSetting("extend-select", selection.extend, "extend_select", "URDFCTL_EXTEND_SELECT")
    yield ShownSetting("exclude", request.config.exclude)
    yield ShownSetting("fail-on", fail_on.value, "fail_on", "URDFCTL_FAIL_ON")
    if baseline is not None:
        yield ShownSetting("baseline", baseline, "baseline")


def _origin(setting: ShownSetting, options: Options, file_config: Config) -> str:
    field = setting.key.replace("-", "_")
    if setting.option and getattr(options, setting.option):
        return f"--{setting.option.replace('_', '-')}"
    if setting.variable and os.environ.get(setting.variable):
        return f"${setting.variable}"
    return file_config.file or "" if getattr(file_config, field) != getattr(Config(), field) else "default"


def _table(name: str, rows: Sequence[tuple[str, str | tuple[str, ...]]]) -> Iterator[str]:
    if rows:
        yield f"[{name}]"
        yield from (f"{json.dumps(key, ensure_ascii=False)} = {_toml(value)}" for key, value in rows)


def _robot(robot: ConfiguredRobot) -> Iterator[str]:
    yield "[[robot]]"
    yield f"path = {_toml(robot.path)}"
    if robot.controllers:
        yield f"controllers = {_toml(robot.controllers)}"
    if robot.launches:
        yield f"launch = {_toml(robot.launches)}"
    for number, variant in enumerate(robot.variants, 1):
        arguments = " ".join(f"{name}:={value}" for name, value in variant)
        yield f"# variant {number} of {len(robot.variants)}: {arguments or 'no arguments'}"


def _toml(value: str | Sequence[str]) -> str:
    return json.dumps(value, ensure_ascii=False)
