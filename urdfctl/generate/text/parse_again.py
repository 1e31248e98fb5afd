"""Parse generated files before they are written, because a user's template can break them."""

from __future__ import annotations

import ast

from urdfctl.errors import UserError
from urdfctl.generate.options import File


def checked(file: File) -> File:
    """Return the file if it can be parsed. UserError if it cannot."""
    why = _fault(file)
    if why is not None:
        raise UserError(f"generated file '{file.name}' cannot be parsed: {why}. Check its template and the names in it")
    return file


def _fault(file: File) -> str | None:
    if file.name.endswith((".yaml", ".yml", ".rviz")):
        return _of_yaml(file.text)
    if file.name.endswith((".xml", ".xacro", ".urdf", ".srdf", ".launch")):
        return _of_xml(file.text)
    if file.name.endswith(".py"):
        try:
            ast.parse(file.text)
        except (SyntaxError, ValueError) as error:
            return str(error)
    return None


def _of_yaml(text: str) -> str | None:
    import yaml

    try:
        yaml.load(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (a safe loader)
    except (yaml.YAMLError, ValueError) as error:
        return " ".join(str(error).split())
    return None


def _of_xml(text: str) -> str | None:
    from xml.parsers import expat

    try:
        expat.ParserCreate().Parse(text.encode("utf-8"), True)  # noqa: FBT003 (expat's own)
    except (expat.ExpatError, UnicodeEncodeError) as error:
        return str(error)
    return None
