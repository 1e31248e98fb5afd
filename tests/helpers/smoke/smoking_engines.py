"""The physics engines that are installed, for tests."""

from __future__ import annotations

from importlib.util import find_spec

import pytest

INSTALLED = [name for name in ("pybullet", "mujoco") if find_spec(name) is not None]
EACH_ENGINE = [
    pytest.param(name, marks=pytest.mark.skipif(name not in INSTALLED, reason=f"{name} is not installed"))
    for name in ("pybullet", "mujoco")
]
needs_pybullet = pytest.mark.skipif("pybullet" not in INSTALLED, reason="pybullet is not installed")
needs_an_engine = pytest.mark.skipif(not INSTALLED, reason="no physics engine is installed")
