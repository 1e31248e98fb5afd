"""What the site's search needs to find a message by the line that was printed: the literal words of each message."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

from urdfctl.catalog.log_messages import log_messages
from urdfctl.logs.index import Index

_SCRIPT = Path(__file__).resolve().parent / "search" / "lines.mjs"
FOLDER = "search"
"""The folder of the site for the script and its data; zensical.toml names the script."""


def words_of_messages() -> list[list[str]]:
    """Return the words that each printed form of a message has, in small letters."""
    words = (sorted({word.lower() for word in form}) for form in Index(log_messages()).words)
    return sorted({tuple(form): list(form) for form in words if form}.values())


def write_search(pages: Path) -> None:
    """Write the script and its data beside the pages."""
    folder = pages / FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(_SCRIPT, folder / _SCRIPT.name)
    (folder / "messages.json").write_text(json.dumps(words_of_messages(), separators=(",", ":")), "utf-8")
