"""What the tests share."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from folder import UNWANTED, Folder


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Folder:
    monkeypatch.chdir(tmp_path)
    for name in [name for name in os.environ if name.startswith("ROS_") or name in UNWANTED]:
        monkeypatch.delenv(name)
    return Folder(tmp_path)
