"""The configuration of a project: urdfctl.toml, or [tool.urdfctl] in pyproject.toml."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.config.robots import ConfiguredRobot, robots_of
from urdfctl.errors import UserError
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import admit, admits, is_file
from urdfctl.source.workspaces.packages import ELSEWHERE
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple

_PACKAGE_PATHS = "URDFCTL_PACKAGE_PATHS"
NAMES = ("urdfctl.toml", "pyproject.toml")
_MOST_BYTES = 1 << 20
_MOST_DOTS = 4000
"""A key with more parts would take the TOML reader minutes."""
_TABLE = rb"(?m)^[ \t]*(?:\[+[ \t]*)?tool\s*(?:\]|\.\s*[\"']?urdfctl)"


class Config(NamedTuple):
    """The settings of a configuration file; None or empty if it does not set them.

    file: the configuration file; None if there is none.
    distro_from, simulator_from: where the value comes from, for messages.
    package_paths: relative to the current folder.
    exclude: patterns of paths that are skipped in folders, relative to the file's folder.
    severities: pairs of a prefix of codes and a severity, or "off".
    additions: the project's own controllers and hardware.
    per_file_ignores: pairs of a pattern like those of `exclude`, and codes that are not reported there.
    baseline: the file of known findings, relative to the current folder.
    successors: pairs of a name of the project's own and the one that a migration writes instead.
    """

    file: str | None = None
    distro: str | None = None
    distro_from: str | None = None
    simulator: str | None = None
    simulator_from: str | None = None
    package_paths: tuple[str, ...] = ()
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend_select: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    fail_on: str | None = None
    severities: tuple[tuple[str, str], ...] = ()
    additions: Additions = NO_ADDITIONS
    per_file_ignores: tuple[tuple[str, tuple[str, ...]], ...] = ()
    robots: tuple[ConfiguredRobot, ...] = ()
    baseline: str | None = None
    successors: tuple[tuple[str, str], ...] = ()

    def excludes(self, path: str) -> bool:
        """Return whether a file in a folder is skipped."""
        return bool(self.exclude) and self._matches(path, self.exclude)

    def ignores(self, path: str, code: str) -> bool:
        """Return whether findings with a code are ignored in a file."""
        patterns = [pattern for pattern, codes in self.per_file_ignores if code.startswith(codes)]
        return bool(patterns) and self._matches(path, patterns)

    def _matches(self, path: str, patterns: Iterable[str]) -> bool:
        """Return whether a path, or a folder above it, matches a pattern relative to the file's folder."""
        if self.file is None:
            return False
        from fnmatch import fnmatchcase

        inside = os.path.relpath(path, os.path.dirname(os.path.abspath(self.file))).replace(os.sep, "/")
        parts = inside.split("/")
        above = ["/".join(parts[: size + 1]) for size in range(len(parts))]
        return any(fnmatchcase(ancestor, pattern.strip("/")) for pattern in patterns for ancestor in above)


def config_for(paths: tuple[str, ...], workspace: str | None = None) -> Config:
    """Return the nearest configuration in the folders above the first path, within the workspace.

    Without paths, start at the current folder. Raises UserError if the configuration is invalid, or if it is or names
    anything outside of what the run may read.
    """
    start = os.path.abspath(paths[0] if paths else os.curdir)
    folder = start if os.path.isdir(start) else os.path.dirname(start)
    top = workspace_of(os.path.join(folder, NAMES[0]), workspace)
    for ancestor in _upwards(folder, top):
        for name in NAMES:
            file = os.path.join(ancestor, name)
            if os.path.islink(file) and not admits(file):
                raise UserError(
                    f"{os.path.relpath(file)}: leads outside the workspace; name what it leads to: --config FILE"
                )
            config = config_of(os.path.relpath(file)) if is_file(file) else None
            if config is not None:
                return config
    return Config()


def config_of(file: str, *, is_own: bool = False) -> Config | None:
    """Return the configuration in a file; None for a pyproject.toml without [tool.urdfctl].

    is_own: whether it is the user's own, outside of what others wrote: what it names may be read.
    Raises UserError if it is invalid, or names anything outside of what the run may read.
    """
    table: Any = _toml(file)
    prefix = ""
    if os.path.basename(file) == "pyproject.toml":
        tools, prefix = table.get("tool"), "tool.urdfctl"
        table = tools.get("urdfctl") if isinstance(tools, dict) else None
        if table is None:
            return None
    from urdfctl.catalog.schema import flaws

    for flaw in flaws(table, "config", prefix):
        raise UserError(f"{file}: {flaw.path + ': ' if flaw.path else ''}{flaw.message}")
    if is_own:
        _admit_named(table, os.path.dirname(file))
    return _config(table, file)


def _admit_named(table: Mapping[str, Any], folder: str) -> None:
    """Let the run read what a configuration names: folders with packages, and the workspaces of robots."""
    for path in (*table.get("package-paths", ()), *([table["baseline"]] if "baseline" in table else ())):
        admit(os.path.join(folder, path))
    for robot in table.get("robot", ()):
        for path in (robot["path"], *robot.get("controllers", ()), *robot.get("launch", ())):
            admit(workspace_of(os.path.join(folder, path)))


def with_environ(config: Config, environ: Mapping[str, str]) -> Config:
    """Return a configuration in which the variables `URDFCTL_*` replace values.

    Lists are separated by commas, folders as in `PATH`.
    """
    distro = environ.get("URDFCTL_DISTRO")
    if distro:
        config = config._replace(distro=distro, distro_from="$URDFCTL_DISTRO")
    simulator = environ.get("URDFCTL_SIMULATOR")
    if simulator:
        config = config._replace(simulator=simulator, simulator_from="$URDFCTL_SIMULATOR")
    folders = environ.get(_PACKAGE_PATHS)
    return config._replace(
        package_paths=tuple(folders.split(os.pathsep)) if folders else config.package_paths,
        select=_listed(environ, "URDFCTL_SELECT") or config.select,
        ignore=_listed(environ, "URDFCTL_IGNORE") or config.ignore,
        extend_select=_listed(environ, "URDFCTL_EXTEND_SELECT") or config.extend_select,
        fail_on=environ.get("URDFCTL_FAIL_ON") or config.fail_on,
    )


def package_folders_in(environ: Mapping[str, str]) -> list[str]:
    """Return the folders with packages that the user's environment names: those of urdfctl, and those of ROS."""
    texts = (environ.get(name, "") for name in (_PACKAGE_PATHS, *ELSEWHERE))
    return [folder for text in texts for folder in text.split(os.pathsep) if folder]


def _listed(environ: Mapping[str, str], name: str) -> tuple[str, ...]:
    return tuple(part.strip().upper() for part in environ.get(name, "").split(",") if part.strip())


def _config(table: Mapping[str, Any], file: str) -> Config:
    folder = os.path.dirname(file)
    ignores = table.get("per-file-ignores", {})
    additions = Additions(tuple(table.get("controllers", ())), tuple(table.get("hardware", ())))
    if additions.controllers:
        from urdfctl.catalog.consistency import flaws_of_meaning

        for path, message in flaws_of_meaning(additions):
            raise UserError(f"{file}: {path}: {message}")
    return Config(
        file=file,
        distro=table.get("distro"),
        distro_from=os.path.basename(file) if "distro" in table else None,
        simulator=table.get("simulator"),
        simulator_from=os.path.basename(file) if "simulator" in table else None,
        package_paths=tuple(_folder(folder, path, file) for path in table.get("package-paths", ())),
        select=_codes(table, "select"),
        ignore=_codes(table, "ignore"),
        extend_select=_codes(table, "extend-select"),
        exclude=tuple(table.get("exclude", ())),
        fail_on=table.get("fail-on"),
        severities=tuple((code.upper(), severity) for code, severity in table.get("severity", {}).items()),
        additions=additions if any(additions) else NO_ADDITIONS,
        per_file_ignores=tuple((pattern, _codes(ignores, pattern)) for pattern in ignores),
        robots=robots_of(table, file),
        baseline=_baseline(folder, table["baseline"], file) if "baseline" in table else None,
        successors=tuple(table.get("migrate", {}).get("names", {}).items()),
    )


def _baseline(folder: str, path: str, file: str) -> str:
    joined = os.path.join(folder, path)
    if not admits(joined):
        raise UserError(f"{file}: baseline: file '{path}' is outside the workspace; name it with --baseline")
    return joined


def _folder(folder: str, path: str, file: str) -> str:
    joined = os.path.join(folder, path)
    if not admits(joined):
        way_out = "name it with --package-path, or in URDFCTL_PACKAGE_PATHS"
        raise UserError(f"{file}: package-paths: folder '{path}' is outside the workspace; {way_out}")
    if not os.path.isdir(joined):
        raise UserError(f"{file}: package-paths: folder '{path}' does not exist")
    return joined


def _codes(table: Mapping[str, Any], key: str) -> tuple[str, ...]:
    return tuple(code.upper() for code in table.get(key, ()))


def _upwards(folder: str, top: str) -> Iterator[str]:
    while True:
        yield folder
        above = os.path.dirname(folder)
        if folder in (top, above) or not (folder + os.sep).startswith(top.rstrip(os.sep) + os.sep):
            return
        folder = above


def _toml(file: str) -> dict[str, Any]:
    try:
        data = first_bytes(file, _MOST_BYTES + 1)
    except OSError as error:
        raise UserError(f"{file}: {error.strerror}") from None
    if len(data) > _MOST_BYTES:
        raise UserError(f"{file}: larger than {_MOST_BYTES >> 20} MiB")
    if any(line.count(b".") > _MOST_DOTS for line in data.splitlines()):
        raise UserError(f"{file}: invalid TOML: a line with more than {_MOST_DOTS} dots")
    if os.path.basename(file) == "pyproject.toml" and not re.search(_TABLE, data):
        return {}
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        return tomllib.loads(data.decode())
    except (ValueError, RecursionError) as error:  # invalid UTF-8 or TOML, or a number with more than 4300 digits
        raise UserError(f"{file}: invalid TOML: {error}") from None
