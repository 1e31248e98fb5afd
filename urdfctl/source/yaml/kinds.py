"""The kinds of values in YAML files."""

from __future__ import annotations

from enum import Enum


class ValueKind(Enum):
    """The kind of a value, as the program that reads the file types it."""

    NULL = "null"
    BOOL = "bool"
    INT = "int"
    FLOAT = "double"
    STRING = "string"
    LIST = "list"
    MAP = "map"
    OTHER = "other"
    """A value that no parameter can have: a date, or a value with a tag that its reader does not know."""
    UNKNOWN = "unknown"
    """Not a literal: contains a substitution that is performed before the value is read."""
