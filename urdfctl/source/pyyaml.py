"""PyYAML, loaded without the dearest of its patterns.

While it is imported, its reader in pure Python compiles a class of all printable characters of Unicode, which takes as
long as all else of the import. Where libyaml reads, nobody asks for that pattern: it is compiled when somebody does.
"""

from __future__ import annotations

import re
import sys
from typing import Any

_OF_UNICODE = "\ud7ff"


class _Later:
    """A pattern that is compiled when something is asked of it."""

    def __init__(self, *arguments: Any) -> None:
        self._arguments = arguments

    def __getattr__(self, name: str) -> Any:
        return getattr(re.compile(*self._arguments), name)


def load() -> Any:
    """The module, as `import yaml` would give it."""
    known = sys.modules.get("yaml")
    if known is not None:
        return known
    compiled = re.compile

    def compile_later(pattern: Any, *flags: Any) -> Any:
        of_unicode = isinstance(pattern, str) and _OF_UNICODE in pattern
        return _Later(pattern, *flags) if of_unicode else compiled(pattern, *flags)

    re.compile = compile_later  # type: ignore[assignment]
    try:
        import yaml
    finally:
        re.compile = compiled
    return yaml


yaml = load()
