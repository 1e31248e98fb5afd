"""The robot as a drawing of lines, where it cannot be shown in 3-D."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

from urdfctl.output.printing import visible

SIZE = 320


def drawing(segments: Sequence[Sequence[float]], name: str) -> str:
    """Return line segments (x1, y1, z1, x2, y2, z2) in m as SVG, viewed from the front left and from above; empty if
    there are none."""
    finite = (segment for segment in segments if all(map(math.isfinite, segment)))
    lines = [(*_projected(*segment[:3]), *_projected(*segment[3:])) for segment in finite]
    if not lines:
        return ""
    xs = [x for line in lines for x in line[::2]]
    ys = [y for line in lines for y in line[1::2]]
    size = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    scale, height = (SIZE - 16) / size, (max(ys) - min(ys)) / size * (SIZE - 16) + 16
    drawn = []
    for line in lines:
        a, c = ((x - min(xs)) * scale + 8 for x in line[::2])
        b, d = ((y - min(ys)) * scale + 8 for y in line[1::2])
        drawn.append(f'<line class="bone" x1="{a:.1f}" y1="{b:.1f}" x2="{c:.1f}" y2="{d:.1f}"/>')
    view = f'width="{SIZE}" height="{height:.0f}" viewBox="0 0 {SIZE} {height:.0f}"'
    return f'<svg role="img" aria-label="{escape(visible(name))} at spawn" {view}>{"".join(drawn)}</svg>'


def _projected(x: float, y: float, z: float) -> tuple[float, float]:
    """The position of a point on the page. The robot faces the lower left, and its left side is on the right."""
    return (y - x) * 0.866, (x + y) * 0.35 - z
