#!/usr/bin/env python3
"""Migrate robots that people migrated by hand, and compare: what of theirs is also in ours, and of ours in theirs.

    python tests/bench/migration.py --trees DIR                          every pair (about twenty minutes)
    python tests/bench/migration.py --trees DIR --only champ --differences
    python tests/bench/migration.py --trees DIR --json migration.json --keep OUT

DIR holds ID/before and ID/after of each pair in the list (`--pairs`; `../shared/tools/wild.py --pairs` lays them out).
A copy of *before* is migrated in place to the distro of *after*. Compared are sets of facts (`robot_facts.py`), with

    recall      what of *after* the migration also has
    precision   what of the migration *after* also has

Only what both sides have is compared: joints that are controlled before and after (in robots of the same name, if there
are any), controllers that are configured before and after, parameters that the distro reads. The hardware plugin of a
driver that appears only in *after* is left out: nobody can know it before. `joints` counts those that have a command
interface in common, `interfaces` every interface: people add some. They rename, drop and re-tune too, so that no score
can reach 1. `--runs` also lints the result for its distro, and moves the robot's joints before and after.

The row `people` compares *before* with *after* in the same way: what people kept. Nothing here judges: the exit status
is 1 only if a migration failed, or a joint that moved before no longer does.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import yaml
from robot_facts import KINDS, Facts, facts_of_folder
from robot_runs import runs_of

from urdfctl.catalog.distros import ROS2

DEFAULT_PAIRS = Path("../shared/wild/pairs.yaml")
OLDEST = {"foxy": "humble", "galactic": "humble"}
"""Distros that are at their end: the interfaces are those of the next one."""
LATEST = "rolling"
HERE = Path(__file__).resolve().parents[2]
OF_GZ = ("gz_ros2_control", "ign_ros2_control", "gz-sim-", "ignition-gazebo-")
CLASSIC = ("gazebo_ros2_control", "gazebo_ros_control")
SCORED = ("joints", *KINDS)
KNOWN_HARDWARE = (*CLASSIC, "gz_ros2_control", "ign_ros2_control", "_components", "transmission_interface")
USES = {"joints": "joints", "interfaces": "interfaces", "types": "types", "plugins": "plugins"}
SPELLINGS = ((r"ign_ros2_control", "gz_ros2_control"), (r"(?:ignition-gazebo|gz-sim)\d*-", "gz-sim-"))
DESCRIPTIONS = ("*.xacro", "*.urdf", "*.gazebo")


class Score(NamedTuple):
    """How many facts agree, of how many of the person's and of ours."""

    both: int
    theirs: int
    ours: int

    def __add__(self, other: tuple[int, ...]) -> Score:  # type: ignore[override]
        return Score(*(one + more for one, more in zip(self, other, strict=True)))

    @property
    def recall(self) -> float | None:
        return self.both / self.theirs if self.theirs else None

    @property
    def precision(self) -> float | None:
        return self.both / self.ours if self.ours else None


def arguments(argv: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--trees", type=Path, required=True, help="folder with ID/before and ID/after")
    parser.add_argument("--pairs", type=Path, default=DEFAULT_PAIRS, help="list of pairs (default: %(default)s)")
    parser.add_argument("--only", action="append", default=[], metavar="ID", help="only these pairs")
    parser.add_argument("--kind", help="only pairs of this kind: ros1-ros2, classic-gz, distro")
    parser.add_argument("--use", help="only pairs whose use begins with this, e.g. joints")
    parser.add_argument("--differences", action="store_true", help="show which facts differ")
    parser.add_argument("--runs", action="store_true", help="lint the result, and smoke it before and after")
    parser.add_argument("--json", type=Path, help="write every number there too")
    parser.add_argument("--keep", type=Path, help="keep the migrated folders there, as ID")
    return parser.parse_args(argv)


def target_of(pair: dict[str, Any]) -> str:
    """The distro that a person migrated to, by the name of the branch."""
    ref = pair["to"]["ref"]
    named = next((distro for distro in ROS2 if distro in ref), None)
    newest = "humble" if pair["to"]["date"] < "2025" and pair["kind"] == "ros1-ros2" else LATEST
    return OLDEST.get(named, named) if named else newest


def simulator_of(after: Facts, kind: str, folder: Path) -> str | None:
    """The simulator of a robot by the kind of its migration, a bridge, which only gz needs, its plugins, or the texts
    of its files if it cannot be expanded; None if they name none or both."""
    if kind == "classic-gz" or after["bridged"]:
        return "gz"
    names = [name for (name,) in after["plugins"]]
    if not names:
        files = (path for pattern in DESCRIPTIONS for path in folder.rglob(pattern) if path.is_file())
        names = [path.read_text(errors="replace") for path in files]
    classic = any(part in name for name in names for part in CLASSIC)
    gz = any(part in name for name in names for part in OF_GZ)
    return None if classic == gz else "gazebo-classic" if classic else "gz"


def migrated(before: Path, out: Path, distro: str, simulator: str | None) -> str:
    """Migrate a copy; return why that failed, empty if it did not."""
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(before, out, symlinks=True)
    command = [sys.executable, "-m", "urdfctl", "migrate", str(out), "--to", distro, "--in-place", "--force"]
    command += ["--simulator", simulator] if simulator else []
    run = subprocess.run(command, cwd=HERE, capture_output=True, text=True, check=False)
    return "" if run.returncode in (0, 1) else run.stderr.strip().rpartition("\n")[2] or f"status {run.returncode}"


def compared(kind: str, ours: Facts, theirs: Facts, before: Facts) -> tuple[set[tuple[str, ...]], set[tuple[str, ...]]]:
    """The facts of one kind that can be compared: of what both sides have."""
    own, other = _spelled(ours[kind]), _spelled(theirs[kind])
    if kind == "interfaces":
        joints = before["joints"] & theirs["joints"]
        other = of_robots({robot for robot, _, _ in before["robots"]}, theirs)
        return {f for f in own if f[:1] in joints}, {f for f in other if f[:1] in joints}
    if kind in {"types", "keys"}:
        names = ours["controllers"] & theirs["controllers"]
        return {f for f in own if f[:1] in names}, {f for f in other if f[:1] in names}
    if kind == "plugins":
        named = _spelled(before[kind])
        return own, {f for f in other if f in named or not _is_of_driver(f[0])}
    return own, other


def of_robots(names: set[str], facts: Facts) -> set[tuple[str, ...]]:
    """The interfaces of the joints of the robots with these names; of joints that those do not have, all."""
    own = {(joint, interface) for robot, joint, interface in facts["robots"] if robot in names}
    joints = {joint for joint, _ in own}
    return own | {fact for fact in facts["interfaces"] if fact[0] not in joints}


def _is_of_driver(plugin: str) -> bool:
    """Whether a plugin is hardware that only its owner knows: no simulator's, no mock, none of ros2_control itself."""
    return "/" in plugin and not any(package in plugin for package in KNOWN_HARDWARE)


def agreeing(ours: Facts, theirs: Facts, before: Facts) -> Score:
    """How many of the joints that both sides control have an interface in common."""
    one, other = compared("interfaces", ours, theirs, before)
    both = {joint for joint, _ in one & other}
    return Score(len(both), len({joint for joint, _ in other}), len({joint for joint, _ in one}))


def _spelled(facts: Iterable[tuple[str, ...]]) -> set[tuple[str, ...]]:
    """The facts with one spelling for plugins that Ignition and gz have: both names load the same."""
    spelled = set()
    for fact in facts:
        last = fact[-1].removeprefix("lib").removesuffix(".so")
        for old, new in SPELLINGS:
            last = re.sub(old, new, last).replace("IgnitionSystem", "GazeboSimSystem")
        spelled.add((*fact[:-1], last))
    return spelled


def measured(pair: dict[str, Any], options: argparse.Namespace, folder: Path) -> dict[str, Any]:
    """Migrate one pair and compare it."""
    before_folder, after_folder = (options.trees / pair["id"] / side for side in ("before", "after"))
    distro = target_of(pair)
    before, after = facts_of_folder(str(before_folder.resolve())), facts_of_folder(str(after_folder.resolve()), distro)
    simulator = simulator_of(after, pair["kind"], after_folder)
    out = (options.keep or folder).resolve() / pair["id"]
    failure = migrated(before_folder.resolve(), out, distro, simulator)
    ours = facts_of_folder(str(out), distro)
    row: dict[str, Any] = {name: pair[name] for name in ("id", "kind", "use")}
    row |= {"to": distro, "simulator": simulator, "failure": failure}
    row["joints"], row["people joints"] = agreeing(ours, after, before), agreeing(before, after, before)
    for kind in KINDS:
        one, other = compared(kind, ours, after, before)
        kept, _ = compared(kind, before, after, before)
        row[kind] = Score(len(one & other), len(other), len(one))
        row[f"people {kind}"] = Score(len(kept & other), len(other), len(kept))
        row[f"missing {kind}"], row[f"more {kind}"] = sorted(other - one), sorted(one - other)
    came_from = "noetic" if pair["kind"].startswith("ros1") else None
    row["runs"] = runs_of(before_folder.resolve(), out, distro, came_from=came_from) if options.runs else None
    if not options.keep:
        shutil.rmtree(out, ignore_errors=True)
    return row


def table(rows: list[dict[str, Any]]) -> str:
    """Recall and precision of each pair, and the totals."""
    lines = [f"{'pair':24} {'to':8}" + "".join(f"{kind:>12}" for kind in SCORED)]
    for row in rows:
        lines.append(f"{row['id']:24} {row['to']:8}" + "".join(f"{_shown(row[kind]):>12}" for kind in SCORED))
        lines += [f"  failed: {row['failure']}"] if row["failure"] else []
    for name, before in (("all", ""), ("people", "people ")):
        totals = [sum((row[before + kind] for row in rows), Score(0, 0, 0)) for kind in SCORED]
        lines.append(f"{name:33}" + "".join(f"{_shown(total):>12}" for total in totals))
    for use, kind in USES.items():
        total = sum((row[kind] for row in rows if use in row["use"].split(", ")), Score(0, 0, 0))
        lines.append(f"{kind} of the pairs for '{use}': {_shown(total)} ({total.both} of {total.theirs})")
    return "\n".join(lines)


def _shown(score: Score) -> str:
    texts = ("-" if value is None else f"{value:.2f}" for value in (score.recall, score.precision))
    return " ".join(texts)


def runs(row: dict[str, Any]) -> str:
    """The errors that lint finds after the migration of one pair and not before, and the joints that no longer move."""
    found = row["runs"]
    before, after = map(len, found["moved"])
    lines = [f"{row['id']:24} {row['to']:8} {len(found['errors'])} new errors, {before} joints moved, now {after}"]
    lines += [f"  {error.code} {error.file}: {error.message}" for error in found["errors"]]
    return "\n".join([*lines, *(f"  no longer moves: {joint}" for joint in found["lost"])])


def differences(row: dict[str, Any]) -> str:
    """The facts of one pair that differ."""
    lines = [f"\n== {row['id']}"]
    for kind in KINDS:
        lines += [f"  {kind}: not in ours: {' '.join(fact)}" for fact in row[f"missing {kind}"]]
        lines += [f"  {kind}: only in ours: {' '.join(fact)}" for fact in row[f"more {kind}"]]
    return "\n".join(lines)


def main(argv: list[str] | None = None) -> int:
    options = arguments(argv)
    pairs = yaml.safe_load(options.pairs.read_text())["pairs"]
    wanted = [
        pair
        for pair in pairs
        if (not options.only or pair["id"] in options.only)
        and options.kind in {None, pair["kind"]}
        and pair["use"].startswith(options.use or "")
    ]
    rows = []
    with tempfile.TemporaryDirectory(prefix="urdfctl-migration-") as folder:
        for pair in wanted:
            rows.append(measured(pair, options, Path(folder)))
            print(pair["id"], file=sys.stderr)
    print(table(rows))
    if options.differences:
        print("\n".join(differences(row) for row in rows))
    if options.runs:
        print("\n".join(map(runs, rows)))
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1) + "\n")
    return 1 if any(row["failure"] or (row["runs"] and row["runs"]["lost"]) for row in rows) else 0


if __name__ == "__main__":
    raise SystemExit(main())
