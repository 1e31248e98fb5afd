"""Every command on every hostile project: what it reads."""
# ruff: noqa: F401

from __future__ import annotations

from test_trust_reading import (
    test_nothing_outside_of_the_workspace_is_read,
    test_what_is_said_does_not_depend_on_what_is_outside,
)
