"""The templates that files are made of: those of urdfctl, and the user's in their place."""

from __future__ import annotations

import os

from urdfctl.errors import UserError
from urdfctl.generate.scalars import one_line, python_text, xacro_text, xml_comment, xml_text, yaml_text
from urdfctl.hints import TYPE_CHECKING

if TYPE_CHECKING:
    import jinja2

_FAULTS = (ArithmeticError, AttributeError, LookupError, MemoryError, OSError, RecursionError, TypeError, ValueError)
"""What reading a template of the user's, and what stands in it, may raise beside jinja's own."""
_PACKAGE = os.path.dirname(os.path.dirname(__file__))


def own_folder() -> str:
    """Where urdfctl's templates are: in the package, or beside it in a checkout."""
    inside = os.path.join(_PACKAGE, "templates")
    return inside if os.path.isdir(inside) else os.path.join(os.path.dirname(_PACKAGE), "templates")


def template_names(folder: str | None = None) -> list[str]:
    """The names of the templates, in order."""
    return sorted(_environment(folder).list_templates(extensions=["j2"]))


class Templates:
    """Renders; those in a folder of the user's come before urdfctl's own of the same name."""

    def __init__(self, folder: str | None = None) -> None:
        if folder is not None and not os.path.isdir(folder):
            raise UserError(f"no such folder: '{folder}'")
        self._folder = folder
        self._environment = _environment(folder)

    def render(self, name: str, /, **values: object) -> str:
        """A template's text with some values, ending in one line end. UserError where the template is wrong."""
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
    from jinja2.sandbox import ImmutableSandboxedEnvironment

    environment = ImmutableSandboxedEnvironment(
        loader=jinja2.FileSystemLoader([path for path in (folder, own_folder()) if path]),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters.update(
        yaml=yaml_text, xml=xml_text, xacro=xacro_text, python=python_text, comment=one_line, xml_comment=xml_comment
    )
    return environment
