"""Names from `typing` for annotations, without importing it.

Saves: importing `typing` takes a fortieth of a run, and annotations are never evaluated at run time.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any as Any  # noqa: PLC0414 (so that it is exported)
    from typing import Protocol as Protocol  # noqa: PLC0414
else:
    Any = Protocol = object
