"""What the picture in 3-D shows in a browser: status as outline and badge, ground, axes, and joints that are found."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from chromium import browser, needs_browser
from folder import CHECKOUT
from generating import command

from urdfctl.view.meshes import installed

needs_view = pytest.mark.skipif(not installed(), reason="the extra 'view' is not installed")
STYLE = CHECKOUT / "templates/pages"
PIXELS = """((wanted) => {
  const view = document.querySelector(".robot-view").robot, gl = view.gl, { width: w, height: h } = view.canvas;
  const all = new Uint8Array(4 * w * h); gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, all);
  let count = 0;
  for (let n = 0; n < all.length; n += 4) count += wanted.every((part, m) => Math.abs(part - all[n + m]) < 12) ? 1 : 0;
  return count;
})"""
SEARCH = """(() => {
  const search = document.querySelector(".robot-search");
  search.value = "ELB"; search.dispatchEvent(new Event("input"));
})()"""
ERROR = [0xD0, 0x2B, 0x30]


def colours(name: str) -> set[str]:
    """The colours of the rules that set variables with a prefix, of both schemes."""
    text = "".join((STYLE / file).read_text("utf-8") for file in ("robot.css", "style.css"))
    return {found.lower() for found in re.findall(rf"--{name}[a-z-]*: (#[0-9a-fA-F]{{6}})", text)}


def test_no_way_of_control_has_the_colour_of_a_status() -> None:
    kinds = colours("by-")
    assert len(kinds) >= 10
    for status in ("good", "bad", "warned", "error"):
        assert kinds & colours(status) == set(), status


@needs_browser
def test_an_error_is_an_outline_and_a_badge_that_leads_to_its_findings(tmp_path: Path) -> None:
    page_file = tmp_path / "robot.html"
    assert command("view", str(CHECKOUT / "samples/broken/my_robot"), "-o", str(page_file)).returncode == 0
    with browser() as started:
        page = started.page()
        page.open(page_file)
        outline = page.run(f"{PIXELS}({ERROR})")
        assert 100 < outline < 5000, "an outline, and no surface"
        assert page.run("document.querySelector('.robot-canvas .badge').textContent") == "1"
        page.run("document.querySelector('.robot-canvas .badge').click()")
        assert page.run("document.querySelector('.robot-joints li.chosen details').open")
        assert page.run(f"{PIXELS}({ERROR})") == 0, "what is chosen has its own outline"
        assert page.refused == []


@needs_browser
def test_joints_are_found_by_name_and_their_frames_are_drawn_on_demand(tmp_path: Path) -> None:
    page_file = tmp_path / "robot.html"
    assert command("view", str(CHECKOUT / "samples/picker"), "-o", str(page_file)).returncode == 0
    red = f"{PIXELS}([0xE5, 0x48, 0x4D])"
    with browser() as started:
        page = started.page()
        page.open(page_file)
        assert "a square is" in page.run("document.querySelector('.ground-step').textContent")
        before = page.run(red)
        page.run("document.querySelector('.joint-frames').click()")
        assert page.run(red) > before
        names = "[...document.querySelectorAll('.robot-joints li:not([hidden])')].map(one => one.dataset.joint)"
        joints = page.run(names)
        assert joints[joints.index("turn") :][:4] == ["turn", "shoulder", "elbow", "wrist"], "as the tree branches"
        page.run(SEARCH)
        assert page.run(names) == ["elbow"]


CUT = """[...document.querySelectorAll(".wired-drawing")].map(one => one.scrollWidth - one.clientWidth)
  .concat(document.documentElement.scrollWidth - innerWidth)"""
"""By how many pixels the graphs and the page itself are wider than what is seen of them."""


@needs_browser
def test_the_whole_graph_is_seen_on_a_desk(tmp_path: Path) -> None:
    page_file = tmp_path / "run.html"
    command("lint", str(CHECKOUT / "samples/picker"), "--report", str(page_file))
    with browser() as started:
        page = started.page()
        size = {"width": 1400, "height": 900, "deviceScaleFactor": 1, "mobile": False}
        started.ask("Emulation.setDeviceMetricsOverride", size, page.session)
        page.open(page_file)
        assert max(page.run(CUT)) <= 0


@needs_browser
def test_on_a_telephone_the_graph_can_be_read_where_something_is_wrong_and_be_seen_as_a_whole(tmp_path: Path) -> None:
    page_file = tmp_path / "run.html"
    command("lint", str(CHECKOUT / "samples/broken/mybot"), "--report", str(page_file))
    seen = """(() => {
      const area = document.querySelector(".wired-drawing").getBoundingClientRect();
      const wrong = document.querySelector(".node.broken").getBoundingClientRect();
      return wrong.left >= area.left && wrong.right <= area.right
        && wrong.top >= area.top && wrong.bottom <= area.bottom;
    })()"""
    with browser() as started:
        page = started.page()
        size = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
        started.ask("Emulation.setDeviceMetricsOverride", size, page.session)
        page.open(page_file)
        assert page.run("document.documentElement.scrollWidth - innerWidth") <= 0
        assert page.run("document.querySelector('.node text').getBoundingClientRect().height") > 9
        assert page.run(seen)
        page.run("document.querySelector('[data-zoom=fit]').click()")
        assert max(page.run(CUT)) <= 0


@needs_view
def test_planning_groups_and_their_poses_can_be_chosen(tmp_path: Path) -> None:
    page_file = tmp_path / "robot.html"
    assert command("view", str(CHECKOUT / "samples/picker"), "-o", str(page_file)).returncode == 0
    text = page_file.read_text(encoding="utf-8")
    scene = json.loads(re.search(r'<script type="application/json">(.*?)</script>', text, re.DOTALL)[1])  # type: ignore[index]
    assert [group["name"] for group in scene["groups"]] == ["arm", "gripper"]
    assert [pose["name"] for pose in scene["poses"]] == ["arm: home", "gripper: open", "gripper: close"]
    moving = {joint["name"] for joint in scene["joints"] if joint["moves"]}
    assert all(moving >= set(group["joints"]) for group in scene["groups"])
    assert all(moving >= pose["positions"].keys() for pose in scene["poses"])
    assert text.count("<option>arm: home</option>") == 1
    shown = {link: dict(others) for link, others in scene["untested"].items()}
    assert shown["base_link"]["turret"] == shown["turret"]["base_link"] == "Adjacent"
    pairs = re.findall("<disable_collisions ", (CHECKOUT / "samples/picker/config/picker.srdf").read_text("utf-8"))
    assert sum(map(len, shown.values())) == 2 * len(pairs) > 0


@needs_view
def test_a_robot_without_planning_groups_offers_none(tmp_path: Path) -> None:
    page_file = tmp_path / "robot.html"
    assert command("view", str(CHECKOUT / "samples/radu"), "-o", str(page_file)).returncode == 0
    text = page_file.read_text(encoding="utf-8")
    assert not [name for name in ("robot-groups", "robot-untested") if f'<select class="{name}">' in text]


@needs_browser
def test_a_chosen_group_is_outlined_and_a_pose_moves_its_joints(tmp_path: Path) -> None:
    page_file = tmp_path / "robot.html"
    assert command("view", str(CHECKOUT / "samples/picker"), "-o", str(page_file)).returncode == 0
    choose = """((of, value) => {
      const select = document.querySelector(of);
      select.value = value; select.dispatchEvent(new Event("change"));
    })"""
    with browser() as started:
        page = started.page()
        page.open(page_file)
        page.run(f"{choose}('.robot-groups', 'arm')")
        assert page.run("document.querySelectorAll('.robot-joints li.in-group').length") > 0
        page.run(f"{choose}('.robot-groups', '')")
        assert page.run("document.querySelectorAll('.robot-joints li.in-group').length") == 0
        page.run(f"{choose}('.robot-untested', 'base_link')")
        assert "turret (Adjacent)" in page.run("document.querySelector('.untested-links').textContent")
        page.run(f"{choose}('.robot-untested', '')")
        assert page.run("document.querySelector('.untested-links').textContent") == ""
        page.run(f"{choose}('.robot-poses', 'gripper: open')")
        assert page.refused == []
