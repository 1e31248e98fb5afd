"""What the server asks an editor to do: to show a page, to let the user choose, to show how far something is."""

from __future__ import annotations

import asyncio
import os
import uuid
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import asynccontextmanager

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from urdfctl.errors import UserError
from urdfctl.output.temporary import temporary_folder
from urdfctl.server.protocol.uris import uri_of
from urdfctl.server.protocol.window import Window

PICK = "urdfctl/pick"
"""The request for a list to choose from. Only editors that offer it in their initialization options get it."""


def say(window: Window, text: str, kind: types.MessageType = types.MessageType.Info) -> None:
    """Show a message."""
    window.window_show_message(types.ShowMessageParams(kind, f"urdfctl: {text}"))


async def show_page(window: Window, name: str, text: str, instead: str | None = None) -> str:
    """Write a page to a temporary file, and open it: HTML in a browser, other texts in the editor. Return its URI.

    instead: the message of an editor that cannot open files; if None, it names the file.
    """
    folder = window.temporary_folder()
    path = os.path.join(temporary_folder(folder), name)
    with open(path, "w", encoding="utf-8", errors="surrogateescape") as file:
        file.write(text)
    uri = uri_of(path)
    can = window.client_capabilities.window
    if can and can.show_document and can.show_document.support:
        asked = types.ShowDocumentParams(uri, external=name.endswith(".html"), take_focus=True)
        shown = await window.window_show_document_async(asked)
        if shown.success:
            return uri
    say(window, instead or f"see {path}")
    return uri


async def pick(window: Window, question: str, choices: Sequence[str]) -> int | None:
    """Let the user choose, and return the number of the choice; None if the user chose nothing.

    Raises UserError if the editor has no way to ask.
    """
    if window.can_pick:
        chosen = await window.protocol.send_request_async(PICK, {"title": question, "choices": list(choices)})
        return chosen if isinstance(chosen, int) and 0 <= chosen < len(choices) else None
    actions = [types.MessageActionItem(choice) for choice in choices]
    asked = types.ShowMessageRequestParams(types.MessageType.Info, question, actions)
    try:
        action = await window.window_show_message_request_async(asked)
    except JsonRpcException:
        raise UserError(f"this editor cannot ask: {question} ({', '.join(choices)})") from None
    return choices.index(action.title) if action is not None and action.title in choices else None


Report = Callable[[str], None]
"""Shows how far something is."""


@asynccontextmanager
async def progress(window: Window, title: str, cancelled: asyncio.Event) -> AsyncIterator[Report]:
    """Show that something is going on, in an editor that can. `cancelled` is set when the user has had enough of it."""
    can = window.client_capabilities.window
    if not (can and can.work_done_progress):
        yield lambda _: None
        return
    shown, token = window.work_done_progress, str(uuid.uuid4())
    await shown.create_async(token)
    loop = asyncio.get_running_loop()
    shown.tokens[token].add_done_callback(lambda _: loop.call_soon_threadsafe(cancelled.set))
    shown.begin(token, types.WorkDoneProgressBegin(title=title, cancellable=True))
    try:
        yield lambda text: shown.report(token, types.WorkDoneProgressReport(message=text, cancellable=True))
    finally:
        shown.end(token, types.WorkDoneProgressEnd())
        del shown.tokens[token]
