"""The robot in 3-D as a page of its own."""

from __future__ import annotations

from typing import Any

from urdfctl.output.printing import visible_in
from urdfctl.report.common import shown
from urdfctl.report.pages import page
from urdfctl.view.joints import CONTROLS


def html(scene: dict[str, Any], file: str, distro: str = "") -> str:
    """Return the page. Its parts `robot_part.html.j2` and, once for all robots of a page, `robot_script.html.j2` can be
    included in others, with the values of `part_values`."""
    scene = visible_in(scene)
    title = f"{scene['robot'] or shown(file)} in 3-D"
    return page("view", title=title, file=shown(file), distro=distro, scene=scene, **part_values())


def part_values() -> dict[str, Any]:
    """Return what `robot_part.html.j2` needs besides its `scene`."""
    return {"controls": list(CONTROLS.items()), "words": CONTROLS}
