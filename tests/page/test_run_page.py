"""The page of a run is self-contained, shows failures first, draws robots and curves, and escapes all texts."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from folder import Folder
from pages import Elements, in_node, needs_node
from smoke_robots import ARMS, Rover
from smoking import smoked, target_of, whole
from smoking_engines import needs_pybullet

from urdfctl.config.settings import Settings
from urdfctl.lint.findings.merging import merge
from urdfctl.lint.selection import Selection
from urdfctl.page.chart import chart
from urdfctl.page.failing import failing_pose
from urdfctl.page.run import RunFacts, smoke_page
from urdfctl.smoke.reports import report_of
from urdfctl.smoke.results import Curve, RobotResult, Verdict
from urdfctl.view.job import Portrait, portraits
from urdfctl.view.meshes import installed

CHROMIUM = next(
    (path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None
)
FACTS = RunFacts("urdfctl smoke . --report 'my page.html'", "2026-01-02T03:04:05+00:00", 1.25)
needs_view = pytest.mark.skipif(not installed(), reason="the extra 'view' is not installed")


def page_of(*made: RobotResult, portrait: Portrait | None = None) -> str:
    findings = merge([smoke_test.linted.outcome for smoke_test in made], Selection())
    return smoke_page(report_of(made, findings), [(robot, portrait or Portrait()) for robot in made], FACTS)


def rover(folder: Path, **changes: str) -> RobotResult:
    target = target_of(folder, {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml(**changes)})  # type: ignore[arg-type]
    return smoked(target, distro="jazzy")


def portrait_of(folder: Path, *, in_3d: bool) -> Portrait:
    target = target_of(folder, {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml()})
    [portrait] = portraits([target], Settings(distro="jazzy"), in_3d=in_3d)
    return portrait


@needs_view
def test_it_is_self_contained(tmp_path: Path) -> None:
    portrait = portrait_of(tmp_path, in_3d=True)
    text = page_of(rover(tmp_path), portrait=portrait)
    elements = Elements(text)
    assert not {"link", "img", "iframe", "object"} & {tag for tag, _ in elements.found}
    assert not [address for address in elements.addresses if not address.startswith("#")]
    assert "http" not in text.replace('xmlns="http://www.w3.org/2000/svg"', "").replace("<meta http-equiv=", "")
    assert "url(" not in text
    assert "prefers-color-scheme: dark" in text


def test_it_says_how_it_was_made(tmp_path: Path) -> None:
    texts = Elements(page_of(rover(tmp_path))).texts
    assert {FACTS.command, FACTS.date} <= set(texts)
    assert [text for text in texts if text.startswith("1.2 s, urdfctl ")]


def test_failures_come_first(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    good, bad = rover(tmp_path / "a"), rover(tmp_path / "b", left="right", right="left")
    elements = Elements(page_of(good, bad))
    verdicts = [a["class"] for a in elements.named("td") if (a.get("class") or "").startswith("verdict")]
    assert verdicts == ["verdict failed", "verdict skipped", "verdict skipped", "verdict skipped"]
    assert "error UC911" in elements.texts


def test_every_heading_of_a_table_has_a_scope_and_every_section_a_heading(tmp_path: Path) -> None:
    elements = Elements(page_of(rover(tmp_path)))
    assert {a.get("scope") for a in elements.named("th")} == {"col", "row"}
    named = {a.get("aria-labelledby") for a in elements.named("section")}
    assert named == {a["id"] for a in elements.named("h2")}
    assert {address.removeprefix("#") for address in elements.addresses} == named


def test_texts_are_escaped(tmp_path: Path) -> None:
    made = rover(tmp_path)
    wicked = "<script>alert(1)</script>"
    evil = made.controllers[0]._replace(name=wicked, reason=wicked)
    curves = (Curve(wicked, wicked, "position", (1.0,), (), (0.5,)),)
    text = page_of(made._replace(controllers=(evil,), curves=curves))
    assert "<script>alert" not in text
    assert wicked in Elements(text).texts


def test_findings_and_verdicts_come_before_the_wiring(tmp_path: Path) -> None:
    portrait = portrait_of(tmp_path, in_3d=False)
    assert portrait.graph is not None
    text = page_of(rover(tmp_path), portrait=portrait)
    verdicts, wiring = text.index("<h3>Controllers"), text.index("What is started together")
    assert text.index('<h2 id="findings">') < verdicts < wiring
    nodes = [a for a in Elements(text).named("g") if a.get("data-node")]
    assert len(nodes) == len(portrait.graph.nodes)


def test_without_3d_the_robot_is_a_drawing(tmp_path: Path) -> None:
    portrait = portrait_of(tmp_path, in_3d=False)
    # two wheels and two balls with rings, the box, and bones to what is not at the root
    assert len(portrait.outline) == 2 * (16 * 2 + 4) + 2 * 16 * 3 + 12 + 4
    text = page_of(rover(tmp_path), portrait=portrait)
    bones = [a for a in Elements(text).named("line") if a.get("class") == "bone"]
    assert len(bones) == len(portrait.outline)
    assert "pip install 'urdfctl[view]'" in text


@needs_view
def test_in_3d_each_curve_can_be_replayed(tmp_path: Path) -> None:
    portrait = portrait_of(tmp_path, in_3d=True)
    assert portrait.scene is not None
    joint = next(joint["name"] for joint in portrait.scene["joints"] if joint["moves"])
    curve = Curve("c", joint, "velocity", (0.5, 1.0), (2.0, 2.0), (1.0, 2.0), unit="rad/s")
    base = Curve("c", "base", "ahead", (0.5, 1.0), (0.1, 0.2), (0.1, 0.2), unit="m")
    elements = Elements(page_of(rover(tmp_path)._replace(curves=(curve, base)), portrait=portrait))
    [replay] = [json.loads(a["data-replay"] or "") for a in elements.named("button") if "data-replay" in a]
    assert replay == {"joint": joint, "seconds": [0.5, 1.0], "positions": [0.5, 1.5]}


@needs_view
def test_in_3d_the_robot_takes_the_pose_at_which_a_controller_failed(tmp_path: Path) -> None:
    portrait = portrait_of(tmp_path, in_3d=True)
    assert portrait.scene is not None
    joint = next(joint["name"] for joint in portrait.scene["joints"] if joint["moves"])
    curve = Curve("base", joint, "position", (0.5, 1.0, 1.5), (0.1, 0.2, 0.2), (0.1, 0.9, 0.3))
    passed = rover(tmp_path)._replace(curves=(curve,))
    failed = passed._replace(
        controllers=tuple(each._replace(verdict=Verdict.FAILED) for each in passed.controllers if each.name == "base")
    )
    buttons = Elements(page_of(failed, portrait=portrait)).named("button")
    [pose] = [json.loads(a["data-pose"] or "") for a in buttons if "data-pose" in a]
    assert pose == {"joint": joint, "second": 1.0, "positions": {joint: 0.9}}
    assert "data-pose" not in page_of(passed, portrait=portrait)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({}, 0.5),
        ({"measured": (0.0, 1.0)}, None),
        ({"band": (0.95, 1.05)}, 1.0),
        ({"band": (0.8, 1.05)}, None),
        ({"band": (0.8, 1.05), "limits": (0.1, 2.0)}, 0.5),
    ],
)
def test_a_controller_fails_where_a_joint_is_farthest_from_where_it_should_be(
    changes: dict[str, Any], expected: float | None
) -> None:
    curve = Curve("arm", "elbow", "position", (0.5, 1.0), (0.0, 1.0), (0.0, 0.9))
    measured = {"measured": (-0.2, 0.9)} if not changes else {}
    pose = failing_pose("arm", [curve._replace(**{**changes, **measured})])
    assert (pose and pose["second"]) == expected


@needs_node
def test_a_replay_is_between_the_samples() -> None:
    replay = {"seconds": [1.0, 2.0, 4.0], "positions": [0.0, 1.0, 5.0]}
    script = f"console.log(JSON.stringify([0, 1.5, 3, 9].map(time => positionAt({json.dumps(replay)}, time))))"
    # node has no page: what finds the buttons of one is given none
    assert in_node(script, "replay.js", before="const document = { querySelectorAll: () => [] };") == [0, 0.5, 3, 5]


# -- charts ----------------------------------------------------------------------------------------------------------


def drawn(**changes: Any) -> dict[str, Any]:
    curve = Curve("arm", "elbow", "position", (0.5, 1.0), (0.0, 1.0), (0.0, 0.9), unit="rad")
    return chart(curve._replace(**changes))


def test_a_chart_has_axes_with_round_values_and_its_unit() -> None:
    made = drawn()
    assert [text for _, text in made["x_ticks"]] == ["0", "0.5", "1"]
    assert [text for _, text in made["y_ticks"]] == ["0", "0.5", "1"]
    assert made["unit"] == "rad"
    assert made["label"] == "elbow: position in rad over 1 s, commanded ends at 1 rad, measured ends at 0.9 rad"


def test_a_value_is_where_its_tick_is() -> None:
    made = drawn(measured=(0.0, 1.0))
    ticks = {text: y for y, text in made["y_ticks"]}
    assert made["measured"].split()[-1] == f"{made['x_ticks'][-1][0]:.1f},{ticks['1']:.1f}"


def test_the_tolerance_is_a_band_around_the_end() -> None:
    made = drawn(band=(0.8, 1.2))
    ticks = {float(text): y for y, text in made["y_ticks"]}
    per_unit = ticks[0.0] - ticks[1.0]
    assert made["band"]["height"] == pytest.approx(0.4 * per_unit)
    assert made["band"]["y"] == pytest.approx(ticks[1.0] - 0.2 * per_unit)
    assert "must end between 0.8 and 1.2 rad" in made["facts"]


@pytest.mark.parametrize(("limits", "lines"), [((-0.2, 1.3), 2), ((-3.0, 1.3), 1), ((-3.0, 3.0), 0)])
def test_limits_that_are_near_are_drawn_and_all_are_named(limits: tuple[float, float], lines: int) -> None:
    made = drawn(limits=limits)
    assert len(made["limits"]) == lines
    assert f"limits {limits[0]:g} to {limits[1]:g} rad" in made["facts"]


def test_efforts_are_in_per_cent_of_the_limit() -> None:
    made = drawn(efforts=(50.0, -100.0))
    low, high = made["effort"]["low"], made["effort"]["high"]
    ys = [float(point.split(",")[1]) for point in made["effort"]["line"].split()]
    assert ys == pytest.approx([(low + high) / 2, high])
    assert "effort up to 100 % of its limit" in made["facts"]


@pytest.mark.parametrize("values", [(), (float("nan"), 1.0), (0.0, 0.0), (1e300, -1e300)])
def test_odd_values_make_a_chart_too(values: tuple[float, ...]) -> None:
    assert drawn(commanded=values, measured=values)["y_ticks"]


@needs_pybullet
def test_the_curves_of_an_engine_have_band_limits_and_efforts(tmp_path: Path) -> None:
    arm = ARMS["joints that turn level"]
    target = target_of(tmp_path, {"robot.urdf": arm.urdf(), "controllers.yaml": arm.yaml()})
    made = whole(target, "pybullet", distro="jazzy")
    elements = Elements(page_of(made))
    lines = [a["class"] for a in elements.named("polyline")]
    assert lines.count("commanded") == lines.count("measured") == 2
    for curve in made.curves:
        assert curve.band is not None
        assert curve.band[0] <= curve.measured[-1] <= curve.band[1]
        assert curve.unit == "rad"
        assert max(map(abs, curve.efforts)) <= 100.5
        assert any(curve.efforts)
    labels = [a["aria-label"] or "" for a in elements.named("svg") if a.get("class") == "chart"]
    assert labels[0].startswith("shoulder: position in rad over ")


# -- the commands ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", [["lint"], ["smoke", "--engine", "none"]])
def test_lint_and_smoke_write_the_same_page(folder: Folder, command: list[str]) -> None:
    broken = Rover().urdf().replace('type="continuous"', 'type="spinning"')
    folder.write({"robot.urdf": broken, "controllers.yaml": Rover().yaml()})
    run = folder.run(*command, ".", "--distro", "jazzy", "--report", "page.html", environ={"SOURCE_DATE_EPOCH": "0"})
    assert run.returncode == 1, run.stderr
    elements = Elements((folder.path / "page.html").read_text(encoding="utf-8"))
    assert {"What is started together", "1970-01-01T00:00:00+00:00"} <= set(elements.texts)
    assert any(text.startswith("Findings (") for text in elements.texts)
    assert [text for text in elements.texts if text.startswith(f"urdfctl {command[0]} ")]
    assert elements.named("mark"), "in the source line of a finding"


def test_a_report_without_a_name_is_one_line(folder: Folder) -> None:
    folder.write({"robot.urdf": Rover().urdf()})
    run = folder.run("lint", "robot.urdf", "--report=")
    assert (run.returncode, run.stderr) == (2, "urdfctl: --report requires the name of a file\n")


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
