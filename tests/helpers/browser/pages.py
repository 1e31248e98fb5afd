"""Read pages of HTML, and run their scripts in node."""

from __future__ import annotations

import json
import shutil
import subprocess
from html.parser import HTMLParser
from typing import Any

import pytest
from folder import CHECKOUT

PAGES = CHECKOUT / "templates" / "pages"
NODE = shutil.which("node")
needs_node = pytest.mark.skipif(NODE is None, reason="node is not installed to run the script of the page with")


class Elements(HTMLParser):
    """The elements of a page with their attributes, and its texts, without those of scripts and styles."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[str] = []
        self.scripts: list[str] = []
        self._inside = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        self._inside = tag

    def handle_endtag(self, tag: str) -> None:
        self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside == "script":
            self.scripts.append(data)
        elif data.strip() and self._inside != "style":
            self.texts.append(" ".join(data.split()))

    def named(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.found if name == tag]

    @property
    def addresses(self) -> list[str]:
        """What the page loads or links to."""
        return [value for _, a in self.found for name, value in a.items() if name in {"src", "href"} and value]


def in_node(script: str, *files: str, before: str = "") -> Any:
    """Return what a script prints as JSON after the page's own scripts were run; `before` is run first."""
    own = "\n".join((PAGES / file).read_text(encoding="utf-8") for file in files)
    whole = f"{before}\n{own}\n{script}"
    done = subprocess.run(
        [str(NODE), "-"],
        input=whole,
        capture_output=True,
        encoding="utf-8",
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
