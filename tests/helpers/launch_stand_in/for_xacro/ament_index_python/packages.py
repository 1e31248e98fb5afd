"""The packages of a workspace, for xacro's $(find)."""

from __future__ import annotations

import json
import os


class PackageNotFoundError(KeyError):
    """There is no such package."""


def get_package_share_directory(name):
    """The folder of a package of the workspace."""
    packages = json.loads(os.environ["STAND_IN_PACKAGES"])
    if name not in packages:
        raise PackageNotFoundError(f"package '{name}' not found")
    return packages[name]
