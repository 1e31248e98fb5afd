"""Fixtures for all tests."""

from __future__ import annotations

import atexit
import gc
import os
import shutil
import signal
import sys
import tempfile
from pathlib import Path

import pytest
from folder import UNWANTED, Folder, checkout_first
from hypothesis import HealthCheck, settings
from robots import Robot
from slow_modules import slow_modules

TESTS = Path(__file__).parent

# no clock, for the machine may be busy; by default the same examples each time
settings.register_profile("sample", deadline=None, suppress_health_check=[HealthCheck.too_slow], derandomize=True)
settings.register_profile("whole", deadline=None, suppress_health_check=[HealthCheck.too_slow], max_examples=1000)
settings.load_profile("sample")


def pytest_configure() -> None:
    """Make every process that a test starts import this checkout, with its bytecode cached."""
    os.environ["PYTHONPATH"] = checkout_first(os.environ.get("PYTHONPATH"))
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    cache = tempfile.mkdtemp(prefix="urdfctl-tests-")  # no results of an earlier test run
    os.environ["XDG_CACHE_HOME"] = cache
    atexit.register(shutil.rmtree, cache, ignore_errors=True)
    sys.addaudithook(refuse_to_crawl_everything)
    if hasattr(os, "register_at_fork"):  # the lines of forks are not counted, and counting takes a third of their time
        os.register_at_fork(after_in_child=lambda: sys.settrace(None))
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as in a shell's background job; processes inherit it
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int | None:
    """One more than there are processors: many tests wait for a process, a limit of time or a browser."""
    from urdfctl.run.limits import processors  # not before coverage begins

    return None if "PYTEST_XDIST_AUTO_NUM_WORKERS" in os.environ else processors() + 1


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests of all modules that do not take long as fast."""
    slow = slow_modules()
    for item in items:
        if item.path.is_relative_to(TESTS) and item.path.relative_to(TESTS).as_posix() not in slow:
            item.add_marker("fast")


def refuse_to_crawl_everything(event: str, arguments: tuple[object, ...]) -> None:
    """Fail a test whose workspace is the root folder: it would depend on the machine, and take long."""
    if event == "os.scandir" and arguments[0] == "/":
        raise AssertionError("a test searches '/'; give it a workspace or a package path")


@pytest.fixture(scope="session", autouse=True)
def _rules() -> None:
    """Import all rules before the first test, so that workers, which are forks, need not do it each time."""
    from urdfctl.rules import all_faults  # not before coverage begins

    all_faults()
    gc.collect()
    gc.freeze()  # what is imported stays; to look through it again and again takes a tenth of the time of the tests
    gc.set_threshold(20_000, 20, 20)


@pytest.fixture
def judging_engine() -> None:
    """The engine that is installed moves what generators make, as it does for users."""


@pytest.fixture(autouse=True)
def _no_judging_engine(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no engine move what generators make: that takes most of their time, and few tests are about it."""
    if "judging_engine" not in request.fixturenames:
        monkeypatch.setattr("urdfctl.commands.generate.judging.installed", tuple)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Folder:
    monkeypatch.chdir(tmp_path)
    for name in [name for name in os.environ if name.startswith("ROS_") or name in UNWANTED]:
        monkeypatch.delenv(name)
    return Folder(tmp_path)


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    return Robot(tmp_path)
