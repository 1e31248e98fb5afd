"""The variants of a robot: with each choice of its arguments that `[[robot]]` or a launch file makes."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any

from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.source.opaque import is_known
from urdfctl.startup.records import NamedTuple


class Variant(NamedTuple):
    """A robot with some arguments, as something starts it.

    title: what tells it from the other variants: the arguments that differ, the launch file, the description.
    arguments: all xacro arguments that the description is given.
    """

    target: Target
    title: str
    robot: str
    file: str
    arguments: tuple[tuple[str, str], ...]
    launch: str | None

    def to_json(self, *, is_shown: bool) -> dict[str, Any]:
        """Return the variant as the editor gets it; `target` is what it chooses the variant by."""
        return {
            "title": self.title,
            "robot": self.robot,
            "file": self.file,
            "arguments": dict(self.arguments),
            "launch": self.launch,
            "target": self.target._asdict(),
            "shown": is_shown,
        }


def variants_among(pairs: Iterable[tuple[Target, TargetResult]], folder: str) -> list[Variant]:
    """Return the variants of the robots among some results, each once, in order. folder: titles name files from it."""
    found: dict[tuple[object, ...], tuple[Target, TargetResult]] = {}
    for target, result in pairs:
        if result.robot is not None and not result.library:
            found.setdefault((result.path, result.arguments, result.launch), (target, result))
    results = [result for _, result in found.values()]
    titles = [_title(result, results, folder) for result in results]
    return [
        Variant(
            target=target,
            title=title if titles.count(title) == 1 else f"{title} in {os.path.relpath(result.path, folder)}",
            robot=robot_name(result),
            file=result.path,
            arguments=result.arguments,
            launch=result.launch,
        )
        for (target, result), title in zip(found.values(), titles, strict=True)
    ]


def _title(result: TargetResult, among: Sequence[TargetResult], folder: str) -> str:
    same = [dict(other.arguments) for other in among if other.path == result.path]
    given = (f"{name}:={value}" for name, value in result.arguments if any(other.get(name) != value for other in same))
    launch = f"({os.path.relpath(result.launch, folder)})" if result.launch else ""
    return " ".join(part for part in (robot_name(result), *given, launch) if part)


def robot_name(result: TargetResult) -> str:
    """Return the name of a robot; that of its file if it has none, or is unknown."""
    return result.robot if result.robot and is_known(result.robot) else os.path.basename(result.path)
