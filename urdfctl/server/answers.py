"""The editor's questions, each passed to the module that answers it, with positions converted on both ways."""

from __future__ import annotations

from collections.abc import Iterable

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from urdfctl.diagnostic import Location, located
from urdfctl.errors import UserError
from urdfctl.report.fault_explanation import fault_explanation
from urdfctl.rules import all_faults
from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.server.features.actions import EXPLAIN, FIX_ALL, actions_at, edit_of
from urdfctl.server.features.completion import items_at
from urdfctl.server.features.hover import hover
from urdfctl.server.features.navigation import NamesAround, check_renamable, definitions, references, renamed
from urdfctl.server.features.symbols import hints_in, symbols_in
from urdfctl.server.protocol.dialogue import show_page
from urdfctl.server.protocol.positions import Positions
from urdfctl.server.protocol.uris import path_of
from urdfctl.server.protocol.versions import previewed
from urdfctl.server.protocol.window import Window

_Placed = types.DefinitionParams | types.ReferenceParams | types.RenameParams | types.PrepareRenameParams
_START = types.Position(0, 0)
_SYMBOLS = {
    "link": types.SymbolKind.Object,
    "joint": types.SymbolKind.Interface,
    "controller": types.SymbolKind.Class,
    "macro": types.SymbolKind.Function,
    "property": types.SymbolKind.Constant,
    "argument": types.SymbolKind.Variable,
}
_ITEMS = {
    "link": types.CompletionItemKind.Reference,
    "joint": types.CompletionItemKind.Reference,
    "controller": types.CompletionItemKind.Class,
    "type": types.CompletionItemKind.Class,
    "macro": types.CompletionItemKind.Function,
    "parameter": types.CompletionItemKind.Field,
    "interface": types.CompletionItemKind.EnumMember,
    "property": types.CompletionItemKind.Constant,
    "argument": types.CompletionItemKind.Variable,
    "package": types.CompletionItemKind.Module,
    "file": types.CompletionItemKind.File,
    "value": types.CompletionItemKind.Value,
    "option": types.CompletionItemKind.Keyword,
}


def answer_questions(server: Window) -> None:
    """Register what answers an editor."""
    _about_findings(server)
    _about_names(server)
    _about_places(server)
    _about_completion(server)
    _about_files(server)


def _about_findings(server: Window) -> None:
    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions([types.CodeActionKind.QuickFix, FIX_ALL]))
    def actions(window: Window, params: types.CodeActionParams) -> list[types.CodeAction]:
        found = window.findings.get(path_of(params.text_document.uri) or "", ())
        wanted = [str(getattr(kind, "value", kind)) for kind in params.context.only or ()]
        actions = actions_at(found, params.range, window.positions(), wanted)
        for action in actions:
            action.edit = window.versioned(action.edit) if action.edit else None
        return actions

    @server.command(EXPLAIN)
    async def explain(window: Window, code: str) -> str:
        fault = next((fault for fault in all_faults() if fault.code == code), None)
        if fault is None:
            raise JsonRpcInvalidParams(f"urdfctl has no rule {code}")
        text = fault_explanation(fault)
        await show_page(window, f"{code}.txt", text, instead=text)
        return text


def _about_names(server: Window) -> None:
    def names(window: Window, params: _Placed) -> NamesAround | None:
        question = window.question(params.text_document.uri, params.position)
        return NamesAround(question) if question else None

    def places(window: Window, found: Iterable[Location]) -> list[types.Location]:
        positions = window.positions()
        return [positions.location_of(at) for at in found]

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    def definition(window: Window, params: types.DefinitionParams) -> list[types.Location]:
        around = names(window, params)
        return places(window, definitions(around)) if around else []

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    def uses(window: Window, params: types.ReferenceParams) -> list[types.Location]:
        around = names(window, params)
        found = references(around, with_definition=params.context.include_declaration) if around else []
        return places(window, found)

    @server.feature(types.TEXT_DOCUMENT_RENAME)
    def rename(window: Window, params: types.RenameParams) -> types.WorkspaceEdit | None:
        around = names(window, params)
        try:
            edits = renamed(around, params.new_name) if around else None
        except UserError as error:
            raise JsonRpcInvalidParams(str(error)) from None
        if around is None or around.at is None or edits is None:
            return None
        edit = window.versioned(edit_of(edits, window.positions()))
        if around.at.is_computed:
            return previewed(edit, f"names from {around.at.span.text}", window.client_capabilities)
        return edit

    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    def prepare(window: Window, params: types.PrepareRenameParams) -> types.PrepareRenamePlaceholder | None:
        around = names(window, params)
        if around is None or around.at is None:
            return None
        try:
            check_renamable(around)
        except UserError as error:
            raise JsonRpcInvalidParams(str(error)) from None
        span = around.at.span
        return types.PrepareRenamePlaceholder(window.positions().range_of(located(span)), span.text)


def _about_places(server: Window) -> None:
    @server.feature(types.TEXT_DOCUMENT_HOVER)
    def about(window: Window, params: types.HoverParams) -> types.Hover | None:
        question = window.question(params.text_document.uri, params.position)
        found = window.findings.get(path_of(params.text_document.uri) or "", ())
        text = hover(question, found) if question else None
        return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, text)) if text else None


def _about_completion(server: Window) -> None:
    @server.feature(types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=list("\"'<{ :/[-")))
    def completion(window: Window, params: types.CompletionParams) -> list[types.CompletionItem]:
        question = window.question(params.text_document.uri, params.position)
        items = items_at(question, window.attempts(params.text_document.uri)) if question else []
        positions = window.positions()
        return [
            types.CompletionItem(
                label=item.text.strip(),
                kind=_ITEMS[item.kind],
                detail=item.kind,
                documentation=types.MarkupContent(types.MarkupKind.Markdown, item.about) if item.about else None,
                sort_text=f"{number:05}",
                filter_text=item.text,
                text_edit=types.TextEdit(_replaced(question, item, positions, params.position), item.text),
            )
            for number, item in enumerate(items)
            if question is not None
        ]


def _replaced(question: Question, item: OfferedItem, positions: Positions, at: types.Position) -> types.Range:
    """The range of the word that is typed already."""
    start = max(1, question.column - item.replaces)
    return types.Range(positions.position_of(question.file, question.line, start), at)


def _about_files(server: Window) -> None:
    def whole(window: Window, document: types.TextDocumentIdentifier) -> Question | None:
        return window.question(document.uri, _START)

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def symbols(window: Window, params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
        question, positions = whole(window, params.text_document), window.positions()
        return [
            types.DocumentSymbol(
                name=symbol.name,
                kind=_SYMBOLS[symbol.kind],
                range=positions.range_of(symbol.at),
                selection_range=positions.range_of(symbol.at),
                detail=symbol.kind,
            )
            for symbol in (symbols_in(question) if question else [])
            if symbol.name
        ]

    @server.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    def hints(window: Window, params: types.InlayHintParams) -> list[types.InlayHint]:
        question, positions = whole(window, params.text_document), window.positions()
        return [
            types.InlayHint(
                position=positions.position_of(question.file, hint.line, hint.column),
                label=f"= {hint.value}",
                padding_left=True,
            )
            for hint in (hints_in(question) if question else [])
            if question and params.range.start.line <= hint.line - 1 <= params.range.end.line
        ]
