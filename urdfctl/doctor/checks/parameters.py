"""The parameters of a running node, beside those that the files give it."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from typing import Any

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.recording import LEFT_OUT
from urdfctl.rules.running.running_parameter_differs import running_parameter_differs

_MOST_NOTES = 5
_LIKE = 1e-6
_AUTOMATIC = ("use_sim_time", "robot_description")
"""Parameters that launch arguments or other nodes mostly give."""


def of_manager(exam: Examination, manager: str) -> Iterator[Ailment]:
    """Yield the parameters in which a running manager differs from the files; its controllers' types are told apart."""
    meant = {name: value for name, value in exam.settings(manager).items() if not name.endswith(".type")}
    yield from of_parameters(exam, manager, meant, "")


def of_parameters(exam: Examination, node: str, meant: Mapping[str, Any], at: str) -> Iterator[Ailment]:
    """Yield one finding for the parameters in which a running node differs from the files."""
    running = exam.recording.parameters(node)
    differing = [
        (name, running[name], value)
        for name, value in meant.items()
        if name in running and name not in _AUTOMATIC and not _is_same(running[name], value)
    ]
    if differing:
        (name, runs, files), *rest = differing
        notes = [f"{other}: {_written(one)}, the files say {_written(two)}" for other, one, two in rest[:_MOST_NOTES]]
        facts = {"parameter": name, "running": _written(runs), "files": _written(files)}
        yield ailment(running_parameter_differs, at, notes, node=node, **facts)


def _is_same(one: object, other: object) -> bool:
    if one == LEFT_OUT:
        return True
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_is_same, one, other))
    first, second = _number(one), _number(other)
    if first is not None and second is not None:
        return first == second or math.isclose(first, second, rel_tol=_LIKE, abs_tol=_LIKE)
    return str(one) == str(other) or (other is None and one in ("", [], None))


def _number(value: object) -> float | None:
    """A number, also one that JSON has no way to write; None for anything else."""
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return float(value) if math.isfinite(value) else None
    return None


def _written(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
