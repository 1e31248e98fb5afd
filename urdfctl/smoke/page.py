"""The report as one self-contained page of HTML: no scripts, no fonts, no network; with a light and a dark style."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from html import escape

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic
from urdfctl.report.common import as_text, relative, visible
from urdfctl.smoke.reports import SmokeReport, heading, how, steps, summary
from urdfctl.smoke.results import ControllerResult, Curve, Smoked, Verdict

_ORDER = (Verdict.FAILED, Verdict.WARNED, Verdict.SKIPPED, Verdict.PASSED)
_WIDTH, _HEIGHT = 240, 90
_PICTURE = 320
_STYLE = """
:root { color-scheme: light dark; --ink: #1a1c20; --dim: #646b76; --back: #fbfbfc; --card: #fff; --line: #dfe2e8;
  --passed: #16794a; --failed: #c22a2f; --warned: #9a6200; --skipped: #646b76; --commanded: #9097a3;
  --measured: #2460c4; }
@media (prefers-color-scheme: dark) { :root { --ink: #e7e9ee; --dim: #9aa2af; --back: #14161a; --card: #1c1f25;
  --line: #31363f; --passed: #4cc38a; --failed: #ff6b6b; --warned: #e5a83b; --skipped: #9aa2af; --commanded: #7d8592;
  --measured: #76a9ff; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 72rem; background: var(--back); color: var(--ink);
  font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: 0; } h2 { font-size: 1.1rem; margin: 0; overflow-wrap: anywhere; }
h3 { font-size: .95rem; margin: 1.25rem 0 .5rem; } p { margin: .25rem 0; } .dim { color: var(--dim); }
section { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1.25rem;
  margin-top: 1.25rem; }
.top { display: flex; gap: 1.25rem; justify-content: space-between; flex-wrap: wrap; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; width: 100%; margin-top: .75rem; }
th, td { text-align: left; vertical-align: top; padding: .4rem .75rem .4rem 0; border-top: 1px solid var(--line); }
th { font-weight: 600; color: var(--dim); font-size: .85rem; border-top: 0; } td.what { overflow-wrap: anywhere; }
code, pre { font: .85rem/1.45 ui-monospace, monospace; } pre { margin: .35rem 0; overflow-x: auto; }
.verdict { font-weight: 600; } .passed { color: var(--passed); } .failed, .error { color: var(--failed); }
.warned, .warning { color: var(--warned); } .skipped, .info { color: var(--skipped); }
.curves { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; } figcaption { font-size: .8rem; color: var(--dim); }
svg { display: block; max-width: 100%; }
.commanded { stroke: var(--commanded); stroke-dasharray: 4 3; } .measured { stroke: var(--measured); }
polyline { fill: none; stroke-width: 1.5; }
.axis { stroke: var(--line); } .bone { stroke: var(--ink); stroke-width: 1; }
li { margin: .6rem 0; } ul { padding-left: 1.1rem; margin: 0; }
"""


def page(report: SmokeReport) -> str:
    """Return the whole page: robots with failures first, and for each robot the failed controllers first."""
    robots = sorted(report.smoked, key=lambda robot: min(map(_rank, robot.controllers), default=9))
    sections = [line for robot in robots for line in _robot(robot)]
    head = f"<title>{_text(summary(report))}</title><style>{_STYLE}</style>"
    meta = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    title = f"<header><h1>Smoke test</h1><p>{_text(summary(report))}</p>"
    foot = f'<p class="dim">urdfctl {_text(__version__)}</p></header>'
    body = "\n".join([title + foot, *sections])
    return f'<!DOCTYPE html>\n<html lang="en"><head>{meta}{head}</head>\n<body>\n{body}\n</body></html>\n'


def _rank(result: ControllerResult) -> int:
    return _ORDER.index(result.verdict)


def _robot(robot: Smoked) -> Iterator[str]:
    yield '<section><div class="top"><div>'
    yield f'<h2>{_text(heading(robot))}</h2><p class="dim">{_text(how(robot))}</p>'
    counts = [(verdict.value, robot.count(verdict)) for verdict in _ORDER]
    verdicts = [f'<span class="{verdict}">{count} {verdict}</span>' for verdict, count in counts if count]
    yield f'<p class="verdict">{", ".join(verdicts) or "no controllers"}</p></div>'
    yield f"{_picture(robot.picture)}</div>"
    yield from _table(robot)
    yield from _findings(robot.linted.outcome.diagnostics)
    yield from _curves(robot)
    yield "</section>"


def _table(robot: Smoked) -> Iterator[str]:
    if not robot.controllers:
        return
    yield '<div class="scroll"><table><thead><tr><th>controller</th><th>type</th><th>verdict</th><th>stages</th>'
    yield "<th>reason</th></tr></thead><tbody>"
    for result in sorted(robot.controllers, key=_rank):
        kind = result.verdict.value
        yield f"<tr><td><code>{_text(result.name)}</code></td><td><code>{_text(result.type or '')}</code></td>"
        yield f'<td class="verdict {kind}">{kind}</td><td>{_text(steps(result, robot.linted.ros))}</td>'
        yield f'<td class="what">{_text(result.reason)}</td></tr>'
    yield "</tbody></table></div>"


def _findings(diagnostics: Sequence[Diagnostic]) -> Iterator[str]:
    if not diagnostics:
        return
    yield "<h3>Findings</h3><ul>"
    ordered = sorted(diagnostics, key=lambda diagnostic: (-diagnostic.severity.weight, diagnostic.order))
    for diagnostic in map(relative, ordered):
        at, kind = diagnostic.at, diagnostic.severity.value
        yield f'<li><span class="verdict {kind}">{diagnostic.code}</span> {_text(diagnostic.message)}'
        yield f'<br><code class="dim">{_text(f"{at.file}:{at.line}:{at.column}")}</code>'
        if diagnostic.excerpt.strip():
            yield f"<pre>{_text(diagnostic.excerpt.strip())}</pre>"
        yield from (f'<p class="dim">{_text(note.message)}</p>' for note in diagnostic.notes)
        yield "</li>"
    yield "</ul>"


# -- drawings --------------------------------------------------------------------------------------------------------


def _curves(robot: Smoked) -> Iterator[str]:
    if not robot.curves:
        return
    failed = {result.name for result in robot.controllers if result.verdict is Verdict.FAILED}
    yield "<h3>Commanded (dashed) and measured motion</h3>"
    yield '<div class="curves">'
    for curve in sorted(robot.curves, key=lambda curve: curve.controller not in failed):
        name = f"{curve.controller}: {curve.joint}, {_QUANTITIES.get(curve.quantity, curve.quantity)}"
        yield f"<figure>{_chart(curve, name)}<figcaption>{_text(name)}</figcaption></figure>"
    yield "</div>"


_QUANTITIES = {
    "position": "position in rad or m",
    "velocity": "velocity in rad/s or m/s",
    "ahead": "distance forward in m",
    "distance": "distance from the start in m",
    "yaw": "turn left in rad",
}


def _chart(curve: Curve, name: str) -> str:
    values = [value for value in (*curve.commanded, *curve.measured) if math.isfinite(value)]
    low, high = min(values, default=0.0), max(values, default=1.0)
    span, most = (high - low) or 1.0, curve.seconds[-1] if curve.seconds else 1.0

    def line(points: Sequence[float], kind: str) -> str:
        pairs = [(x, y) for x, y in zip(curve.seconds, points, strict=False) if math.isfinite(y)]
        placed = [f"{x / most * _WIDTH:.1f},{(1 - (y - low) / span) * (_HEIGHT - 8) + 4:.1f}" for x, y in pairs]
        return f'<polyline class="{kind}" points="{" ".join(placed)}"/>' if placed else ""

    drawn = line(curve.commanded, "commanded") + line(curve.measured, "measured")
    axis = f'<line class="axis" x1="0" y1="{_HEIGHT - 1}" x2="{_WIDTH}" y2="{_HEIGHT - 1}"/>'
    label = f"{name}, from {low:.3g} to {high:.3g} in {most:.2g} s"
    size = f'width="{_WIDTH}" height="{_HEIGHT}" viewBox="0 0 {_WIDTH} {_HEIGHT}"'
    return f'<svg role="img" aria-label="{_text(label)}" {size}><title>{_text(label)}</title>{axis}{drawn}</svg>'


def _picture(segments: Sequence[Sequence[float]]) -> str:
    """The robot, viewed from its front left and from above."""
    finite = (segment for segment in segments if all(map(math.isfinite, segment)))
    lines = [(*_projected(*segment[:3]), *_projected(*segment[3:])) for segment in finite]
    if not lines:
        return ""
    xs = [x for line in lines for x in line[::2]]
    ys = [y for line in lines for y in line[1::2]]
    size = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    scale, height = (_PICTURE - 16) / size, (max(ys) - min(ys)) / size * (_PICTURE - 16) + 16

    def placed(x: float, y: float) -> tuple[float, float]:
        return (x - min(xs)) * scale + 8, (y - min(ys)) * scale + 8

    drawn = []
    for x1, y1, x2, y2 in lines:
        (a, b), (c, d) = placed(x1, y1), placed(x2, y2)
        drawn.append(f'<line class="bone" x1="{a:.1f}" y1="{b:.1f}" x2="{c:.1f}" y2="{d:.1f}"/>')
    view = f'width="{_PICTURE}" height="{height:.0f}" viewBox="0 0 {_PICTURE} {height:.0f}"'
    return f'<svg role="img" aria-label="the robot at spawn" {view}>{"".join(drawn)}</svg>'


def _projected(x: float, y: float, z: float) -> tuple[float, float]:
    """The position of a point on the page. The robot faces the lower left, and its left side is on the right."""
    return (y - x) * 0.866, (x + y) * 0.35 - z


def _text(text: str) -> str:
    return escape(as_text(visible(text)))
