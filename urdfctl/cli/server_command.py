"""`urdfctl server`."""

from __future__ import annotations

import importlib.util

from urdfctl.errors import UserError
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfctl.cli.server_options import ServerOptions

_MOST_PORT = 65_535


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
