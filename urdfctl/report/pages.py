"""Pages of HTML from templates: one file each, without network, readable in a light and a dark style."""

from __future__ import annotations

import os

from urdfctl import __version__
from urdfctl.report.common import as_text
from urdfctl.report.template_folder import own_folder


def page(name: str, **values: object) -> str:
    """Return the page that `templates/pages/NAME.html.j2` makes of some values. All texts in it are escaped."""
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(os.path.join(own_folder(), "pages")),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=True,
    )
    text: str = environment.get_template(f"{name}.html.j2").render(version=__version__, **values)
    return as_text(text) + "\n"
