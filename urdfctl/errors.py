"""The error for an invalid command or configuration."""

from __future__ import annotations


class UserError(Exception):
    """The command or the configuration is invalid. Printed as one line; the exit status is 2."""
