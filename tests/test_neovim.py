"""Neovim shows what urdfctl finds, through its own client for language servers."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from folder import CHECKOUT, environment

NEOVIM = shutil.which("nvim")
pytestmark = pytest.mark.skipif(NEOVIM is None, reason="Neovim is not installed")
pytest.importorskip("pygls", reason="pygls is not installed")

INIT = """
vim.opt.swapfile = false
vim.api.nvim_create_autocmd("BufReadPost", { callback = function()
  local cmd = { "%s", "-m", "urdfctl", "server" }
  local id = vim.lsp.start_client({ name = "urdfctl", cmd = cmd, root_dir = vim.fn.getcwd() })
  vim.lsp.buf_attach_client(0, id)
end })
"""
LOOK = """
local function codes()
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(0)) do found[#found + 1] = each.lnum + 1 .. ":" .. each.code end
  table.sort(found)
  return table.concat(found, " ")
end
local function wait(done) if not vim.wait(30000, done, 20) then io.write("NOTHING ") end end
wait(function() return codes():find("48:UC201") ~= nil end)
io.write(codes(), "\\n")
local interface = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
vim.api.nvim_buf_set_lines(0, 47, 48, false, { '<joint name="${lr}_wheel_joint">' .. interface .. "</joint>" })
wait(function() return codes():find("UC201") == nil end)
io.write(codes(), "\\n")
vim.cmd("qa!")
"""


def test_a_fault_is_underlined_and_gone_once_it_is_mended(tmp_path: Path) -> None:
    shutil.copytree(CHECKOUT / "samples/broken/mybot", tmp_path / "mybot")
    (tmp_path / "init.lua").write_text(INIT % sys.executable, encoding="utf-8")
    (tmp_path / "look.lua").write_text(LOOK, encoding="utf-8")
    words = ("--headless", "-u", tmp_path / "init.lua", "urdf/macros.xacro", "-c", f"luafile {tmp_path / 'look.lua'}")
    ran = subprocess.run(
        [NEOVIM or "nvim", *words],
        cwd=tmp_path / "mybot",
        env=environment({"PYTHONPATH": str(CHECKOUT)}),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    before, after = ran.stdout.splitlines()
    assert "48:UC201" in before
    assert "UC201" not in after
    assert "NOTHING" not in ran.stdout
