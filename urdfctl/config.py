"""What a project's urdfctl.toml, or [tool.urdfctl] in its pyproject.toml, sets for every run."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping

from urdfctl.catalog.additions import NO_ADDITIONS, Additions, flaws_of_meaning
from urdfctl.errors import UserError
from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.source.files import first_bytes
from urdfctl.variants import ConfiguredRobot, robots_of
from urdfctl.workspace import workspace_of

NAMES = ("urdfctl.toml", "pyproject.toml")
_MOST_BYTES = 1 << 20
_MOST_DOTS = 4000
"""A key of more parts would keep the reader of TOML busy for minutes."""
_TABLE = rb"(?m)^[ \t]*(?:\[+[ \t]*)?tool\s*(?:\]|\.\s*[\"']?urdfctl)"


class Config(NamedTuple):
    """What the file sets; None, or nothing, where it does not. `package_paths` are from the folder that we stand in.

    `exclude` are patterns of paths, relative to the file's folder, that are not looked for in folders. `severities` are
    by beginnings of codes: a severity, or `off`. `per_file_ignores` are codes that are not told of in paths like
    `exclude`'s.
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

    def excludes(self, path: str) -> bool:
        """Whether a file, found in a folder, is not to be looked at."""
        return bool(self.exclude) and self._fits(path, self.exclude)

    def ignores(self, path: str, code: str) -> bool:
        """Whether findings of a code are not to be told in a file."""
        patterns = [pattern for pattern, codes in self.per_file_ignores if code.startswith(codes)]
        return bool(patterns) and self._fits(path, patterns)

    def _fits(self, path: str, patterns: Iterable[str]) -> bool:
        """Whether a path, or a folder above it, fits one of some patterns, which count from the file's folder."""
        if self.file is None:
            return False
        from fnmatch import fnmatchcase

        inside = os.path.relpath(path, os.path.dirname(os.path.abspath(self.file))).replace(os.sep, "/")
        parts = inside.split("/")
        above = ["/".join(parts[: size + 1]) for size in range(len(parts))]
        return any(fnmatchcase(one, pattern.strip("/")) for pattern in patterns for one in above)


def config_for(paths: tuple[str, ...], workspace: str | None = None) -> Config:
    """The nearest configuration upwards of the first path, else of the current folder, within the workspace.

    UserError where there is one that means nothing.
    """
    start = os.path.abspath(paths[0] if paths else os.curdir)
    folder = start if os.path.isdir(start) else os.path.dirname(start)
    top = workspace_of(os.path.join(folder, NAMES[0]), workspace)
    for ancestor in _upwards(folder, top):
        for name in NAMES:
            file = os.path.join(ancestor, name)
            config = config_of(os.path.relpath(file)) if os.path.isfile(file) else None
            if config is not None:
                return config
    return Config()


def config_of(file: str) -> Config | None:
    """What a file sets; None where it is a pyproject.toml that says nothing of urdfctl."""
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
    return _config(table, file)


def with_environ(config: Config, environ: Mapping[str, str]) -> Config:
    """A configuration with what the variables `URDFCTL_*` set instead: lists with commas, folders as in `PATH`."""
    distro = environ.get("URDFCTL_DISTRO")
    if distro:
        config = config._replace(distro=distro, distro_from="$URDFCTL_DISTRO")
    simulator = environ.get("URDFCTL_SIMULATOR")
    if simulator:
        config = config._replace(simulator=simulator, simulator_from="$URDFCTL_SIMULATOR")
    folders = environ.get("URDFCTL_PACKAGE_PATHS")
    return config._replace(
        package_paths=tuple(folders.split(os.pathsep)) if folders else config.package_paths,
        select=_listed(environ, "URDFCTL_SELECT") or config.select,
        ignore=_listed(environ, "URDFCTL_IGNORE") or config.ignore,
        extend_select=_listed(environ, "URDFCTL_EXTEND_SELECT") or config.extend_select,
        fail_on=environ.get("URDFCTL_FAIL_ON") or config.fail_on,
    )


def _listed(environ: Mapping[str, str], name: str) -> tuple[str, ...]:
    return tuple(part.strip().upper() for part in environ.get(name, "").split(",") if part.strip())


def _config(table: Mapping[str, Any], file: str) -> Config:
    folder = os.path.dirname(file)
    ignores = table.get("per-file-ignores", {})
    additions = Additions(tuple(table.get("controllers", ())), tuple(table.get("hardware", ())))
    for path, message in flaws_of_meaning(additions) if additions.controllers else ():
        raise UserError(f"{file}: {path}: {message}")
    return Config(
        file,
        table.get("distro"),
        os.path.basename(file) if "distro" in table else None,
        table.get("simulator"),
        os.path.basename(file) if "simulator" in table else None,
        tuple(_folder(folder, path, file) for path in table.get("package-paths", ())),
        _codes(table, "select"),
        _codes(table, "ignore"),
        _codes(table, "extend-select"),
        tuple(table.get("exclude", ())),
        table.get("fail-on"),
        tuple((code.upper(), severity) for code, severity in table.get("severity", {}).items()),
        additions if any(additions) else NO_ADDITIONS,
        tuple((pattern, _codes(ignores, pattern)) for pattern in ignores),
        robots_of(table, file),
    )


def _folder(folder: str, path: str, file: str) -> str:
    found = os.path.join(folder, path)
    if not os.path.isdir(found):
        raise UserError(f"{file}: package-paths: no such folder: '{path}'")
    return found


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
        raise UserError(f"{file}: no good TOML: a line with more than {_MOST_DOTS} dots")
    if os.path.basename(file) == "pyproject.toml" and not re.search(_TABLE, data):
        return {}
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        return tomllib.loads(data.decode())
    except (ValueError, RecursionError) as error:  # what is no UTF-8 or no TOML, and numbers of 4300 digits
        raise UserError(f"{file}: no good TOML: {error}") from None
