"""The environment variables that a launch file may read."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.source.opaque import UNKNOWN


class Variables(dict[str, str]):
    """The environment variables that are given. It remembers those that are required and are not.

    missing: the names of these.
    """

    def __init__(self, given: Mapping[str, str]) -> None:
        super().__init__(given)
        self.missing: dict[str, None] = {}


def required(environ: Mapping[str, str], name: str) -> str:
    """Return the value of an environment variable without which nothing is started; UNKNOWN if it is not given."""
    if name in environ:
        return environ[name]
    if isinstance(environ, Variables) and UNKNOWN not in name:
        environ.missing[name] = None
    return UNKNOWN
