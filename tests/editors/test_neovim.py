"""Neovim shows what urdfctl finds, through its own client for language servers."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from folder import CHECKOUT, environment

NEOVIM = shutil.which("nvim")
pytestmark = pytest.mark.skipif(NEOVIM is None, reason="Neovim is not installed")
pytest.importorskip("pygls", reason="pygls is not installed")

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


DRAW = """
vim.wait(30000, function() return #vim.diagnostic.get(0) > 0 end, 20)
vim.cmd("Urdfctl graph")
vim.wait(30000, function() return vim.fn.execute("messages"):find("graph.html") ~= nil end, 20)
io.write(vim.fn.execute("messages"), "\\n")
vim.cmd("qa!")
"""


def documented(word: str) -> str:
    """The part of an init.lua in the documentation that contains a word."""
    blocks = re.findall(r"```lua\n(.*?)```", (CHECKOUT / "docs/editors.md").read_text(encoding="utf-8"), re.DOTALL)
    [block] = [block for block in blocks if word in block]
    return str(block)


def seen(tmp_path: Path, script: str, file: str) -> str:
    """What a script writes in Neovim, set up as documented for older versions."""
    shutil.copytree(CHECKOUT / "samples/broken/mybot", tmp_path / "mybot")
    init = documented("start_client").replace('{ "urdfctl",', f'{{ "{sys.executable}", "-m", "urdfctl",')
    init += documented("nvim_create_user_command")
    (tmp_path / "init.lua").write_text(f"vim.opt.swapfile = false\n{init}", encoding="utf-8")
    (tmp_path / "look.lua").write_text(script, encoding="utf-8")
    words = ("--headless", "-u", tmp_path / "init.lua", file, "-c", f"luafile {tmp_path / 'look.lua'}")
    ran = subprocess.run(
        [NEOVIM or "nvim", *words],
        cwd=tmp_path / "mybot",
        env=environment({"PYTHONPATH": str(CHECKOUT)}),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    return ran.stdout


def test_a_fault_is_underlined_and_gone_once_it_is_mended(tmp_path: Path) -> None:
    before, after = seen(tmp_path, LOOK, "urdf/macros.xacro").splitlines()
    assert "48:UC201" in before
    assert "UC201" not in after
    assert "NOTHING" not in before + after


def test_a_command_draws_the_robot_of_the_open_file(tmp_path: Path) -> None:
    assert "graph.html" in seen(tmp_path, DRAW, "urdf/macros.xacro")
