"""What a build file installs, and where."""

from __future__ import annotations

import os

from urdfctl.record import NamedTuple


class Installed(NamedTuple):
    """`source` (relative to the package) comes to stand at `target` (relative to share/<package>)."""

    target: str
    source: str


def below_share(destination: str, package: str) -> str | None:
    """A destination relative to share/<package>; None where it lies elsewhere."""
    share = f"share/{package}"
    destination = os.path.normpath(destination)
    if destination == share:
        return ""
    return destination[len(share) + 1 :] if destination.startswith(share + "/") else None


def installed(kind: str, target: str, source: str) -> Installed:
    """What `install(KIND source DESTINATION target)` does: of a folder that ends in a slash the content."""
    if kind == "DIRECTORY" and source.endswith("/"):
        return Installed(target, source.rstrip("/"))
    return Installed(os.path.normpath(os.path.join(target, os.path.basename(source))), source)
