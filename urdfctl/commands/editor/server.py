"""`urdfctl server`."""

from __future__ import annotations

import importlib.util

from urdfctl.commands.declaring import OTHER, Command, Options, option
from urdfctl.errors import UserError

_MOST_PORT = 65_535


class ServerOptions(Options):
    """Serve an editor: findings while you type, fixes, hover, completion (Language Server Protocol).

    Editors start it themselves and talk to it through standard input and output; see docs/editors.md.

    \b
    Example: urdfctl server --tcp 2087
    """

    is_bounded = False
    """It may read nothing until its editor says which folders it shows; each request has bounds of its own."""

    tcp: int | None = option(OTHER, "Listen on this port of localhost, for debugging.", metavar="PORT")
    stdio: bool = option(OTHER, "The default; editors pass it.", hidden=True)


def run_server(options: ServerOptions) -> int:
    """Serve one editor until it ends, and return the exit status 0."""
    if importlib.util.find_spec("pygls") is None:
        raise UserError("the server needs pygls: pip install 'urdfctl[server]'")
    if options.tcp is not None and not 0 < options.tcp <= _MOST_PORT:
        raise UserError(f"--tcp must be a port from 1 to {_MOST_PORT}, not {options.tcp}")
    from urdfctl.server.app import make_server

    server = make_server()
    if options.tcp is None:
        server.start_io()
    else:
        server.start_tcp("127.0.0.1", options.tcp)
    return 0


command = Command(ServerOptions, run_server)
