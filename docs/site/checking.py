"""Check a built site: links, anchors, titles, descriptions, headings, and what it would load from elsewhere."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from urdfctl import SITE

_ASKING = ' data-md-component="source"'
_LOADED = {"script": "src", "img": "src", "iframe": "src"}


class _Facts(HTMLParser):
    """What a page links to, loads and says of itself."""

    def __init__(self) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.names: set[str] = set()
        self.headings: list[int] = []
        self.metas: dict[str, str] = {}
        self.language = self.title = ""
        self._in_title = False
        self.without_alt = 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attributes}
        self.names |= {given[key] for key in ("id", "name") if key in given}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag == "link" and given.get("rel") in {"stylesheet", "preconnect", "icon"}:
            self.loaded.append(given["href"])
        if tag in _LOADED and given.get(_LOADED[tag]):
            self.loaded.append(given[_LOADED[tag]])
        if tag == "meta" and "name" in given:
            self.metas[given["name"]] = given.get("content", "")
        if tag in {"h1", "h2", "h3", "h4", "h5", "h6"}:
            self.headings.append(int(tag[1]))
        if tag == "img" and "alt" not in given:
            self.without_alt += 1
        if tag == "html":
            self.language = given.get("lang", "")
        self._in_title = tag == "title" and not self.title

    def handle_data(self, data: str) -> None:
        if self._in_title:
            self.title += data

    def handle_endtag(self, _tag: str) -> None:
        self._in_title = False


@cache
def _facts(page: Path) -> _Facts:
    facts = _Facts()
    facts.feed(page.read_text("utf-8"))
    return facts


def ask_nobody(site: Path) -> None:
    """Take the mark from the link to the repository by which the theme asks GitHub for its number of stars."""
    for path in site.rglob("*.html"):
        text = path.read_text("utf-8")
        if _ASKING in text:
            path.write_text(text.replace(_ASKING, ""), "utf-8")


def problems_of(site: Path) -> Iterator[str]:
    """Yield what is wrong with the pages of a site, a line each."""
    for page in sorted(site.rglob("*.html")):
        name = page.relative_to(site).as_posix()
        if name == "404.html":
            continue
        facts = _facts(page)
        yield from (f"{name}: {problem}" for problem in _own_problems(facts))
        yield from (f"{name}: the link {link} leads nowhere" for link in facts.links if _is_broken(site, name, link))
        yield from (f"{name}: loads {link}" for link in facts.loaded if urlsplit(link).netloc)
        yield from (f"{name}: {link} is not there" for link in facts.loaded if _is_broken(site, name, link))


def _own_problems(facts: _Facts) -> Iterator[str]:
    if not facts.title.strip():
        yield "no title"
    if not facts.metas.get("description"):
        yield "no description"
    if not facts.language:
        yield "no language"
    if facts.headings.count(1) != 1:
        yield f"{facts.headings.count(1)} headings of the first level"
    jumps = [(one, other) for one, other in zip(facts.headings, facts.headings[1:], strict=False) if other > one + 1]
    yield from (f"a heading of level {other} after one of level {one}" for one, other in jumps)
    if facts.without_alt:
        yield f"{facts.without_alt} pictures without text"


def _is_broken(site: Path, page: str, link: str) -> bool:
    """Whether a link of a page leads to nothing in the site; those to other hosts are not looked at."""
    if link.startswith(SITE):
        link = "/" + link[len(SITE) :]
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return False
    base = "" if parts.path.startswith("/") else posixpath.dirname(page)
    path = posixpath.normpath(posixpath.join(base, unquote(parts.path).lstrip("/"))) if parts.path else page
    there = site / path
    if there.is_dir():
        there /= "index.html"
    if not there.is_file():
        return True
    return bool(parts.fragment) and there.suffix == ".html" and unquote(parts.fragment) not in _facts(there).names
