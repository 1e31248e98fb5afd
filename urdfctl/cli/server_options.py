"""Options of `urdfctl server`. Annotations are evaluated here; see options.py."""

from dataclasses import dataclass
from typing import Annotated

import typer


@dataclass(kw_only=True)
class ServerOptions:
    """Serve an editor: findings while you type, fixes, hover, completion (Language Server Protocol).

    Editors start it themselves and talk to it through standard input and output; see docs/editors.md.

    \b
    Example: urdfctl server --tcp 2087
    """

    tcp: Annotated[
        int | None, typer.Option("--tcp", metavar="PORT", help="Listen on this port of localhost, for debugging.")
    ] = None
    stdio: Annotated[bool, typer.Option("--stdio", hidden=True, help="The default; editors pass it.")] = False
