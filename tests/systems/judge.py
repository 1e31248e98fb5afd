"""Compares what urdfctl says of a workspace with the system that it was written from."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from systems.faults import FAULTS
from systems.render import ExpectedRobot, Workspace
from systems.render.description import ADDRESS
from urdfctl import api
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.report.json_report import target_document

_Document = dict[str, Any]


class Verdict(NamedTuple):
    """What is wrong about what urdfctl says.

    missing: why a robot is not given back as it is started.
    untold: the planted inconsistency, if it is not told.
    false: errors that are none.
    """

    missing: tuple[str, ...] = ()
    untold: tuple[str, ...] = ()
    false: tuple[str, ...] = ()

    @property
    def is_right(self) -> bool:
        """Whether nothing is wrong."""
        return not any(self)


def judged(workspace: Workspace) -> Verdict:
    """Return the verdict on what urdfctl says of a workspace."""
    with TemporaryDirectory(prefix="urdfctl-system-") as name:
        folder = Path(name).resolve() / "src"
        workspace.write(folder)
        return judged_in(workspace, folder)


def judged_in(workspace: Workspace, folder: Path) -> Verdict:
    """Return the same of a workspace that is written in a folder already."""
    targets, unused, findings = _said(workspace, folder)
    errors = [finding for finding in findings if finding.severity is Severity.ERROR]
    told = [finding for finding in (errors if _is_sure(workspace) else findings) if _tells(workspace, finding)]
    false = [finding for finding in errors if finding not in told and not _follows(workspace, finding)]
    return Verdict(
        tuple(dict.fromkeys(_missing(workspace, targets, unused))),
        () if told else tuple(_untold(workspace, findings)),
        tuple(_line(finding) for finding in false),
    )


def _said(workspace: Workspace, folder: Path) -> tuple[list[_Document], list[str], Sequence[Diagnostic]]:
    """What is started together, as `urdfctl show` has it, files that nothing uses, and findings. Paths are relative."""
    before = os.getcwd()
    os.chdir(folder)
    options: _Document = {"distro": workspace.system.distro} if workspace.is_distro_given else {}
    try:
        report = api.lint(".", workspace=".", jobs=1, **options)
        return [target_document(target) for target in report.targets], [*report.unused], report.findings
    except api.UserError as error:
        if "nothing to lint" not in str(error):
            raise
        return [], [], []
    finally:
        os.chdir(before)


def _line(finding: Diagnostic) -> str:
    return f"{finding.code} {os.path.basename(finding.at.file)}:{finding.at.line} {finding.message}"


# -- what is told -------------------------------------------------------------------------------------------------


def _is_sure(workspace: Workspace) -> bool:
    """Whether the planted inconsistency has to be an error."""
    fault = workspace.system.fault
    return fault is None or FAULTS[fault.kind].is_sure(workspace.system)


def _tells(workspace: Workspace, finding: Diagnostic) -> bool:
    """Whether a finding tells the planted inconsistency."""
    fault = workspace.system.fault
    return fault is not None and finding.code in FAULTS[fault.kind].codes and _names(finding, fault.names)


def _follows(workspace: Workspace, finding: Diagnostic) -> bool:
    """Whether a finding names what the planted inconsistency is about."""
    fault = workspace.system.fault
    return fault is not None and _names(finding, (*fault.names, *fault.touched))


def _names(finding: Diagnostic, names: Sequence[str]) -> bool:
    text = "\n".join(
        [finding.message, *(note.message for note in finding.notes), *(also.message for also in finding.also)]
    )
    return any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", text) for name in names)


def _untold(workspace: Workspace, findings: Sequence[Diagnostic]) -> Iterator[str]:
    fault = workspace.system.fault
    if fault is not None and workspace.is_fault_visible:
        weaker = [finding.code for finding in findings if _tells(workspace, finding)]
        yield (
            f"{fault.kind}: only {weaker[0]} as {_severity(findings, weaker[0])}"
            if weaker
            else f"{fault.kind}: nothing"
        )


def _severity(findings: Sequence[Diagnostic], code: str) -> str:
    return next(finding.severity.value for finding in findings if finding.code == code)


# -- what is recovered --------------------------------------------------------------------------------------------


def _missing(workspace: Workspace, targets: Sequence[_Document], unused: Sequence[str]) -> Iterator[str]:
    starts = {str(start) for start in workspace.starts}
    for robot in workspace.robots:
        problems = [_problem(workspace, robot, target) for target in targets if target["robot"] == robot.description]
        if not problems:
            yield "no robot"
        elif None not in problems:
            yield min((problem for problem in problems if problem), key=lambda problem: (len(problem), problem))[-1]
    used = {file for robot in workspace.robots for file in robot.parameters}
    if used & set(unused):
        yield "parameters unused"
    known = {robot.description for robot in workspace.robots}
    for target in targets:
        if target["launch"] in starts and target["robot"] and target["robot"] not in known:
            yield "another robot in a start"
        if target["robot"] not in known and used & set(target["controllers"]):
            yield "parameters of another robot"
        if target["robot"] in known and _strange(workspace, target):
            yield "foreign parameters"


def _strange(workspace: Workspace, target: _Document) -> bool:
    """Whether a target has parameters of what is no part of the system."""
    robots = [robot for robot in workspace.robots if robot.description == target["robot"]]
    own = {file for robot in robots for file in robot.parameters | robot.extra}
    return bool(set(target["controllers"]) - own)


def _problem(workspace: Workspace, robot: ExpectedRobot, target: _Document) -> tuple[str, ...] | None:
    """What is wrong about a target, the most important last, so that a shorter list is better; None if nothing is."""
    spawned = _spawned(workspace, target)
    parameters = set(target["controllers"])
    wrong = {
        "simulator": target["launch"] in workspace.starts
        and workspace.is_simulator_known
        and (target["simulator"] or "") not in (workspace.system.simulator, "none"[: not workspace.system.simulator]),
        "distro": not _is_distro(workspace, target),
        "namespace": (target["namespace"] or "").strip("/") != robot.namespace,
        "arguments": _own(target["arguments"]) != _own(dict(robot.arguments)),
        "spawned": spawned != robot.spawned,
        "parameters": not robot.parameters <= parameters,
        "launch file": target["launch"] not in workspace.starts,
    }
    if wrong["spawned"]:
        wrong["spawned"] = False
        wrong["nothing spawned" if not spawned else "spawned more" if robot.spawned < spawned else "spawned less"] = (
            True
        )
    found = tuple(name for name, is_wrong in wrong.items() if is_wrong)
    return found or None


def _spawned(workspace: Workspace, target: _Document) -> set[str]:
    """The controllers that are spawned, except where a planted fault sends a spawner: nobody is there."""
    wrong = [f"{robot.asked}/" for robot in workspace.system.robots if robot.asked != robot.manager]
    names = {name.strip("/") for name in target["spawned"]}
    return {name for name in names if not name.startswith(tuple(wrong))}


def _is_distro(workspace: Workspace, target: _Document) -> bool:
    """Whether a target is for a distro that the workspace names; where it names none, for the generation of ROS."""
    if len(workspace.distros) == 1:
        return target["distro"] in workspace.distros
    allowed = not workspace.distros or target["distro"] is None or target["distro"] in workspace.distros
    return allowed and target["ros"] == workspace.system.generation


def _own(arguments: dict[str, str]) -> dict[str, str]:
    """Arguments without paths, and without those that are empty by default or have no value yet."""
    return {name: value for name, value in arguments.items() if value and "/" not in value and name != ADDRESS}
