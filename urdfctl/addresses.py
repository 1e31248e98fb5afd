"""Where the project's pages are: the one setting of a release that findings, pyproject.toml and the site share."""

from __future__ import annotations

SITE = "https://urdfctl.github.io/urdfctl/"
"""The documentation, with a slash at its end. docs/releasing.md says what else names it."""
REPOSITORY = "https://github.com/urdfctl/urdfctl"
"""The source."""


def page_of_fault(code: str) -> str:
    """Return the address of the page of a fault of urdfctl's own."""
    return f"{SITE}rules/{code}/"


def page_of_message(key: str) -> str:
    """Return the address of the page of a message of ROS or Gazebo, by its name in the catalogue."""
    return f"{SITE}messages/{key}/"
