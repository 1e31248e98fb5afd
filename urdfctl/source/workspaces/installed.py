"""Install rules of a build file."""

from __future__ import annotations

import os

from urdfctl.startup.records import NamedTuple


class Installed(NamedTuple):
    """One install rule.

    target: destination, relative to share/<package>.
    source: file or folder that is installed there, relative to the package.
    """

    target: str
    source: str


def below_share(destination: str, package: str) -> str | None:
    """Return a destination relative to share/<package>; None if it is not below that folder."""
    share = f"share/{package}"
    destination = os.path.normpath(destination)
    if destination == share:
        return ""
    return destination[len(share) + 1 :] if destination.startswith(share + "/") else None


def installed(kind: str, target: str, source: str) -> Installed:
    """Return the rule for `install(KIND source DESTINATION target)`.

    A folder with a trailing slash installs its content, without the folder itself.
    """
    if kind == "DIRECTORY" and source.endswith("/"):
        return Installed(target, source.rstrip("/"))
    return Installed(os.path.normpath(os.path.join(target, os.path.basename(source))), source)
