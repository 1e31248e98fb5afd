"""Emacs shows what urdfctl finds, through Eglot."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from folder import CHECKOUT, environment

EMACS = shutil.which("emacs")
pytestmark = pytest.mark.skipif(EMACS is None, reason="Emacs is not installed")
pytest.importorskip("pygls", reason="pygls is not installed")

LOOK = """
(unless (require 'eglot nil t) (message "NO EGLOT") (kill-emacs))
(setq eglot-sync-connect 30)
(find-file "urdf/macros.xacro")
(run-hooks 'post-command-hook)
(with-timeout (30) (while (not (flymake-diagnostics)) (accept-process-output nil 0.05)))
(dolist (each (flymake-diagnostics))
  (message "%d: %s" (line-number-at-pos (flymake-diagnostic-beg each)) (flymake-diagnostic-text each)))
"""


def test_a_fault_is_shown_in_its_line(tmp_path: Path) -> None:
    shutil.copytree(CHECKOUT / "samples/broken/mybot", tmp_path / "mybot")
    [init] = re.findall(r"```elisp\n(.*?)```", (CHECKOUT / "docs/editors.md").read_text(encoding="utf-8"), re.DOTALL)
    served = init.replace('("urdfctl" "server")', f'("{sys.executable}" "-m" "urdfctl" "server")')
    (tmp_path / "look.el").write_text(f"(package-initialize)\n{served}{LOOK}", encoding="utf-8")
    ran = subprocess.run(
        [EMACS or "emacs", "--batch", "-l", tmp_path / "look.el"],
        cwd=tmp_path / "mybot",
        env=environment({"PYTHONPATH": str(CHECKOUT), "HOME": str(tmp_path)}),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    if "NO EGLOT" in ran.stderr:
        pytest.skip("Emacs is older than 29 and has no Eglot")
    assert re.search(r"^48: .*UC201.*wheel_joint", ran.stderr, re.MULTILINE)
