"""A fuzzer that keeps what reaches new code: `python tests/fuzz/guided.py launch --seconds 120`; it needs `atheris`.

Each input stands in the place of one file of a small package, and what reads it runs in this process. A fault is an
exception that is neither a refusal nor out of budget, a rule that crashed, or more time than it may take. Each is told
once, and its input kept in `fuzz-faults`.
"""

from __future__ import annotations

import argparse
import os
import re
import resource
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import Any

import atheris
from mutations import mutated
from seeds import CHECKOUT, OTHER_TEXTS, trees

with atheris.instrument_imports(include=["urdfctl", "xacro"]):
    import urdfctl.load.controller_files  # noqa: F401 (what is imported later is not instrumented)
    from urdfctl.config.file import Config, config_of
    from urdfctl.config.settings import Settings
    from urdfctl.errors import UserError
    from urdfctl.expand.job import expand_work
    from urdfctl.lint.job import job_for, perform_alone
    from urdfctl.lint.merging import merge
    from urdfctl.lint.selection import Selection
    from urdfctl.lint.target import lint_target
    from urdfctl.load.loader import Loader
    from urdfctl.load.target import Target
    from urdfctl.logs.digest import digest
    from urdfctl.logs.reading import Lines
    from urdfctl.report.common import Report
    from urdfctl.report.log_text import render_log
    from urdfctl.report.sarif import render
    from urdfctl.rules import all_rules
    from urdfctl.source.budget import OverBudget
    from urdfctl.source.problem import ReadError

    all_rules()

SECONDS, MOST_BYTES, DISTROS = 10, 20_000, ("noetic", "humble", "rolling")
LAUNCH = b"""<launch><arg name="prefix" default=""/>
<rosparam file="$(find arm)/config/controllers.yaml" subst_value="true"/>
<param name="robot_description" command="$(find xacro)/xacro '$(find arm)/urdf/arm.xacro' prefix:=$(arg prefix)"/>
<group ns="a" if="$(eval 1 == 1)"><node name="s" pkg="controller_manager" type="spawner" args="arm --timeout 3"/>
</group><include file="$(find arm)/launch/x.launch" pass_all_args="true"/></launch>
"""
PACKAGE = {
    "launch/arm.launch": LAUNCH,
    **{name: OTHER_TEXTS[name] for name in ("package.xml", "joints.yaml", "urdf/arm.xacro", "config/controllers.yaml")},
}


def lint(settings: Settings, **files: Any) -> None:
    """Lint a robot with what belongs to it, and report it."""
    outcome = lint_target(Loader(settings), Target("urdf/arm.xacro", **files), Selection()).result.outcome
    if outcome.crashed:
        raise RuntimeError(next(one.message for one in outcome.diagnostics if one.code == "UC000"))
    render(Report((), tuple(merge([outcome], Selection()))))


def read_xacro(settings: Settings) -> None:
    perform_alone(job_for(expand_work, Target("urdf/arm.xacro"), settings))
    lint(settings)


def read_toml(settings: Settings) -> None:
    config = config_of("urdfctl.toml") or Config()
    config.excludes("urdf/arm.xacro")
    config.ignores("urdf/arm.xacro", "UC101")
    lint(settings._replace(additions=config.additions), controllers=("config/controllers.yaml",))


def read_log(_: Settings) -> None:
    with open("gazebo.log", "rb") as log:
        render_log(digest(Lines(log), pasted=False), pasted=False, complete=True)


YAML, XML = "config/controllers.yaml", "launch/arm.launch"
READERS: dict[str, tuple[str, tuple[str, ...], Callable[[Settings], None]]] = {
    "xacro": ("urdf/arm.xacro", (".xacro", ".urdf"), read_xacro),
    "yaml": (YAML, (".yaml", ".yml"), lambda settings: lint(settings, controllers=(YAML,))),
    "launch": (XML, (".launch", ".launch.xml"), lambda settings: lint(settings, launch=XML)),
    "toml": ("urdfctl.toml", (".toml",), read_toml),
    "log": ("gazebo.log", (".log",), read_log),
}
"""What is read, how the names of files end that may stand in its place, and what reads it."""


class Trials:
    """What was tried until the time was over, and the faults that were found, by where they came from."""

    def __init__(self, target: str, seconds: float) -> None:
        self.target, self.until = target, time.monotonic() + seconds
        self.file, _, self.read = READERS[target]
        self.keep = Path("fuzz-faults").resolve()
        self.tried, self.slowest, self.faults = 0, 0.0, set[str]()

    def __call__(self, data: bytes) -> None:
        if time.monotonic() > self.until:
            print(
                f"{self.target}: {self.tried} tried, {len(self.faults)} faults, the slowest took {self.slowest:.1f} s"
            )
            sys.stdout.flush()
            os._exit(bool(self.faults))
        self.tried += 1
        Path(self.file).write_bytes(data)
        began = time.process_time()
        signal.setitimer(signal.ITIMER_REAL, SECONDS)
        try:
            with suppress(UserError, ReadError, OverBudget, MemoryError):
                self.read(Settings(distro=DISTROS[self.tried % len(DISTROS)]))
        except Exception as error:  # noqa: BLE001 (whatever it is, it is a fault)
            self.blame(error, data)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            self.slowest = max(self.slowest, time.process_time() - began)

    def blame(self, error: Exception, data: bytes) -> None:
        last = traceback.extract_tb(error.__traceback__)[-1]
        key = re.sub(r"'[^']*'|\d+", "…", f"{error!r} {last.filename} {last.name}")
        if key not in self.faults:
            self.faults.add(key)
            self.keep.mkdir(exist_ok=True)
            path = self.keep / f"{self.target}-{len(self.faults)}"
            path.write_bytes(data)
            print(f"FAULT {path}: {error!r} in {last.name}, {last.filename}:{last.lineno}", flush=True)


def too_late(_signal: int, _frame: object) -> None:
    raise TimeoutError(f"takes longer than {SECONDS} s")


def main() -> None:
    options = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    options.add_argument("target", choices=READERS)
    options.add_argument("--seconds", type=float, default=60)
    options.add_argument("--seed", type=int, default=1)
    given = options.parse_args()
    pieces = {
        data for tree in [PACKAGE, *trees()] for name, data in tree.items() if name.endswith(READERS[given.target][1])
    }
    if given.target == "toml":
        pieces.update(re.findall(rb"(?s)```toml\n(.*?)```", (CHECKOUT / "docs/configuration.md").read_bytes()))
    seeds = sorted(piece for piece in pieces if len(piece) < MOST_BYTES)
    trials = Trials(given.target, given.seconds)

    def change(data: bytes, most: int, seed: int) -> bytes:
        random = Random(seed)  # noqa: S311 (nothing secret)
        if random.random() < 0.3:
            return bytes(atheris.Mutate(data, most))
        return mutated(data, random, [random.choice(seeds)])[:most]

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, data in {**PACKAGE, **{f"seeds/{number}": seed for number, seed in enumerate(seeds)}}.items():
            Path(name).parent.mkdir(exist_ok=True)
            Path(name).write_bytes(data)
        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
        signal.signal(signal.SIGALRM, too_late)
        flags = [f"-seed={given.seed}", f"-max_len={MOST_BYTES}", "-timeout=0", "-rss_limit_mb=0", "-verbosity=0"]
        atheris.Setup([sys.argv[0], "seeds", *flags], trials, custom_mutator=change)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
