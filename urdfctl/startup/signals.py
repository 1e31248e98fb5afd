"""The functions of `signal`, without its enumerations.

Saves: 0.7 ms. `signal` makes an enumeration of all signals of the system when it is imported.
"""

from __future__ import annotations

from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    import signal as signal  # noqa: PLC0414 (so that it is exported)
else:
    import _signal as signal  # noqa: F401 (so that it is exported)
