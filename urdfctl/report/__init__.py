"""The forms in which a run's findings are told, each a pure function of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.report import concise, json_report, text
from urdfctl.report.common import Report

FORMATS: Mapping[str, Callable[[Report], str]] = {
    "text": text.render,
    "concise": concise.render,
    "json": json_report.render,
}
