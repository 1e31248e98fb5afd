"""Messages of an editor: each is looked at here before anything answers it, and each request is answered once.

pygls answers no request whose parameters are wrong, and sends and logs a traceback for any other error.
"""

from __future__ import annotations

import inspect
import logging
import re
from collections.abc import Callable, Generator, Sequence
from enum import Enum
from types import GenericAlias
from typing import Any, get_args, get_origin

import attrs
import cattrs
from lsprotocol import types
from pygls.exceptions import (
    JsonRpcException,
    JsonRpcInternalError,
    JsonRpcInvalidParams,
    JsonRpcInvalidRequest,
    JsonRpcMethodNotFound,
    JsonRpcParseError,
    JsonRpcServerNotInitialized,
)
from pygls.lsp.server import LanguageServer
from pygls.protocol import JsonRPCNotification, JsonRPCRequestMessage, LanguageServerProtocol, default_converter
from pygls.protocol import lsp_method as answers

from urdfctl.server.protocol.positions import Units
from urdfctl.server.protocol.texts import changed
from urdfctl.server.protocol.uris import path_of, uris_in

Message = dict[str, Any]
_log = logging.getLogger(__name__)


def strict_converter() -> cattrs.Converter:
    """Return what makes messages from JSON. It takes no other type for a text, a whole number, or true and false."""
    converter: cattrs.Converter = default_converter()  # type: ignore[no-untyped-call]
    for kind in (str, int, bool):
        converter.register_structure_hook(kind, _checked)
    converter.register_structure_hook(types.ProgressToken, _mark)
    converter.register_structure_hook(types.ProgressToken | None, _mark)

    def sequence(wanted: Any) -> Callable[[object, object], object]:
        """What makes a sequence from a list, and from nothing else that can be gone through."""
        kind = GenericAlias(tuple, (*get_args(wanted), ...))
        make = converter.get_structure_hook(kind)

        def made(value: object, _: object) -> object:
            return make(_checked(value, list), kind)

        return made

    converter.register_structure_hook_factory(_is_sequence, sequence)
    return converter


def _mark(value: object, kind: Any) -> object:
    """The mark of a request or of its progress: a text or a whole number."""
    is_missing = value is None and type(None) in get_args(kind)
    return None if is_missing else _checked(value, str if isinstance(value, str) else int)


def _is_sequence(kind: Any) -> bool:
    origin: Any = get_origin(kind)
    return origin is Sequence


def _checked(value: object, kind: type) -> object:
    if issubclass(kind, Enum):
        return kind(value)
    if kind is int and isinstance(value, float) and value.is_integer():  # as some editors write all numbers
        return int(value)
    if type(value) is not kind:
        raise TypeError(f"expected {kind.__name__}")
    return value


class Server(LanguageServer):
    """A server that says which files an editor may ask about."""

    protocol: Protocol

    def __init__(self, name: str, version: str) -> None:
        super().__init__(name, version, protocol_cls=Protocol, converter_factory=strict_converter)

    def admits(self, uri: str) -> bool:
        """Return whether an editor may ask about a file."""
        raise NotImplementedError


class Protocol(LanguageServerProtocol):
    """The protocol, with each message looked at in one place.

    A request gets one answer: what its handler returns, or an error. The file that it is about passes `Server.admits`;
    of others nothing is known. A notification that is wrong is logged, and changes nothing.
    """

    _server: Server

    def __init__(self, server: Server, converter: cattrs.Converter) -> None:
        super().__init__(server, converter)
        self._shape = converter
        self._is_initialized = self._is_ended = False

    def structure_message(self, data: Message) -> Any:
        """Return an object of JSON as it is: only whole messages are structured, in `handle_message`."""
        return data

    def handle_message(self, message: Any) -> None:
        """Answer a request, take a notification, or take an answer to a request of the server."""
        identity = message.get("id") if isinstance(message, dict) else None
        try:
            self._take(message)
        except JsonRpcException as error:
            self.refuse(identity, error)
        except Exception as error:  # noqa: BLE001 (whatever it is, the request is answered)
            _log.exception("urdfctl: a message cannot be handled")
            self.refuse(identity, JsonRpcInternalError(str(error)))

    def _take(self, message: Any) -> None:
        if not isinstance(message, dict) or message.get("jsonrpc") != self.VERSION:
            raise JsonRpcInvalidRequest("a message must be an object of JSON-RPC 2.0")
        if "method" not in message:
            self._take_answer(message)
        elif "id" in message:
            self._take_request(message)
        else:
            self._take_notification(message)

    def _take_request(self, message: Message) -> None:
        if type(message["id"]) not in {int, str}:
            raise JsonRpcInvalidRequest("the id of a request must be a text or a whole number")
        method = message["method"]
        if self._is_ended or (method == types.INITIALIZE and self._is_initialized):
            raise JsonRpcInvalidRequest(f"{method!a} is asked too late")
        if method != types.INITIALIZE and not self._is_initialized:
            raise JsonRpcServerNotInitialized("the server is not initialized")
        request = self._structured(message, JsonRPCRequestMessage)
        if method == types.SHUTDOWN:
            self._is_ended = True
        document = getattr(request.params, "text_document", None)
        if document is not None and not self._server.admits(document.uri):
            self._send_response(message["id"])
            return
        super().handle_message(request)
        self._is_initialized = True  # if it was not before, this was the request for it

    def _take_notification(self, message: Message) -> None:
        if (not self._is_initialized or self._is_ended) and message["method"] != types.EXIT:
            return
        told = self._structured(message, JsonRPCNotification)
        if isinstance(told, types.DidChangeTextDocumentNotification):
            uri = told.params.text_document.uri
            if self.workspace.get_text_document(uri).version is None:
                raise JsonRpcInvalidParams(f"{uri!a} is changed, but not open")
        super().handle_message(told)

    def _take_answer(self, message: Message) -> None:
        """Take the editor's answer to a request; a wrong one is an error, for who waits for it."""
        try:
            answer = super().structure_message(message)
        except JsonRpcException as error:
            answer = types.ResponseErrorMessage(message.get("id"), error=error.to_response_error())
        super().handle_message(answer)

    def _structured(self, message: Message, other: Callable[..., Any]) -> Any:
        """The message with its parameters. other: makes a message of which the protocol does not say what is in it.

        Raises JsonRpcInvalidParams if anything is missing or of another type, or a URI is not one.
        """
        method, params = message["method"], message.get("params")
        if not isinstance(method, str):
            raise JsonRpcInvalidRequest("a method must be a text")
        kind, _, shape, _ = types.METHOD_TO_TYPES.get(method, (None, None, None, None))
        if kind is not None and "id" in message and not hasattr(attrs.fields(kind), "id"):
            raise JsonRpcMethodNotFound(f"{method!a} is not a request")
        if kind is None:
            named = {"id": message["id"]} if "id" in message else {}
            return other(**named, method=method, jsonrpc=self.VERSION, params=params)
        try:
            made: Any = self._shape.structure(message if shape else {**message, "params": None}, kind)
        except Exception as error:  # noqa: BLE001 (of cattrs, of the checks of lsprotocol, or of nesting too deeply)
            raise JsonRpcInvalidParams(_reason(error)) from None
        for uri in uris_in(made.params):
            path_of(uri)
        if method == types.WORKSPACE_EXECUTE_COMMAND:
            self._check_words(made.params)
        return made

    def _check_words(self, params: types.ExecuteCommandParams) -> None:
        """Raise JsonRpcInvalidParams if a command gets fewer or more arguments than it takes."""
        command = self.fm.commands.get(params.command)
        if command is None:
            return
        function: Any = getattr(command, "func", command)  # pygls wraps a coroutine without its parameters
        try:
            inspect.signature(function).bind(self._server, *(params.arguments or ()))
        except TypeError as error:
            raise JsonRpcInvalidParams(f"{params.command}: {error}") from None

    def refuse(self, identity: object, error: JsonRpcException) -> None:
        """Answer with an error; if there is no request to answer, only log it."""
        known: Any = identity if type(identity) in {int, str} else None
        if known is not None or isinstance(error, JsonRpcParseError | JsonRpcInvalidRequest):
            self._send_response(known, error=error.to_response_error())
        else:
            _log.warning("urdfctl: a message is ignored: %s", error.message)

    def _send_response(
        self, msg_id: int | str | None, result: Any = None, error: types.ResponseError | None = None
    ) -> None:
        """Send an answer; an error without the traceback that pygls adds, and with an id even if that is null."""
        if error is None:
            super()._send_response(msg_id, result)  # type: ignore[arg-type]
        else:
            reason = {"code": error.code, "message": error.message}
            self._send_data({"jsonrpc": self.VERSION, "id": msg_id, "error": reason})

    @answers(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: types.DidChangeTextDocumentParams) -> Generator[Any, Any, None]:
        """Change an open text. pygls parts lines where the protocol does not, such as at a form feed."""
        uri, version = params.text_document.uri, params.text_document.version
        document = self.workspace.get_text_document(uri)
        text = changed(document.source, params.content_changes, Units(self.workspace.position_codec))
        language = document.language_id or ""
        self.workspace.put_text_document(types.TextDocumentItem(uri, language, version, text))
        yield self.fm.features[types.TEXT_DOCUMENT_DID_CHANGE], (params,), None


class _NoRefusals(logging.Filter):
    """Keeps what was refused out of the log, where pygls writes it with a traceback. Crashes stay in it."""

    def filter(self, record: logging.LogRecord) -> bool:
        error = record.exc_info[1] if record.exc_info else None
        if record.name == "pygls.server":  # it reads messages
            return not isinstance(error, ValueError | RecursionError)
        if str(record.msg).startswith("Unable to deserialize message"):
            return False
        return not isinstance(error, JsonRpcException) or isinstance(error, JsonRpcInternalError)


for _name in ("pygls.server", "pygls.protocol.json_rpc"):
    logging.getLogger(_name).addFilter(_NoRefusals())


def _reason(error: Exception) -> str:
    """What is wrong with some parameters, where, in the names of the protocol."""
    reasons = cattrs.transform_error(error) if isinstance(error, cattrs.BaseValidationError) else [str(error)]
    return re.sub(r"_([a-z])", lambda found: found[1].upper(), "; ".join(reasons))
