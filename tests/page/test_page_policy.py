"""A browser runs the scripts of urdfctl in its pages, and nothing that names of robots could bring in."""

from __future__ import annotations

import hashlib
import re
from base64 import b64encode
from collections.abc import Iterator
from pathlib import Path
from xml.sax.saxutils import quoteattr

import pytest
from chromium import Browser, browser, needs_browser
from folder import CHECKOUT, Folder
from pages import PAGES, Elements

from urdfctl.graph.svg import STYLE
from urdfctl.report.pages import page
from urdfctl.view.meshes import installed

BROUGHT_IN = """<script>window.hurt = "script"</script><img src="none" onerror="window.hurt = 'image'">
<a id="brought" href="javascript:void (window.hurt = 'link')">link</a><svg onload="window.hurt = 'svg'"></svg>
<iframe srcdoc="<script>parent.hurt = 'frame'</script>"></iframe><style>body { display: none }</style>
<p id="styled" style="display: none">x</p><form action="http://127.0.0.1:1/"><input type="submit" id="sent"></form>
<base href="http://127.0.0.1:1/"><link rel="stylesheet" href="http://127.0.0.1:1/a.css">"""
NAMES = [
    "</script><script>window.hurt = 1</script>",
    "<img src=none onerror='window.hurt = 2'>",
    '" onmouseover="window.hurt = 3" autofocus onfocus="window.hurt = 3',
    "' onmouseover='window.hurt = 4' tabindex=0",
    "<!--<script>",
    "javascript:window.hurt = 5",
    "a\u2028b\u202ec",
    "{{ 7919 * 7907 }}{% raw %}",
    "<svg/onload=window.hurt=6>",
    "&lt;b&gt;",
]
ACT = """(() => {
  document.querySelector("#brought")?.click();
  for (const one of document.querySelectorAll("*"))
    for (const event of ["mouseover", "mouseenter", "focus", "click", "load", "error"])
      if (one.tagName !== "A" && one.type !== "submit") one.dispatchEvent(new Event(event));
  return new Promise(done => setTimeout(() => done(String(window.hurt)), 200));
})()"""
SEARCH = """(() => {
  const search = document.querySelector(".wired-search");
  search.value = "hw"; search.dispatchEvent(new Event("input"));
  return document.querySelectorAll(".graph.dimmed .lit").length;
})()"""
SLIDE = """(() => {
  const row = document.querySelector(".robot-joints li[data-joint]"), input = row.querySelector("input");
  const before = row.querySelector("output").textContent;
  input.value = input.max; input.dispatchEvent(new Event("input"));
  return [before, row.querySelector("output").textContent];
})()"""


def robot(names: list[str]) -> str:
    """A robot whose parts have names, with hardware."""
    joints = "".join(
        f"<link name={quoteattr(f'l{name}')}/><joint name={quoteattr(name)} type='revolute'>"
        f"<parent link='base'/><child link={quoteattr(f'l{name}')}/><axis xyz='0 0 1'/>"
        "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"
        for name in names
    )
    controlled = "".join(
        f"<joint name={quoteattr(name)}><command_interface name='position'/><state_interface name='position'/></joint>"
        for name in names
    )
    plugin = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    box = "<visual><geometry><box size='1 1 1'/></geometry></visual>"
    return (
        f"<robot name={quoteattr(names[0])}><link name='base'>{box}</link>{joints}"
        f"<ros2_control name='hw' type='system'>{plugin}{controlled}</ros2_control></robot>"
    )


CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {type: position_controllers/JointGroupPositionController}
arm:
  ros__parameters:
    joints: [JOINTS]
    none: 1
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The pages of a robot with hostile names, by what made them."""
    folder = Folder(tmp_path_factory.mktemp("pages"))
    joints = ", ".join("'" + name.replace("'", "''") + "'" for name in NAMES[:1])
    folder.write({"r.urdf": robot(NAMES), "c.yaml": CONTROLLERS.replace("JOINTS", joints), "old.urdf": robot(["a"])})
    files = ("r.urdf", "c.yaml", "--distro", "jazzy")
    words = {
        "graph": ("graph", *files, "--format", "html=graph.html"),
        "lint": ("lint", *files, "--report", "lint.html"),
        "smoke": ("smoke", *files, "--report", "smoke.html", "--engine", "none"),
        "diff": ("diff", "old.urdf", "r.urdf", "--format", "html=diff.html"),
    }
    if installed():
        words["view"] = ("view", *files, "-o", "view.html")
    for given in words.values():
        assert folder.run(*given).returncode in {0, 1}
    return {name: folder.path / f"{name}.html" for name in words}


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    with browser() as started:
        yield started


def policy_of(text: str) -> dict[str, list[str]]:
    """The directives of a page's policy."""
    [meta] = [a for a in Elements(text).named("meta") if a.get("http-equiv") == "Content-Security-Policy"]
    parts = (part.split() for part in (meta["content"] or "").split(";"))
    return {name: allowed for name, *allowed in parts}


def test_each_page_allows_only_the_scripts_and_styles_of_urdfctl(made: dict[str, Path]) -> None:
    own = [path.read_text(encoding="utf-8") for path in PAGES.iterdir() if path.suffix in {".js", ".css"}] + [STYLE]
    hashes = {f"'sha256-{b64encode(hashlib.sha256(text.encode()).digest()).decode()}'" for text in own}
    for path in made.values():
        policy = policy_of(path.read_text(encoding="utf-8"))
        assert {*policy["script-src"], *policy["style-src"]} <= hashes
        assert policy["default-src"] == policy["base-uri"] == policy["form-action"] == ["'none'"]
        assert policy.keys() == {"default-src", "script-src", "style-src", "base-uri", "form-action"}


def test_the_policy_comes_before_all_that_it_is_about(made: dict[str, Path]) -> None:
    for path in made.values():
        before = path.read_text(encoding="utf-8").partition("Content-Security-Policy")[0]
        assert re.findall(r"<(\w+)", before) == ["html", "head", "meta", "meta"]


def test_a_panel_of_the_editor_finds_the_policy_where_it_looks_for_it(made: dict[str, Path]) -> None:
    source = (CHECKOUT / "editors/vscode/src/policy.ts").read_text(encoding="utf-8")
    patterns = dict(re.findall(r"const (HEAD|OWN|HASH) = /\^(.*)/;", source))
    for path in made.values():
        text = path.read_text(encoding="utf-8")
        assert re.match(patterns["HEAD"] + patterns["OWN"], text)
        policy = policy_of(text)
        assert all(re.match(patterns["HASH"], one) for one in (*policy["script-src"], *policy["style-src"]))


def test_no_name_is_markup(made: dict[str, Path]) -> None:
    for path in made.values():
        text = path.read_text(encoding="utf-8")
        elements = Elements(text)
        assert not {"img", "iframe", "base", "form"} & {tag for tag, _ in elements.found}
        assert not [name for _, attributes in elements.found for name in attributes if name.startswith("on")]
        # an anchor, or a file beside the page: a path has neither a scheme nor a host
        assert not [one for one in elements.addresses if not re.fullmatch(r"#.*|(?!/)[\w./%~-]+", one)]
        assert not re.search("[\u2028-\u202e]", text)
        assert str(7919 * 7907) not in " ".join(elements.texts)


@needs_browser
def test_each_page_works_and_none_of_its_names_runs(made: dict[str, Path], chromium: Browser) -> None:
    for name, path in made.items():
        shown = chromium.page()
        shown.open(path)
        assert shown.run(ACT) == "undefined", name
        assert shown.refused == [], name
        assert [text for text in shown.said if "GL Driver" not in text] == [], name
        assert shown.run("getComputedStyle(document.documentElement).getPropertyValue('--accent')"), name
        if name in {"graph", "lint", "smoke"}:
            assert shown.run(SEARCH) > 1, name
        if installed() and name in {"view", "lint", "smoke"}:
            before, after = shown.run(SLIDE)
            assert (before, after) == ("0.00 rad", "1.00 rad"), name


@needs_browser
def test_what_is_brought_in_all_the_same_does_not_run(made: dict[str, Path], chromium: Browser) -> None:
    """As if the texts of a page were not escaped."""
    for name, path in made.items():
        text = path.read_text(encoding="utf-8").replace("</body>", f"{BROUGHT_IN}</body>")
        changed = path.with_name(f"changed-{path.name}")
        changed.write_text(text, encoding="utf-8")
        shown = chromium.page()
        shown.open(changed)
        assert shown.run(ACT) == "undefined", name
        assert shown.run("getComputedStyle(document.body).display") == "block", name
        assert shown.run("getComputedStyle(document.querySelector('#styled')).display") == "block", name
        assert shown.run("document.baseURI").startswith("file:"), name
        assert len(shown.refused) >= 7, shown.refused


@needs_browser
def test_without_the_policy_it_would_run(made: dict[str, Path], chromium: Browser) -> None:
    text = made["graph"].read_text(encoding="utf-8").replace("</body>", f"{BROUGHT_IN}</body>")
    changed = made["graph"].with_name("free.html")
    changed.write_text(re.sub(r"<meta http-equiv[^>]*>", "", text), encoding="utf-8")
    shown = chromium.page()
    shown.open(changed)
    assert shown.run(ACT) != "undefined"
    assert shown.run("getComputedStyle(document.body).display") == "none"


def test_a_text_in_a_page_keeps_its_direction() -> None:
    values = {"file": "a\u202eb", "distro": "\u2066<b>", "drawing": "", "complete": True, "errors": []}
    text = page("graph", title="x\ty", styles={"drawing.css": ""}, **values)
    assert "<code>a\\u202eb</code>, \\u2066&lt;b&gt;" in text
    assert "<title>x\\ty</title>" in text
