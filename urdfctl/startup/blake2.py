"""The hash function BLAKE2b, without importing OpenSSL, which `hashlib` does first.

Saves: 4 ms of start-up.
"""

from __future__ import annotations

try:
    from _blake2 import blake2b as blake2b  # noqa: PLC0414 (so that it is exported)
except ImportError:  # pragma: no cover (another Python than CPython)
    from hashlib import blake2b as blake2b  # noqa: PLC0414
