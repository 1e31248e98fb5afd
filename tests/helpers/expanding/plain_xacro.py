"""Run the original xacro package, with urdfctl's package lookup: the reference for `urdfctl expand`."""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Mapping
from typing import Any

import xacro
import xacro.substitution_args

from urdfctl.source.workspaces.packages import Packages


def expand(path: str, packages: Packages, arguments: Mapping[str, str]) -> str:
    """Return the output of `xacro FILE`; `error: ...` if it fails."""

    def located_open(name: str, *rest: Any) -> Any:
        return open(packages.source_of(name), *rest)

    xacro.substitution_args._eval_find = packages.find
    xacro.substitution_args._eval_dict["find"] = packages.find
    xacro.__dict__["open"] = located_open
    xacro.all_includes.clear()
    try:
        with contextlib.redirect_stderr(io.StringIO()):
            document = xacro.process_file(path, mappings=dict(arguments))
        return str(document.toprettyxml(indent="  "))
    except Exception as error:  # noqa: BLE001 (xacro raises errors of any type)
        return f"error: {re.sub('0x[0-9a-f]+', '0x', str(error))}"
    finally:
        del xacro.__dict__["open"]
