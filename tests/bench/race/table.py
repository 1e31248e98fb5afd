"""Rows of measurements: medians, ratios, how they grow with the robot, and how all this is printed."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

TARGETS = {"UR5e": 0.85, "UR5e controllers": 1.2, "PR2": 0.65, "1200 links": 0.25, "corpus": 0.14, "PR2 memory": 60.0}


@dataclass(frozen=True)
class Row:
    """One line of the table: what A took, and B in the same turns; no B where none does the like."""

    name: str
    unit: str
    a: list[float]
    b: list[float]
    what: str
    note: str = ""
    links: int = 0

    def summary(self) -> dict[str, Any]:
        """Medians, the ratio of the medians, and the extremes of the turns' ratios; None where there is no B."""
        pairs = [x / y for x, y in zip(self.a, self.b, strict=True)] if self.b else []
        a, b = statistics.median(self.a), statistics.median(self.b) if self.b else None
        numbers = {
            "a_median": a,
            "b_median": b,
            "ratio": a / b if b else None,
            "ratio_min": min(pairs, default=None),
            "ratio_max": max(pairs, default=None),
        }
        target_of = "ratio" if self.unit == "s" else "a_median"
        return {**asdict(self), **numbers, "target": TARGETS.get(self.name), "target_of": target_of}


def exponent(points: Sequence[tuple[float, float]]) -> float | None:
    """The slope of log y over log x, by least squares: 1 is linear, 2 quadratic; None of fewer than two sizes."""
    if len({x for x, _ in points}) < 2:
        return None
    return statistics.linear_regression([math.log(x) for x, _ in points], [math.log(y) for _, y in points]).slope


def growth(rows: Sequence[dict[str, Any]]) -> dict[str, dict[str, float]]:
    """Exponents of A and B over all sizes, and over the largest two, where start-up no longer counts."""
    found: dict[str, dict[str, float]] = {}
    for side in ("a", "b"):
        sizes = [(r["links"], r[f"{side}_median"]) for r in rows if r["links"] and r[f"{side}_median"]]
        for key, some in (("all", sorted(sizes)), ("largest_two", sorted(sizes)[-2:])):
            slope = exponent(some)
            if slope is not None:
                found.setdefault(side, {})[key] = slope
    return found


def line(row: dict[str, Any], broad: int) -> str:
    unit = row["unit"]
    places, width = (3 if unit == "s" else 1), 10 - len(unit)
    medians = "".join(
        f"{'-':>11}" if row[k] is None else f"{row[k]:>{width}.{places}f} {unit}" for k in ("a_median", "b_median")
    )
    ratio, pairs = f"{'-':>8}", "-"
    if row["ratio"] is not None:
        ratio, pairs = f"{row['ratio']:>8.2f}", f"{row['ratio_min']:.2f}..{row['ratio_max']:.2f}"
    target = ""
    if row["target"] is not None:
        target = f"<= {row['target']:g}" + ("" if row["target_of"] == "ratio" else f" {unit} (A)")
    return f"{row['name']:{broad}}{medians}{ratio}   {pairs:<14}{target:<15}{len(row['a']):>4}   {row['what']}"


def text(rows: Sequence[dict[str, Any]]) -> str:
    """The table with its notes."""
    broad = max(len(row["name"]) for row in rows) + 2
    head = f"{'':{broad}}{'A median':>11}{'B median':>11}{'ratio':>8}   {'of pairs':<14}{'target':<15}runs   A | B"
    lines = [head, *(line(row, broad) for row in rows)]
    lines += ["", *(f"{row['name']}: {row['note']}" for row in rows if row["note"])]
    for side, slopes in growth(rows).items():
        over, last = slopes["all"], slopes["largest_two"]
        lines.append(f"growth of {side.upper()}: time ~ links^{over:.2f}; between the largest two {last:.2f}")
    return "\n".join(lines).rstrip()
