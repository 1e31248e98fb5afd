"""The playground in a browser: it finds the fault of the sample, and can connect to no other place."""

from __future__ import annotations

import json
import re
import sys
import threading
import time
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from chromium import Browser, Page, browser, needs_browser
from folder import CHECKOUT

sys.path.append(str(CHECKOUT / "docs" / "site"))

from playground import policy, write_playground

PYODIDE = CHECKOUT / "docs" / "site" / "node_modules" / "pyodide"
needs_pyodide = pytest.mark.skipif(not PYODIDE.is_dir(), reason="Pyodide is not installed: npm ci in docs/site")
PATIENCE = 300.0
BOMB = """<robot name="bomb" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>
<xacro:macro name="m" params="n"><xacro:m n="${n + 1}"/><xacro:m n="${n + 1}"/></xacro:macro><xacro:m n="0"/></robot>"""


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass


class Visit:
    """A page in a browser, used by its buttons."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def until(self, expression: str) -> Any:
        """Wait until an expression is true, and return its value."""
        end = time.monotonic() + PATIENCE
        while not (value := self.page.run(expression)):
            assert time.monotonic() < end, self.page.run("document.body.innerText")
            time.sleep(0.1)
        return value

    def do(self, action: str, panel: str) -> str:
        """Do something, wait until it is done, and return the text of a panel."""
        self.page.run(f"document.getElementById('state').textContent = ''; {action}")
        self.until("/^(Done|Stopped)/.test(document.getElementById('state').textContent)")
        return str(self.page.run(f"document.getElementById('{panel}').innerText"))

    def press(self, button: str, panel: str) -> str:
        return self.do(f"document.getElementById('{button}').click()", panel)

    def paste(self, text: str) -> str:
        return self.do(
            f"document.getElementById('text').value = {json.dumps(text)}; document.getElementById('lint').click()",
            "findings",
        )


def opened(started: Browser, address: str) -> Visit:
    page = started.page()
    started.ask("Page.navigate", {"url": address}, page.session)
    visit = Visit(page)
    visit.until("document.getElementById('state')?.textContent == 'Ready'")
    return visit


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("site")
    write_playground(folder, PYODIDE)
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/index.html"
    server.shutdown()
    server.server_close()


@needs_browser
@needs_pyodide
@pytest.mark.timeout(1200)
def test_a_robot_is_linted_mended_drawn_generated_and_shared_in_the_browser(address: str) -> None:
    with browser() as started:
        visit = opened(started, address)
        assert "UC201" in visit.press("example", "findings")
        mended = visit.press("fix", "findings")
        assert "UC201" not in mended
        visit.press("tab-graph", "graph")
        assert "left_wheel_joint" in visit.page.run("document.querySelector('#graph iframe').srcdoc")
        assert visit.page.run("document.querySelector('#graph iframe').getBoundingClientRect().width > 900")
        visit.press("tab-view", "view")
        assert visit.page.run("document.querySelector('#view iframe').srcdoc.includes('in 3-D')")
        visit.page.run("document.getElementById('distro').value = 'noetic'")
        visit.page.run("document.getElementById('simulator').value = 'gazebo-classic'")
        assert "package.xml" in visit.press("generate", "generated")
        assert "gains" in visit.press("explain", "explained")
        cause = "No valid hardware interface element found in joint 'left_wheel_joint'."
        visit.page.run(f"document.getElementById('message').value = {json.dumps(cause)}")
        assert "Causes, most likely first" in visit.press("explain", "explained")
        assert visit.page.run("document.querySelector('#explained a').href.includes('/messages/')")
        visit.page.run("document.getElementById('share').click()")
        shared = visit.until("location.hash.length > 1 && location.href")
        assert visit.page.refused == []
        other = opened(started, shared)
        assert other.until("document.getElementById('verdict')?.textContent")
        assert other.page.run("document.getElementById('file').options.length") > 1


@needs_browser
@needs_pyodide
@pytest.mark.timeout(1200)
def test_a_robot_that_never_ends_gives_a_message_and_the_page_lives_on(address: str) -> None:
    with browser() as started:
        visit = opened(started, address)
        assert re.search("too|never ends|nested|deep", visit.paste(BOMB))
        assert "No findings" in visit.paste('<robot name="r"><link name="base"/></robot>')


@needs_browser
@needs_pyodide
@pytest.mark.timeout(1200)
def test_the_page_can_connect_to_no_other_place(address: str) -> None:
    with browser() as started:
        visit = opened(started, address)
        asked = "fetch('http://localhost:9/x').then(() => 'sent', () => 'refused')"
        assert visit.page.run(asked) == "refused"
        assert any("connect-src" in text for text in visit.page.refused)


def test_the_policy_of_the_playground_lets_it_connect_to_its_own_folder_only() -> None:
    rules = dict(rule.split(" ", 1) for rule in policy().split("; "))
    assert rules["default-src"] == "'none'"
    assert rules["connect-src"] == "'self'"
    assert "unsafe-inline" not in policy()
    assert "'unsafe-eval'" not in policy()


def test_what_the_page_asks_of_the_driver_is_there() -> None:
    folder = Path(CHECKOUT / "docs" / "site" / "playground")
    asked = set(re.findall(r"python\.ask\('(\w+)'", (folder / "app.js").read_text("utf-8")))
    defined = set(re.findall(r"^def ([a-z]\w*)", (folder / "driver.py").read_text("utf-8"), re.MULTILINE))
    assert asked
    assert asked <= defined
