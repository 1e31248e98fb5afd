"""`urdfctl lint --node NAME=FILE`: definitions of the parameters of nodes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from urdfctl.catalog.definitions import definition_of
from urdfctl.errors import UserError
from urdfctl.source.disk.files import named_bytes
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.tree import read_yaml

Nodes = tuple[tuple[str, Any], ...]


def node_definitions(given: Iterable[str]) -> Nodes:
    """Return the nodes with the definitions of their parameters. UserError if a file is not a definition."""
    return tuple(_node(text) for text in given)


def _node(text: str) -> tuple[str, Any]:
    name, mark, path = text.partition("=")
    if not (name and mark and path):
        raise UserError(f"--node must be NAME=FILE, not '{text}'")
    definition = definition_of(read_yaml(SourceText(path, named_bytes(path))))
    if definition is None:
        raise UserError(f"'{path}' does not define parameters in the form of generate_parameter_library")
    return name, dict(definition.parameters)
