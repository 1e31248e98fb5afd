"""The pictures of the documentation show what the commands write today."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

from folder import CHECKOUT

PICTURES = CHECKOUT / "docs" / "pictures"
MAKE = runpy.run_path(str(PICTURES / "make.py"))


def words_of(svg: str) -> list[str]:
    return re.findall(r"<text[^>]*>([^<]*)</text>", svg)


def test_the_terminal_is_current_and_loads_nothing() -> None:
    kept = (PICTURES / "lint.svg").read_text(encoding="utf-8")
    assert words_of(MAKE["terminal"](*MAKE["TERMINAL"])) == words_of(kept)
    assert "url(http" not in kept
    assert "UC201" in kept


def test_the_graph_is_current() -> None:
    assert MAKE["run"](*MAKE["GRAPH"]) == (PICTURES / "graph.svg").read_text(encoding="utf-8")


def test_every_picture_is_on_a_page() -> None:
    documents = (*CHECKOUT.glob("*.md"), *CHECKOUT.glob("docs/*.md"), *CHECKOUT.glob("docs/commands/*.md"))
    pages = "".join(page.read_text(encoding="utf-8") for page in documents)
    pictures = [path.name for path in Path(PICTURES).iterdir() if path.suffix in {".svg", ".png"}]
    assert len(pictures) == 4
    assert [name for name in pictures if f"pictures/{name})" not in pages] == []
