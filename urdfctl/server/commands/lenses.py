"""The commands above the first line of a robot, for editors that show them there."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from lsprotocol import types

from urdfctl.server.commands.calls import CHOOSE_VARIANT, GRAPH, MIGRATE, PLAN, SMOKE, VIEW
from urdfctl.server.protocol.uris import path_of
from urdfctl.server.protocol.window import Window

_TITLES = {GRAPH: "graph", VIEW: "view in 3-D", SMOKE: "smoke test", PLAN: "plan with MoveIt", MIGRATE: "migrate"}
_ROOT = re.compile(r"<(robot|launch)\b")


def answer_lenses(server: Window) -> None:
    """Register the commands above robots."""

    @server.feature(types.TEXT_DOCUMENT_CODE_LENS, types.CodeLensOptions())
    def lenses(window: Window, params: types.CodeLensParams) -> list[types.CodeLens]:
        return [*_lenses(window, params.text_document.uri)]


def _lenses(window: Window, uri: str) -> Iterator[types.CodeLens]:
    path = path_of(uri)
    if path is None or window.checking is None:
        return
    workspace = window.checking.workspace_of(path)
    variants = workspace.variants(path)
    if not variants:
        return
    commands = dict(_TITLES)
    if len(variants) > 1:
        chosen = workspace.chosen(path)
        title = next((variant.title for variant in variants if variant.target == chosen), None)
        commands[CHOOSE_VARIANT] = f"shown: {title}" if title else f"{len(variants)} variants"
    start = types.Position(_first_line(window.positions().lines(path)), 0)
    for command, title in commands.items():
        yield types.CodeLens(types.Range(start, start), types.Command(title, command, arguments=[uri]))


def _first_line(lines: Iterable[str]) -> int:
    """The line of the root element, from 0; the first one in files that have none."""
    return next((number for number, line in enumerate(lines) if _ROOT.search(line)), 0)
