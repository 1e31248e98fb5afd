"""`urdfctl lint --show-settings`: what holds for a run, and what set it, in the form of urdfctl.toml."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.cli.wanted import Wanted
from urdfctl.config import Config, config_of
from urdfctl.record import NamedTuple
from urdfctl.settings import Settings
from urdfctl.variants import ConfiguredRobot
from urdfctl.workspace import workspace_of

_WIDTH = 40


class Setting(NamedTuple):
    """A key of the configuration, what holds for it (None where nothing was said), and the options and variables that
    may set it."""

    key: str
    value: str | Sequence[str] | None
    option: str | None = None
    variable: str | None = None


def shown(wanted: Wanted, settings: Settings, given: Mapping[str, object]) -> str:
    """All settings of a run, of which some were `given` on the command line, by the names of the options."""
    return "".join(f"{line}\n" for line in _lines(wanted, settings, given))


def _lines(wanted: Wanted, settings: Settings, given: Mapping[str, object]) -> Iterator[str]:
    config, first = wanted.config, next((word for word in wanted.words if ":=" not in word), os.curdir)
    inside = os.path.join(first, "robot") if os.path.isdir(first) else first
    yield f"# configuration: {config.file or 'none'}"
    yield f"# workspace: {workspace_of(os.path.abspath(inside), settings.workspace)}"
    yield f"# at most {settings.timeout:g} s and {settings.memory >> 20} MiB for a robot"
    of_file = (config.file and config_of(config.file)) or Config()
    for setting in _settings(wanted, settings):
        if setting.value is None:
            yield f"# {setting.key}: not set; the files of each robot tell"
        else:
            yield f"{f'{setting.key} = {_toml(setting.value)}':{_WIDTH}}  # {_origin(setting, given, of_file)}"
    yield from _table("severity", config.severities)
    yield from _table("per-file-ignores", config.per_file_ignores)
    for robot in config.robots:
        yield from _robot(robot)
    for kind, entries in config.additions._asdict().items():
        yield from (f"# [[{kind}]] {entry['type']}" for entry in entries)


def _settings(wanted: Wanted, settings: Settings) -> Iterator[Setting]:
    selection = wanted.selection
    yield Setting("distro", settings.distro, "distro", "URDFCTL_DISTRO")
    yield Setting("simulator", settings.simulator, "simulator", "URDFCTL_SIMULATOR")
    yield Setting("package-paths", settings.package_paths, "package_path", "URDFCTL_PACKAGE_PATHS")
    yield Setting("select", selection.select, "select", "URDFCTL_SELECT")
    yield Setting("ignore", selection.ignore, "ignore", "URDFCTL_IGNORE")
    yield Setting("extend-select", selection.extend, "extend_select", "URDFCTL_EXTEND_SELECT")
    yield Setting("exclude", wanted.config.exclude)
    yield Setting("fail-on", wanted.fail_on.value, "fail_on", "URDFCTL_FAIL_ON")


def _origin(setting: Setting, given: Mapping[str, object], of_file: Config) -> str:
    field = setting.key.replace("-", "_")
    if setting.option and given.get(setting.option):
        return f"--{setting.option.replace('_', '-')}"
    if setting.variable and os.environ.get(setting.variable):
        return f"${setting.variable}"
    return of_file.file or "" if getattr(of_file, field) != getattr(Config(), field) else "default"


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
