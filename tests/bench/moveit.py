"""Compare what `gen-moveit` writes with configurations of MoveIt that people made.

    python tests/bench/moveit.py ROBOTS.yaml --trees DIR [--only NAME]... [--samples N]

ROBOTS.yaml lists `robots`, each with a name, its tree (a folder of DIR), and in it the description, its arguments
(NAME:=VALUE), and the SRDF (`semantic`) that people made for it, with `semantic_arguments` if they differ;
`controllers` is their file for controllers, or the folder of it, and `options` are words for gen-moveit. Each is
generated twice, with other seeds, in the folder `moveit_of_urdfctl` of its tree. Of a robot is said:

- which groups, end effectors and controllers of theirs are found: those that move the same joints;
- on how many pairs of links, of those on which both runs agree, theirs agrees, and why the other pairs differ, by a
  measure of its own; known pairs are of links that theirs disables any pair of: it was made before the robot got the
  others;
- which links of pairs that ours calls Never touch in named poses, ours and theirs;
- why the Setup Assistant cannot have made their matrix for this description, if it cannot; the totals say how many
  pairs agree in those that it can have made;
- the processor time of one run;
- whether lint has no error in the package, gen-check is quiet, smoke passes, and a second run changes nothing.
"""

from __future__ import annotations

import argparse
import resource
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from pathlib import Path
from typing import Any, NamedTuple

import yaml
from matrices import Poses, described, judged, packages_in, signs_of_hands, touching_in_poses

_OUTPUT = "moveit_of_urdfctl"
_SEEDS = (1, 2)
_MOVING = ("revolute", "continuous", "prismatic")
_ENDS = ("lower", "upper")
_LISTED = 60
Pair = frozenset[str]


class Tree:
    """The links of a description, and the joints that move them."""

    def __init__(self, text: str) -> None:
        self.root = root = ET.fromstring(text)
        self.joints = {joint.get("name", ""): joint for joint in root.findall("joint")}
        self.above = {joint.find("child").get("link"): joint for joint in self.joints.values()}
        self.solid = [link.get("name", "") for link in root.findall("link") if link.find("collision") is not None]

    def moves(self, name: str) -> bool:
        """Whether a joint is one that a group moves by itself."""
        joint = self.joints.get(name)
        if joint is None or joint.get("type") not in _MOVING or joint.find("mimic") is not None:
            return False
        limit = joint.find("limit")
        span = {float(limit.get(end, "0")) for end in _ENDS} if limit is not None else set()
        return joint.get("type") == "continuous" or len(span) == len(_ENDS)

    def chain(self, base: str, tip: str) -> Iterator[str]:
        """Yield the joints from one link up to another."""
        while tip != base and tip in self.above:
            joint = self.above[tip]
            yield joint.get("name", "")
            tip = joint.find("parent").get("link", "")

    def mount(self, link: str) -> str:
        """Return the first of the links that are fixed to one."""
        while link in self.above and self.above[link].get("type") not in _MOVING:
            link = self.above[link].find("parent").get("link", "")
        return link


class Semantic(NamedTuple):
    """An SRDF. groups: the joints of each that move. composed: groups that only name others. tools: joints, mount."""

    groups: Mapping[str, frozenset[str]]
    composed: frozenset[str]
    tools: Mapping[str, tuple[frozenset[str], str]]
    pairs: Mapping[Pair, str]


def semantic_in(text: str, tree: Tree) -> Semantic:
    """Return the parts of an SRDF that are compared."""
    root = ET.fromstring(text)
    named = {group.get("name", ""): group for group in root.findall("group")}
    groups = {name: frozenset(filter(tree.moves, _joints(group, named, tree))) for name, group in named.items()}
    composed = [name for name, group in named.items() if len(group) and all(one.tag == "group" for one in group)]
    tools = {
        one.get("name", ""): (
            groups.get(one.get("group", ""), frozenset()),
            tree.mount(one.get("parent_link", "")),
        )
        for one in root.findall("end_effector")
    }
    pairs = {
        frozenset((one.get("link1", ""), one.get("link2", ""))): one.get("reason", "")
        for one in root.findall("disable_collisions")
    }
    return Semantic(groups, frozenset(composed), tools, pairs)


def _joints(group: ET.Element, named: Mapping[str, ET.Element], tree: Tree) -> Iterator[str]:
    for part in group:
        name = part.get("name", "")
        if part.tag == "chain":
            yield from tree.chain(part.get("base_link", ""), part.get("tip_link", ""))
        elif part.tag == "joint":
            yield name
        elif part.tag == "link" and name in tree.above:
            yield tree.above[name].get("name", "")
        elif part.tag == "group" and name in named and named[name] is not group:
            yield from _joints(named[name], named, tree)


def controllers_in(folder: Path, tree: Tree) -> dict[str, frozenset[str]]:
    """Return the joints of the controllers that MoveIt gets from the files of a folder, or from one file."""
    found: dict[str, frozenset[str]] = {}
    for path in [folder] if folder.is_file() else sorted(folder.rglob("*.yaml")):
        try:
            document = yaml.safe_load(path.read_text())
        except (yaml.YAMLError, OSError, UnicodeDecodeError):
            continue
        for name, joints in _listed(document):
            moved = frozenset(joint for joint in joints if tree.moves(joint))
            if moved:
                found.setdefault(name, moved)
    return found


def _listed(value: Any) -> Iterator[tuple[str, list[str]]]:
    if isinstance(value, dict):
        for one in value.get("controller_list") or ():
            if isinstance(one, dict) and isinstance(one.get("joints"), list):
                yield str(one.get("name")), [str(joint) for joint in one["joints"]]
        for name in value.get("controller_names") or ():
            one = value.get(name)
            if isinstance(one, dict) and isinstance(one.get("joints"), list):
                yield str(name), [str(joint) for joint in one["joints"]]
        for inner in value.values():
            yield from _listed(inner)


class Tool:
    """The program that is compared, in the folder of one robot."""

    def __init__(self, folder: Path, robot: Mapping[str, Any]) -> None:
        self.folder, self.robot = folder, robot

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        """Run a command of urdfctl."""
        line = [sys.executable, "-m", "urdfctl", *words]
        return subprocess.run(line, cwd=self.folder, capture_output=True, text=True, check=False)

    def near(self, path: Path) -> str:
        """Return a path as it is written in the folder."""
        return str(path.relative_to(self.folder))

    def semantic(self) -> str:
        """Return the text of the SRDF that people made, without xacro if it has any."""
        path = self.robot["semantic"]
        if not path.endswith(".xacro"):
            return (self.folder / path).read_text()
        given = self.robot.get("semantic_arguments", self.robot.get("arguments", ()))
        return self.run("expand", path, *given).stdout

    def generate(self, out: Path, seed: int, samples: int) -> subprocess.CompletedProcess[str]:
        """Write the package."""
        words = [self.robot["description"], *self.robot.get("arguments", ()), *self.robot.get("options", ())]
        more = ["--samples", str(samples), "--seed", str(seed), "-o", self.near(out), "--force"]
        return self.run("gen-moveit", *words, *more)


def compared(tool: Tool, out: Path, samples: int) -> dict[str, Any]:
    """Return what is found of one robot."""
    robot = tool.robot
    shutil.rmtree(out, ignore_errors=True)
    began = resource.getrusage(resource.RUSAGE_CHILDREN)
    packages = [out / f"{robot['name']}_planned_{seed}" for seed in _SEEDS]
    made = [tool.generate(package, seed, samples) for package, seed in zip(packages, _SEEDS, strict=True)]
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = (ended.ru_utime + ended.ru_stime - began.ru_utime - began.ru_stime) / len(_SEEDS)
    if any(one.returncode for one in made):
        said = next(one for one in made if one.returncode).stderr.strip().splitlines()
        return {"refused": said[-1] if said else "?", "seconds": round(seconds, 1)}
    tree = Tree(tool.run("expand", robot["description"], *robot.get("arguments", ())).stdout)
    written = tool.semantic()
    theirs = semantic_in(written, tree)
    texts = [next(one.glob("config/*.srdf")).read_text() for one in packages]
    ours = [semantic_in(text, tree) for text in texts]
    poses = Poses(tree.root, packages_in(tool.folder), tool.folder)
    config = tool.folder / robot.get("controllers", Path(robot["semantic"]).parent)
    mine = controllers_in(packages[0] / "config", tree)
    return {
        "seconds": round(seconds, 1),
        "groups": missing({n: one for n, one in theirs.groups.items() if n not in theirs.composed}, ours[0].groups),
        "composed": missing({n: theirs.groups[n] for n in theirs.composed}, ours[0].groups, together=True),
        "end effectors": tools_missing(theirs, ours[0], tree),
        "controllers": missing(controllers_in(config, tree), mine, together=True),
        "signs of hands": signs_of_hands(ET.fromstring(written), described(tree.root)),
        "pairs": pairs_compared(tree, theirs, ours, poses),
        "touching in named poses": {
            whose: touching_in_poses(ET.fromstring(text), ours[0].pairs, poses)
            for whose, text in (("ours", texts[0]), ("theirs", written))
        },
        "checks": checks(tool, packages[0], samples),
    }


def missing(
    theirs: Mapping[str, frozenset[str]], ours: Mapping[str, frozenset[str]], *, together: bool = False
) -> dict[str, str]:
    """Say which of their sets of joints is found under which name. together: several of ours can make one up."""
    found: dict[str, str] = {}
    for name, joints in theirs.items():
        if not joints:
            continue
        same = [other for other, moved in ours.items() if moved == joints]
        parts = {other: moved for other, moved in ours.items() if moved <= joints}
        if not same and together and parts and frozenset().union(*parts.values()) == joints:
            same = [" and ".join(parts)]
        found[name] = same[0] if same else f"MISSING {sorted(joints)}"
    return found


def tools_missing(theirs: Semantic, ours: Semantic, tree: Tree) -> dict[str, str]:
    """Say which of their end effectors is found, and whether it is mounted on the same part; an arm itself is none."""
    found = {}
    for name, (joints, mount) in theirs.tools.items():
        same = [(other, at) for other, (moved, at) in ours.tools.items() if moved == joints]
        if not same and joints & {*tree.chain("", mount)}:
            found[name] = "moves what it is mounted on"
        elif not same:
            found[name] = "no joint moves it" if not joints else f"MISSING {sorted(joints)}"
        else:
            found[name] = same[0][0] + ("" if same[0][1] == mount else f" on {same[0][1]} instead of {mount}")
    return found


def pairs_compared(tree: Tree, theirs: Semantic, ours: Sequence[Semantic], poses: Poses) -> dict[str, Any]:
    """Count the pairs on which both runs of ours agree, and those of them on which theirs does; judge the others."""
    every = [frozenset(pair) for pair in combinations(tree.solid, 2)]
    sure = [pair for pair in every if len({pair in one.pairs for one in ours}) == 1]
    differ = [pair for pair in sure if (pair in theirs.pairs) != (pair in ours[0].pairs)]
    verdicts = [(pair, *(one.pairs.get(pair, "tested") for one in (ours[0], theirs))) for pair in differ]
    measures = [poses.measured(pair, touched_ours=pair not in ours[0].pairs) for pair in differ[:_LISTED]]
    reasons = [judged(mine, other, found) for (_, mine, other), found in zip(verdicts, measures, strict=False)]
    shown = [
        f"{', '.join(sorted(pair))}: ours {mine}, theirs {other}: {why} {tuple(found)}"
        for (pair, mine, other), found, why in zip(verdicts, measures, reasons, strict=False)
    ]
    agreed = len(sure) - len(differ)
    share = round(100 * agreed / len(sure), 1) if sure else 100.0
    listed = frozenset().union(*theirs.pairs)
    known = [pair for pair in sure if pair <= listed]
    of_known = sum(pair not in differ for pair in known)
    return {
        "all": len(every),
        "sure": len(sure),
        "agree": agreed,
        "percent": share,
        "known": len(known),
        "agree on known": of_known,
        "reasons": dict(Counter(reasons)),
        "differ": shown,
    }


def checks(tool: Tool, package: Path, samples: int) -> dict[str, str]:
    """Say of each check of a package whether it passes."""
    before = {path: path.read_bytes() for path in package.rglob("*") if path.is_file()}
    lint = tool.run("lint", tool.near(package), "--format", "concise")
    smoke = tool.run("smoke", tool.near(package))
    fresh = tool.run("gen-check", tool.near(package))
    again = tool.generate(package, _SEEDS[0], samples)
    after = {path: path.read_bytes() for path in package.rglob("*") if path.is_file()}
    errors = [line for line in lint.stdout.splitlines() if " error " in line and line.startswith(tool.near(package))]
    return {
        "lint": "quiet" if not errors else errors[0],
        "smoke": (smoke.stdout.strip().splitlines() or [smoke.stderr.strip()])[-1] if smoke.returncode else "passes",
        "gen-check": "quiet" if (fresh.returncode, fresh.stdout) == (0, "") else fresh.stdout + fresh.stderr,
        "second run": "changes nothing" if before == after else f"changes files ({again.returncode})",
    }


def main() -> int:
    """Print what is found of each robot, and the totals."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("robots", type=Path)
    parser.add_argument("--trees", type=Path, required=True)
    parser.add_argument("--only", action="append", metavar="NAME")
    parser.add_argument("--samples", type=int, default=10_000)
    options = parser.parse_args()
    wanted = [
        robot
        for robot in yaml.safe_load(options.robots.read_text())["robots"]
        if not options.only or robot["name"] in options.only
    ]
    results = {}
    for robot in wanted:
        tool = Tool(options.trees / robot["tree"], robot)
        results[robot["name"]] = compared(tool, tool.folder / _OUTPUT, options.samples)
        sys.stdout.write(yaml.safe_dump({robot["name"]: results[robot["name"]]}, sort_keys=False, width=160))
        sys.stdout.flush()
    sys.stdout.write(totals(results))
    return 0


def totals(results: Mapping[str, Mapping[str, Any]]) -> str:
    """Return the lines below all robots."""
    whole = [one for one in results.values() if "refused" not in one]
    found = [one for one in whole if not any("MISSING" in said for kind in _FOUND for said in one[kind].values())]
    made = [one for one in whole if not one["signs of hands"]]
    clean = [one for one in whole if {*one["checks"].values()} <= {"quiet", "passes", "changes nothing"}]
    reasons = sum((Counter(one["pairs"]["reasons"]) for one in made), Counter())
    return (
        f"{len(results)} robots, {len(whole)} written; groups, end effectors and controllers found in {len(found)}; "
        f"{len(clean)} pass all checks\n"
        f"pairs: {_agreeing(whole)}\n"
        f"{len(made)} without a sign of hands: {_agreeing(made)}\n"
        + "".join(f"  {count} {why}\n" for why, count in reasons.most_common())
    )


def _agreeing(robots: Sequence[Mapping[str, Any]]) -> str:
    kinds = ("sure", "agree", "known", "agree on known")
    sure, agree, known, of_known = (sum(one["pairs"][kind] for one in robots) for kind in kinds)
    share = f" ({100 * agree / sure:.1f} %)" if sure else ""
    return f"{agree} of {sure} agree{share}, {of_known} of {known} known ones"


_FOUND = ("groups", "end effectors", "controllers")

if __name__ == "__main__":
    sys.exit(main())
