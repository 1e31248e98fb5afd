"""Launch files that need arguments: they are tested with values that their files have, as lint checks them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from urdfctl.lint.judging import lacks_robot
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.source.disk.files import is_launch

_MOST = 3
"""Robots of one launch file that are tested: each takes an engine some tenths of a second."""


def choices_of(
    targets: Sequence[Target],
    results: Sequence[TargetResult],
    variants: Callable[[list[Target]], list[list[Target]]],
) -> dict[int, list[Target]]:
    """Return targets with the first choices of the arguments that launch files need, by the index of each of these.

    variants: returns a target for each choice of arguments, or only the launch file itself.
    """
    needy = [
        index
        for index, (target, result) in enumerate(zip(targets, results, strict=True))
        if is_launch(target.path) and not target.launch and lacks_robot(result)
    ]
    found = variants([targets[index] for index in needy]) if needy else []
    given = ([target for target in choices if target.arguments][:_MOST] for choices in found)
    return {index: choices for index, choices in zip(needy, given, strict=True) if choices}
