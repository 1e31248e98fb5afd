"""The one kind of error that is the user's to mend on the command line or in the configuration."""

from __future__ import annotations


class UserError(Exception):
    """The command or the configuration is wrong: told in one line, exit status 2."""
