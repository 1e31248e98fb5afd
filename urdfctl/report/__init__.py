"""Output formats: each renders a report as text, without side effects."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from types import ModuleType

from urdfctl.lint.results import Report

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
    """Return the module of an output format. It is imported on first use."""
    return import_module(f"{__name__}.{_MODULES[name]}")


def render(report: Report, name: str) -> str:
    """Return a report in an output format."""
    render_format: Callable[[Report], str] = module_of(name).render
    return render_format(report)
