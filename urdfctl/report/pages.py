"""Pages of HTML from templates: one file each, without network, readable in a light and a dark style.

A browser runs only the scripts of urdfctl in them, and loads nothing: their Content-Security-Policy names the scripts
and styles by their hashes. Whatever else a robot's name could bring in, it would not run.
"""

from __future__ import annotations

import hashlib
import os
from base64 import b64encode
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfctl import __version__
from urdfctl.output.printing import visible
from urdfctl.report.common import as_text
from urdfctl.report.template_folder import own_folder

if TYPE_CHECKING:
    from markupsafe import Markup


def page(name: str, *, styles: Mapping[str, str] | None = None, **values: object) -> str:
    """Return the page that `templates/pages/NAME.html.j2` makes of some values. All texts in it are escaped, and their
    control characters are visible.

    styles: style sheets by name, besides those beside the template.
    """
    import jinja2
    from markupsafe import Markup

    folder = os.path.join(own_folder(), "pages")
    sheets = {**_texts(folder, ".css"), **(styles or {})}
    scripts = _texts(folder, ".js")

    def style(name: str) -> Markup:
        return Markup(f"<style>{sheets[name]}</style>")  # noqa: S704 (urdfctl's own)

    def script(name: str) -> Markup:
        return Markup(f"<script>{scripts[name]}</script>")  # noqa: S704 (urdfctl's own)

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=True,
        finalize=_visible,
    )
    environment.globals.update(style=style, script=script, policy=_policy(scripts.values(), sheets.values()))
    text: str = environment.get_template(f"{name}.html.j2").render(version=__version__, **values)
    return as_text(text) + "\n"


def allowed_scripts() -> str:
    """Return the hashes of the scripts of all pages, as a Content-Security-Policy names them."""
    return _hashes(_texts(os.path.join(own_folder(), "pages"), ".js").values())


def allowed_styles(*others: str) -> str:
    """Return the hashes of the styles of all pages and of some others, as a Content-Security-Policy names them."""
    return _hashes([*_texts(os.path.join(own_folder(), "pages"), ".css").values(), *others])


def _texts(folder: str, ending: str) -> dict[str, str]:
    """The scripts or styles beside the templates, by name."""
    found = {}
    for name in sorted(os.listdir(folder)):
        if name.endswith(ending):
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                found[name] = file.read()
    return found


def _policy(scripts: Iterable[str], styles: Iterable[str]) -> str:
    """What a browser may run and load in a page: these scripts and styles, and nothing else."""
    allowed = f"script-src {_hashes(scripts)}; style-src {_hashes(styles)}"
    return f"default-src 'none'; {allowed}; base-uri 'none'; form-action 'none'"


def _hashes(texts: Iterable[str]) -> str:
    digests = (hashlib.sha256(text.encode()).digest() for text in texts)
    return " ".join(f"'sha256-{b64encode(digest).decode()}'" for digest in digests)


def _visible(value: object) -> object:
    """A value as a page shows it: no text in it can turn the direction of others."""
    return visible(value) if isinstance(value, str) and not hasattr(value, "__html__") else value
