"""The user's additions to the catalogue, as plain entries in the form of its data files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from urdfctl.startup.records import NamedTuple

Plain = Mapping[str, Any]


class Additions(NamedTuple):
    """The user's entries for controllers and for hardware plugins."""

    controllers: tuple[Plain, ...] = ()
    hardware: tuple[Plain, ...] = ()


NO_ADDITIONS = Additions()
