"""What annotations need of typing, without its import, which takes a fortieth of a run: nobody reads them then."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any as Any  # noqa: PLC0414 (so that it is exported)
else:
    Any = object
