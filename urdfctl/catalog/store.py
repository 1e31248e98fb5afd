"""The catalogue's plain entries, read from its JSON files when they are first asked for."""

from __future__ import annotations

import json
import os
from functools import cache, lru_cache

from urdfctl.hints import Any

_FOLDER = os.path.join(os.path.dirname(__file__), "data")


@cache
def plain(ros: int, kind: str) -> dict[str, Any]:
    """The entries of a kind by their key: the type, the name or the id; of `manager` and `interfaces` the parts."""
    return _read(f"ros{ros}/{kind}.json")


def prepare() -> None:
    """Read all that robots may need."""
    for ros in (1, 2):
        for kind in ("controllers", "hardware", "interfaces", "manager", "simulators", "transmissions"):
            plain(ros, kind)
    renamed()


@lru_cache(maxsize=1)
def renamed() -> dict[str, Any]:
    """The types of one generation of ROS, and what they are in the other."""
    return _read("renamed.json")


@lru_cache(maxsize=1)
def log_message_entries() -> dict[str, Any]:
    """The messages of ROS and Gazebo, by their ids."""
    return _read("log_messages.json")


def _read(name: str) -> dict[str, Any]:
    with open(os.path.join(_FOLDER, name), encoding="utf-8") as file:
        return json.load(file)  # type: ignore[no-any-return]
