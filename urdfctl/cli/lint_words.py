"""Reads the words of `urdfctl lint` without typer, whose import alone would cost a third of a run.

It knows the plain forms only; for anything else (`--help`, an unknown option, a missing value) it steps aside, and
typer says what is to be said. A test keeps this table and typer's options the same.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from urdfctl.hints import Any

ONE: dict[str, Callable[[str], Any]] = {
    "--distro": str,
    "--simulator": str,
    "--start": str,
    "--workspace": str,
    "--timeout": float,
    "--memory": int,
    "--fail-on": str,
    "--baseline": str,
    "--write-baseline": str,
    "--shard": str,
    "--jobs": int,
    "--config": str,
}
MANY = ("--package-path", "--env", "--select", "--ignore", "--extend-select", "--format")
FLAGS = ("--trust", "--exit-zero", "--statistics", "--fix", "--unsafe-fixes", "--diff", "--show-settings")
NAMES = {"--format": "formats"}


def plain_options(words: Sequence[str]) -> dict[str, Any] | None:
    """The keyword arguments of the lint command that the words stand for; None where typer has to look at them."""
    options: dict[str, Any] = {}
    paths: list[str] = []
    rest = iter(words)
    for word in rest:
        if not word.startswith("-"):
            paths.append(word)
            continue
        option, mark, value = word.partition("=")
        if option in FLAGS and not mark:
            options[_name(option)] = True
        elif option in ONE or option in MANY:
            given = value if mark else next(rest, None)
            if given is None or (not mark and given.startswith("-")):
                return None
            if not _keep(options, option, given):
                return None
        else:
            return None
    return {"paths": paths, **options}


def _keep(options: dict[str, Any], option: str, given: str) -> bool:
    if option in MANY:
        options.setdefault(_name(option), []).append(given)
        return True
    try:
        options[_name(option)] = ONE[option](given)
    except ValueError:
        return False
    return True


def _name(option: str) -> str:
    return NAMES.get(option, option.removeprefix("--").replace("-", "_"))
