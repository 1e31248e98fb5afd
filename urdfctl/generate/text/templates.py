"""The templates of the generated files: urdfctl's own, or the user's in their place."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from urdfctl.errors import UserError
from urdfctl.generate.text.scalars import json_text, one_line, python_text, xacro_text, xml_comment, xml_text, yaml_text
from urdfctl.report.template_folder import own_folder
from urdfctl.source.disk.files import MAX_BYTES, first_bytes

if TYPE_CHECKING:
    import jinja2

_FAULTS = (ArithmeticError, AttributeError, LookupError, MemoryError, OSError, RecursionError, TypeError, ValueError)
"""Exceptions, besides jinja's own, that loading and rendering a user's template can raise."""


def template_names(folder: str | None = None) -> list[str]:
    """Return the names of the templates of generated files, sorted."""
    names = _environment(folder).list_templates(extensions=["j2"])
    return sorted(name for name in names if not name.startswith("pages/"))


class Templates:
    """Renders templates. Those in the user's folder replace urdfctl's own of the same name."""

    def __init__(self, folder: str | None = None) -> None:
        if folder is not None and not os.path.isdir(folder):
            raise UserError(f"template folder does not exist: '{folder}'")
        self._folder = folder
        self._environment = _environment(folder)

    def render(self, name: str, /, **values: object) -> str:
        """Return a rendered template, ending in one line end. UserError if the template is invalid."""
        import jinja2

        try:
            text: str = self._environment.get_template(f"{name}.j2").render(values)
        except jinja2.TemplateError as error:
            raise UserError(f"template '{name}.j2': {error}") from None
        except _FAULTS as error:
            if self._folder is None:
                raise
            raise UserError(f"template '{name}.j2': {str(error) or type(error).__name__}") from None
        lines = [line.rstrip() for line in text.rstrip().splitlines()]
        return "\n".join(lines) + "\n"


def _environment(folder: str | None) -> jinja2.Environment:
    import jinja2
    from jinja2.loaders import split_template_path
    from jinja2.sandbox import ImmutableSandboxedEnvironment

    class Users(jinja2.FileSystemLoader):
        """Reads templates as other files of the user: regular ones, within what the run may read."""

        def get_source(self, environment: jinja2.Environment, template: str) -> Any:  # noqa: ARG002 (jinja's signature)
            path = os.path.join(folder or "", *split_template_path(template))
            if not os.path.lexists(path):
                raise jinja2.TemplateNotFound(template)
            return first_bytes(path, MAX_BYTES).decode("utf-8"), path, None

    own = jinja2.FileSystemLoader(own_folder())
    environment = ImmutableSandboxedEnvironment(
        loader=own if folder is None else jinja2.ChoiceLoader([Users(folder), own]),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters.update(yaml=yaml_text, yaml_string=json_text, xml=xml_text, xacro=xacro_text)
    environment.filters.update(python=python_text, comment=one_line, xml_comment=xml_comment)
    return environment
