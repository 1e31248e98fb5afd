"""The functions of `signal`, without its enumerations.

Saves: 0.7 ms. `signal` makes an enumeration of all signals of the system when it is imported.
"""

from __future__ import annotations

from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    import signal as signal  # noqa: PLC0414 (so that it is exported)
else:
    try:
        import _signal as signal
    except ImportError:  # pragma: no cover (another Python than CPython and PyPy)
        pass
