"""What a value is to the program that reads it."""

from __future__ import annotations

from enum import Enum


class Kind(Enum):
    """The kinds of values that readers of YAML tell apart."""

    NULL = "null"
    BOOL = "bool"
    INT = "int"
    FLOAT = "double"
    STRING = "string"
    LIST = "list"
    MAP = "map"
    OTHER = "other"
    """What no parameter can hold: a date, or a value with a tag that its reader does not know."""
    UNKNOWN = "unknown"
    """Not a literal: a text in which something will be substituted before it is read."""
