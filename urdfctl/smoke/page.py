"""The report as one page of HTML that needs nothing else: no scripts, no fonts, no network; for light and dark."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from html import escape

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic
from urdfctl.report.common import as_text, relative, shown, visible
from urdfctl.smoke.reports import SmokeReport, how, steps, summary
from urdfctl.smoke.results import ControllerResult, Curve, Smoked, Verdict

_ORDER = (Verdict.FAILED, Verdict.WARNED, Verdict.SKIPPED, Verdict.PASSED)
_WIDTH, _HEIGHT = 240, 90
_PICTURE = 320
_STYLE = """
:root { color-scheme: light dark; --ink: #1a1c20; --dim: #646b76; --back: #fbfbfc; --card: #fff; --line: #dfe2e8;
  --passed: #16794a; --failed: #c22a2f; --warned: #9a6200; --skipped: #646b76; --told: #9097a3; --did: #2460c4; }
@media (prefers-color-scheme: dark) { :root { --ink: #e7e9ee; --dim: #9aa2af; --back: #14161a; --card: #1c1f25;
  --line: #31363f; --passed: #4cc38a; --failed: #ff6b6b; --warned: #e5a83b; --skipped: #9aa2af; --told: #7d8592;
  --did: #76a9ff; } }
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
.told { stroke: var(--told); stroke-dasharray: 4 3; } .did { stroke: var(--did); }
polyline { fill: none; stroke-width: 1.5; }
.axis { stroke: var(--line); } .bone { stroke: var(--ink); stroke-width: 1; }
li { margin: .6rem 0; } ul { padding-left: 1.1rem; margin: 0; }
"""


def page(report: SmokeReport) -> str:
    """The whole page: robots that fail first, and of each the controllers that fail first."""
    robots = sorted(report.smoked, key=lambda one: min((_rank(result) for result in one.controllers), default=9))
    parts = [part for one in robots for part in _robot(one)]
    head = f"<title>{_text(summary(report))}</title><style>{_STYLE}</style>"
    meta = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    title = f"<header><h1>Smoke test</h1><p>{_text(summary(report))}</p>"
    foot = f'<p class="dim">urdfctl {_text(__version__)}</p></header>'
    body = "\n".join([title + foot, *parts])
    return f'<!DOCTYPE html>\n<html lang="en"><head>{meta}{head}</head>\n<body>\n{body}\n</body></html>\n'


def _rank(result: ControllerResult) -> int:
    return _ORDER.index(result.verdict)


def _robot(one: Smoked) -> Iterator[str]:
    yield '<section><div class="top"><div>'
    yield f'<h2>{_text(shown(one.linted.path))}</h2><p class="dim">{_text(how(one))}</p>'
    counts = [(verdict, one.count(verdict)) for verdict in _ORDER]
    told = [f'<span class="{verdict.value}">{count} {verdict.value}</span>' for verdict, count in counts if count]
    yield f'<p class="verdict">{", ".join(told) or "no controllers"}</p></div>'
    yield f"{_picture(one.picture)}</div>"
    yield from _table(one)
    yield from _findings(one.linted.outcome.diagnostics)
    yield from _curves(one)
    yield "</section>"


def _table(one: Smoked) -> Iterator[str]:
    if not one.controllers:
        return
    yield '<div class="scroll"><table><thead><tr><th>controller</th><th>type</th><th>verdict</th><th>steps</th>'
    yield "<th>why</th></tr></thead><tbody>"
    for result in sorted(one.controllers, key=_rank):
        kind = result.verdict.value
        yield f"<tr><td><code>{_text(result.name)}</code></td><td><code>{_text(result.type or '')}</code></td>"
        yield f'<td class="verdict {kind}">{kind}</td><td>{_text(steps(result, one.linted.ros))}</td>'
        yield f'<td class="what">{_text(result.reason)}</td></tr>'
    yield "</tbody></table></div>"


def _findings(found: Sequence[Diagnostic]) -> Iterator[str]:
    if not found:
        return
    yield "<h3>What was found</h3><ul>"
    for diagnostic in map(relative, sorted(found, key=lambda one: (-one.severity.weight, one.order))):
        at, kind = diagnostic.at, diagnostic.severity.value
        yield f'<li><span class="verdict {kind}">{diagnostic.code}</span> {_text(diagnostic.message)}'
        yield f'<br><code class="dim">{_text(f"{at.file}:{at.line}:{at.column}")}</code>'
        if diagnostic.excerpt.strip():
            yield f"<pre>{_text(diagnostic.excerpt.strip())}</pre>"
        yield from (f'<p class="dim">{_text(note.message)}</p>' for note in diagnostic.notes)
        yield "</li>"
    yield "</ul>"


# -- drawings --------------------------------------------------------------------------------------------------------


def _curves(one: Smoked) -> Iterator[str]:
    if not one.curves:
        return
    failed = {result.name for result in one.controllers if result.verdict is Verdict.FAILED}
    yield "<h3>What was commanded (dashed) and what was measured</h3>"
    yield '<div class="curves">'
    for curve in sorted(one.curves, key=lambda curve: curve.controller not in failed):
        name = f"{curve.controller}: {curve.joint}, {_QUANTITIES.get(curve.quantity, curve.quantity)}"
        yield f"<figure>{_chart(curve, name)}<figcaption>{_text(name)}</figcaption></figure>"
    yield "</div>"


_QUANTITIES = {
    "position": "position in rad or m",
    "velocity": "velocity in rad/s or m/s",
    "ahead": "way ahead in m",
    "yaw": "turn to the left in rad",
}


def _chart(curve: Curve, name: str) -> str:
    values = [value for value in (*curve.commanded, *curve.measured) if math.isfinite(value)]
    low, high = min(values, default=0.0), max(values, default=1.0)
    span, most = (high - low) or 1.0, curve.seconds[-1] if curve.seconds else 1.0

    def line(points: Sequence[float], kind: str) -> str:
        pairs = [(x, y) for x, y in zip(curve.seconds, points, strict=False) if math.isfinite(y)]
        placed = [f"{x / most * _WIDTH:.1f},{(1 - (y - low) / span) * (_HEIGHT - 8) + 4:.1f}" for x, y in pairs]
        return f'<polyline class="{kind}" points="{" ".join(placed)}"/>' if placed else ""

    drawn = line(curve.commanded, "told") + line(curve.measured, "did")
    axis = f'<line class="axis" x1="0" y1="{_HEIGHT - 1}" x2="{_WIDTH}" y2="{_HEIGHT - 1}"/>'
    label = f"{name}, from {low:.3g} to {high:.3g} in {most:.2g} s"
    size = f'width="{_WIDTH}" height="{_HEIGHT}" viewBox="0 0 {_WIDTH} {_HEIGHT}"'
    return f'<svg role="img" aria-label="{_text(label)}" {size}><title>{_text(label)}</title>{axis}{drawn}</svg>'


def _picture(segments: Sequence[Sequence[float]]) -> str:
    """The robot seen from its left, in front, and above."""
    lines = [(*_seen(*one[:3]), *_seen(*one[3:])) for one in segments if all(map(math.isfinite, one))]
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


def _seen(x: float, y: float, z: float) -> tuple[float, float]:
    """Where a point is on the page: the robot looks to the lower left, its left side is to the right, up is up."""
    return (y - x) * 0.866, (x + y) * 0.35 - z


def _text(text: str) -> str:
    return escape(as_text(visible(text)))
