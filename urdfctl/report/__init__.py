"""The forms in which a run's findings are told, each a pure function of them."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from types import ModuleType

from urdfctl.report.common import Report

_MODULES = {
    "text": "text",
    "concise": "concise",
    "json": "json_report",
    "jsonl": "jsonl",
    "sarif": "sarif",
    "github": "github",
    "gitlab": "gitlab",
    "junit": "junit",
}
FORMATS = tuple(_MODULES)


def module_of(name: str) -> ModuleType:
    """What writes one of the forms, loaded when it is asked for."""
    return import_module(f"{__name__}.{_MODULES[name]}")


def render(report: Report, name: str) -> str:
    """A report in one of the forms."""
    written: Callable[[Report], str] = module_of(name).render
    return written(report)
