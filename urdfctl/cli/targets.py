"""The files that the paths of a command line mean."""

from __future__ import annotations

import os
from collections.abc import Sequence

from urdfctl.config.file import Config
from urdfctl.discover.robots import DiscoveredFiles
from urdfctl.lint import planning

_COMMON = (".urdf", ".xacro", ".yaml")
"""Files that exist and end so need no closer look."""


def discovered(paths: Sequence[str], config: Config) -> DiscoveredFiles:
    """Return the files that paths mean, as `planning.discovered` does. UserError says what is wrong with a path."""
    for path in paths:
        if not (os.path.isdir(path) or (path.endswith(_COMMON) and os.path.exists(path))):
            from urdfctl.cli.slips import check_path

            check_path(path)
    return planning.discovered(paths, config)
