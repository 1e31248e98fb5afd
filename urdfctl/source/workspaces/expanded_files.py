"""Descriptions that CMakeLists.txt expands when the package is built (xacro, cmake/xacro-extras.cmake.in).

`urdf/arm.urdf` is installed, `urdf/arm.urdf.xacro` is in the sources.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.source.workspaces.installed import Installed

_CALL = r"(?si)\bxacro_add_files\s*\(\s*([^()]*)\)"
_ENDING = ".xacro"
_KEYWORDS = frozenset({"INSTALL", "DESTINATION", "TARGET", "REMAP", "DEPENDS", "INORDER"})


def expanded_files(cmake: str) -> Iterator[Installed]:
    """Yield a rule for each description that is expanded without arguments and installed.

    cmake: the text without comments, with its variables substituted.
    """
    for body in re.findall(_CALL, cmake):
        words = [word.strip('"') for word in body.split()]
        if "INSTALL" not in words or "REMAP" in words:
            continue
        target = _after(words, "DESTINATION") or ""
        for word in words[: next(index for index, each in enumerate(words) if each in _KEYWORDS)]:
            if word.endswith(_ENDING):
                name = os.path.basename(word).removesuffix(_ENDING)
                yield Installed(os.path.normpath(os.path.join(target, name)), word)


def _after(words: list[str], keyword: str) -> str | None:
    following = words[words.index(keyword) + 1 :] if keyword in words else []
    return following[0] if following else None
