"""The page of HTML is self-contained, shows failures first, draws pictures and curves, and escapes all texts."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from pages import Elements
from smoke_robots import ARMS, Rover
from smoking import smoked, target_of, whole
from smoking_engines import needs_pybullet

from urdfctl.lint.merging import merge
from urdfctl.lint.selection import Selection
from urdfctl.smoke.page import page
from urdfctl.smoke.picture import picture_of
from urdfctl.smoke.reports import report_of
from urdfctl.smoke.results import Curve, Smoked

CHROMIUM = next(
    (path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None
)


def page_of(*made: Smoked) -> str:
    findings = merge([smoke_test.linted.outcome for smoke_test in made], Selection())
    return page(report_of(made, findings))


def rover(folder: Path, **changes: str) -> Smoked:
    target = target_of(folder, {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml(**changes)})  # type: ignore[arg-type]
    return smoked(target, distro="jazzy")


def test_it_is_self_contained(tmp_path: Path) -> None:
    text = page_of(rover(tmp_path))
    elements = Elements(text)
    assert not {"script", "link", "img", "iframe", "object"} & {tag for tag, _ in elements.found}
    assert not [a for _, a in elements.found if {"src", "href"} & set(a)]
    assert "http" not in text
    assert "url(" not in text
    assert "prefers-color-scheme: dark" in text


def test_failures_come_first(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    good, bad = rover(tmp_path / "a"), rover(tmp_path / "b", left="right", right="left")
    elements = Elements(page_of(good, bad))
    verdicts = [a["class"] for a in elements.named("td") if (a.get("class") or "").startswith("verdict")]
    assert verdicts == ["verdict failed", "verdict skipped", "verdict skipped", "verdict skipped"]
    assert "UC911" in elements.texts


def test_texts_are_escaped(tmp_path: Path) -> None:
    made = rover(tmp_path)
    wicked = "<script>alert(1)</script>"
    evil = made.controllers[0]._replace(name=wicked, reason=wicked)
    text = page_of(made._replace(controllers=(evil,), curves=(Curve(wicked, "j", "position", (1.0,), (), (0.5,)),)))
    assert "<script" not in text
    assert wicked in Elements(text).texts


def test_the_robot_is_drawn(tmp_path: Path) -> None:
    from urdfctl.config.settings import Settings
    from urdfctl.lint.target import lint_target
    from urdfctl.load.loader import Loader
    from urdfctl.smoke.mechanism import mechanism_of

    target = target_of(tmp_path, {"robot.urdf": Rover().urdf()})
    robot = lint_target(Loader(Settings()), target, Selection()).project.robot
    assert robot is not None
    mechanism = mechanism_of(robot)
    assert mechanism is not None
    segments = picture_of(robot, mechanism)
    # two wheels and two balls with rings, the box, and bones to what is not at the root
    assert len(segments) == 2 * (16 * 2 + 4) + 2 * 16 * 3 + 12 + 4
    text = page_of(rover(tmp_path)._replace(picture=segments))
    assert len(Elements(text).named("line")) == len(segments)
    assert "the robot at spawn" in text


@needs_pybullet
def test_the_curves_have_text_for_screen_readers(tmp_path: Path) -> None:
    arm = ARMS["joints that turn level"]
    target = target_of(tmp_path, {"robot.urdf": arm.urdf(), "controllers.yaml": arm.yaml()})
    elements = Elements(page_of(whole(target, "pybullet", distro="jazzy")))
    assert [a["class"] for a in elements.named("polyline")] == ["commanded", "measured"] * 2
    labels = [a["aria-label"] or "" for a in elements.named("svg")]
    assert labels[0].startswith("mover: shoulder, position in rad or m, from ")


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium is installed to look at the page with")
def test_a_browser_shows_it(tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    path.write_text(page_of(rover(tmp_path)), encoding="utf-8")
    picture = tmp_path / "page.png"
    subprocess.run(
        [str(CHROMIUM), "--headless", "--no-sandbox", "--disable-gpu", f"--screenshot={picture}", path.as_uri()],
        check=True,
        capture_output=True,
        timeout=60,
    )
    assert picture.read_bytes().startswith(b"\x89PNG")
