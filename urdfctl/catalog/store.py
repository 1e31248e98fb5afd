"""The catalogue's plain entries, read from its JSON files on first use."""

from __future__ import annotations

import json
import os
from functools import cache, lru_cache
from typing import Any

_FOLDER = os.path.join(os.path.dirname(__file__), "data")


@cache
def plain(ros: int, kind: str) -> dict[str, Any]:
    """Return the entries of one kind for ROS generation `ros`, by type, name or id.

    For the kinds `manager` and `interfaces` the keys are the parts of the one entry.
    """
    return _read(f"ros{ros}/{kind}.json")


def prepare() -> None:
    """Read all files that linting a robot may need, before worker processes are forked."""
    for ros in (1, 2):
        for kind in ("controllers", "hardware", "interfaces", "manager", "simulators", "transmissions"):
            plain(ros, kind)
    renamed()


@lru_cache(maxsize=1)
def renamed() -> dict[str, Any]:
    """Return the types of one ROS generation with their counterparts in the other."""
    return _read("renamed.json")


@lru_cache(maxsize=1)
def moves_data() -> dict[str, Any]:
    """Return what replaces what from one ROS 2 distro to a later one: `names` and `parameters`."""
    return _read("moves.json")


@lru_cache(maxsize=1)
def log_message_entries() -> dict[str, Any]:
    """Return the messages of ROS and Gazebo by id."""
    return _read("log_messages.json")


def _read(name: str) -> dict[str, Any]:
    with open(os.path.join(_FOLDER, name), encoding="utf-8") as file:
        return json.load(file)  # type: ignore[no-any-return]
