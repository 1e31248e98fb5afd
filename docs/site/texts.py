"""Small parts of Markdown pages."""

from __future__ import annotations

import json
import re
from html import escape

Pages = dict[str, str]
"""The texts of pages by their path in the site's folder."""
_DESCRIPTION = 160


def front_matter(title: str, description: str) -> str:
    """Return the head of a page: its title, and what search engines show below it."""
    short = description if len(description) <= _DESCRIPTION else f"{description[: _DESCRIPTION - 1].rstrip()}…"
    # the theme puts them into HTML as they are
    said = {"title": escape(title, quote=False), "description": escape(short.replace('"', "'"), quote=False)}
    lines = (f"{key}: {json.dumps(value, ensure_ascii=False)}" for key, value in said.items())
    return "\n".join(["---", *lines, "---", ""])


def one_line(text: str) -> str:
    """Return a text without line breaks, marks of code and repeated blanks."""
    return " ".join(text.replace("`", "").split())


def how_to_try(page: str) -> str:
    """Return the last lines of a page that people reach from a search engine: where to try urdfctl and to install it.

    page: the path of the page in the site.
    """
    up = "../" * page.count("/")
    return (
        "## Try it\n\n"
        f"In the browser, without installing: the [playground]({up}playground/index.md) lints your files, and nothing "
        f"leaves the page. On your machine: [install urdfctl]({up}index.md#install), which needs no ROS.\n"
    )


def quoted(text: str) -> str:
    """Return a text as code of one line, whatever backticks it has."""
    plain = " ".join(text.split())
    longest = max((len(run) for run in re.findall("`+", plain)), default=0)
    fence = "`" * (longest + 1)
    return f"{fence} {plain} {fence}" if longest else f"{fence}{plain}{fence}"
