"""What the user adds to the catalogue, as plain entries in the form of its data."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple


class Additions(NamedTuple):
    """Entries of controllers and of hardware plugins."""

    controllers: tuple[Mapping[str, Any], ...] = ()
    hardware: tuple[Mapping[str, Any], ...] = ()


NO_ADDITIONS = Additions()
