"""What the words of a command line mean, once they are told apart."""

from __future__ import annotations

import os
from collections.abc import Collection

from urdfctl.config import Config, config_for, config_of, with_environ
from urdfctl.errors import UserError
from urdfctl.settings import Settings, checked, passed_on
from urdfctl.suggest import did_you_mean


def codes(given: list[str] | None) -> tuple[str, ...]:
    """The codes, or beginnings of codes, that a repeatable option lists."""
    return tuple(code.strip().upper() for item in given or () for code in item.split(",") if code.strip())


def output_of(text: str, formats: Collection[str]) -> tuple[str, str | None]:
    """A format and the file it goes to, None for standard output. UserError where there is no such format."""
    name, mark, file = text.partition("=")
    if name not in formats:
        raise UserError(f"unknown format '{name}'{did_you_mean(name, formats)}; known are {', '.join(formats)}")
    if mark and not file:
        raise UserError(f"--format {name}= names no file")
    return name, file or None


def configured(words: list[str] | None, config: str | None, workspace: str | None) -> Config:
    """What the project's configuration and the environment set: of the file named, else of the nearest."""
    if config is None:
        paths, _ = split_arguments(words or [])
        return with_environ(config_for(tuple(paths), workspace), os.environ)
    if not os.path.exists(config):
        raise UserError(f"no such file: '{config}'")
    return with_environ(config_of(config) or Config(config), os.environ)


def settings_from(  # noqa: PLR0913, PLR0917 (one for each option)
    config: Config,
    distro: str | None,
    simulator: str | None,
    start: str | None,
    workspace: str | None,
    package_path: list[str] | None,
    env: list[str] | None,
    trust: bool,  # noqa: FBT001
    timeout: float,
    memory: int,
) -> Settings:
    """The settings of a run, from its options, else from the configuration, and the environment."""
    started = None if start is None else tuple(name.strip() for name in start.split(",") if name.strip())
    return checked(
        Settings(
            distro or config.distro,
            simulator or config.simulator,
            started,
            workspace,
            tuple(package_path or config.package_paths),
            passed_on(os.environ, tuple(env or ())),
            trust,
            timeout,
            memory << 20,
            config.additions,
            None if distro else config.distro_from,
            None if simulator else config.simulator_from,
        )
    )


def split_arguments(words: list[str] | tuple[str, ...]) -> tuple[list[str], dict[str, str]]:
    """Paths and `name:=value` arguments, told apart as xacro does; one without a value is left out, as xacro does."""
    paths, arguments = [], {}
    for word in words:
        name, mark, value = word.partition(":=")
        if not mark:
            paths.append(word)
        elif name.strip() and value.strip():
            arguments[name.strip()] = value.strip()
    return paths, arguments
