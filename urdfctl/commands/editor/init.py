"""`urdfctl init`: find the robots of a project, and write its configuration, a pre-commit hook and a workflow."""

from __future__ import annotations

import json
import os
import shlex
import sys
from collections.abc import Sequence

from urdfctl import __version__
from urdfctl.catalog.distros import ALL, SIMULATORS
from urdfctl.commands.answering import AnswerOptions, answered
from urdfctl.commands.declaring import EXIT, OTHER, OUTPUT, Command, argument, option
from urdfctl.commands.editor.origin import Origin, origin
from urdfctl.commands.generate.measuring import measure_work
from urdfctl.commands.options import TargetOptions
from urdfctl.commands.words import configured, settings_from
from urdfctl.config.file import NAMES, Config
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.generate.robot.job import measure_robot
from urdfctl.lint.findings.merging import merge, outcomes_of
from urdfctl.lint.planning import discovered
from urdfctl.lint.run import LintRequest, lint
from urdfctl.lint.selection import Selection
from urdfctl.output.answer import CommandAnswer, FileState
from urdfctl.output.change import Change
from urdfctl.output.journal import restore_unfinished
from urdfctl.output.links import check_output
from urdfctl.output.writing import encoded, would_overwrite, write_file
from urdfctl.output.writing_all import write_all
from urdfctl.report.baseline import open_baseline
from urdfctl.report.common import relative_message
from urdfctl.report.template_folder import own_folder
from urdfctl.smoke.engines import installed
from urdfctl.source.disk.files import named_bytes

_MOST = 50
"""With more descriptions than this, only the first ones are read."""
_MORE = (".pre-commit-config.yaml", ".github/workflows/urdfctl.yaml")
_BASELINE = "urdfctl-baseline.json"
_HOOK = """repos:
  - repo: local
    hooks:
      - id: urdfctl-check
        name: urdfctl check
        entry: urdfctl check . --engine none
        language: LANGUAGE
        files: '\\.(urdf|xacro|launch|ya?ml)$|launch\\.(xml|py)$|(^|/)launch/[^/]*\\.py$|(^|/)package\\.xml$'
        pass_filenames: false
        require_serial: true
"""
_ACTION = """      # The action does the same, uploads SARIF and compares with the base of a pull request:
      # - uses: ACCOUNT/urdfctl@vVERSION
"""


class InitOptions(TargetOptions, AnswerOptions):
    """Write an urdfctl.toml with the robots of a folder, its distro and its simulator.

    \b
    Example: urdfctl init --distro jazzy --simulator gz --pre-commit --workflow --baseline
    """

    folder: str = argument("Folder of the project. Default: this folder.", default=".")
    pre_commit: bool | None = option(OTHER, "Add the pre-commit hook.")
    workflow: bool | None = option(OTHER, "Add a workflow for GitHub.")
    baseline: bool = option(
        EXIT, f"Write what lint finds today to the baseline, by default {_BASELINE}, and hide it in every run."
    )
    force: bool = option(OUTPUT, "Overwrite existing files.")


def run_init(options: InitOptions) -> int:
    """Write the files of a project, and return the exit status."""
    return answered("init", options, lambda answer: _init(options, answer))


def _init(options: InitOptions, answer: CommandAnswer) -> int:
    folder = options.folder
    if not os.path.isdir(folder):
        raise UserError(f"folder '{folder}' does not exist")
    target, hook, workflow = (os.path.normpath(os.path.join(folder, name)) for name in (NAMES[0], *_MORE))
    check_output(target, hook if options.pre_commit else None, workflow if options.workflow else None)
    kept = _kept(target) if would_overwrite(target) and not options.force else None
    if kept is not None and not (options.workflow or options.pre_commit or options.baseline):
        raise UserError(f"'{target}' exists; --force overwrites it")
    answer.messages(restore_unfinished())
    config = configured([folder], options)
    settings = settings_from(config, options, distro=options.distro, simulator=options.simulator)
    robots = _robots_in(folder, config, settings)
    distro = _common([facts.distro for facts in robots.values()])
    simulator = _common([facts.simulator for facts in robots.values()])
    if not answer.is_kept:
        distro = options.distro or _asked("ROS distro", ALL, distro)
        simulator = options.simulator or _asked("Simulator", SIMULATORS, simulator)
    distro, simulator = options.distro or distro, options.simulator or simulator
    text = _toml(folder, robots, distro, simulator) if kept is None else kept
    if kept is None:
        write_file(target, text, force=options.force)
        answer.file(target, FileState.WRITTEN)
    number = f"{len(robots)} robot{'s' * (len(robots) > 1)}, {distro or 'distro not set'}"
    answer.message(f"'{target}' written: {number}" if kept is None else f"'{target}' stays; --force writes it anew")
    if not distro:
        answer.message(f"ROS distro is unknown; set it in '{target}', or use --distro")
    named = config.baseline if kept is not None else None
    baseline = os.path.normpath(named or os.path.join(folder, _BASELINE))
    if options.baseline:
        _write_baseline(options, baseline, answer, distro if kept is None else None)
        if named is None:
            write_file(target, f'baseline = "{_BASELINE}"\n{text}', force=True)
    source = origin()
    if source.lacks and (options.workflow or options.pre_commit):
        answer.message(f"the workflow cannot install urdfctl before there is {source.lacks}")
    _offer(hook, _hook(source), "--pre-commit", answer, wanted=options.pre_commit)
    _offer(workflow, _workflow(source, distro), "--workflow", answer, wanted=options.workflow)
    more = f"{_as_in_workflow(options)} --write-baseline {shlex.quote(baseline)}" if options.baseline else ""
    answer.next(f"urdfctl check {folder}{more}")
    return 0


def _robots_in(folder: str, config: Config, settings: Settings) -> dict[str, RobotFacts]:
    """The robots of a folder by the paths of their files. Raises UserError if there is none."""
    found = discovered([folder], config._replace(robots=()))
    paths = list(dict.fromkeys(path for path, _ in found.descriptions()))
    measured = [(path, measure_robot(path, {}, settings, measure_work)) for path in paths[:_MOST]]
    robots = {path: one.facts for path, one in measured if one.facts and one.facts.root}
    if not robots:
        raise UserError(f"no robot found in '{folder}'")
    return robots


def _kept(target: str) -> str:
    """The text of a configuration that stays."""
    return named_bytes(target).decode("utf-8", "surrogateescape")


def _as_in_workflow(options: InitOptions) -> str:
    """The option with which a run finds what the workflow will, which moves the robot, or else what the hook will."""
    return "" if options.workflow and installed() else " --engine none"


def _write_baseline(options: InitOptions, path: str, answer: CommandAnswer, named: str | None) -> None:
    """Write what lint finds to the file that the configuration names, which lint, smoke, check and editors read.

    named: the distro that the configuration names from now on.
    """
    config = configured([options.folder], options)
    settings = settings_from(config, options, distro=options.distro, simulator=options.simulator)
    run = lint(LintRequest((options.folder,), config, settings))
    open_baseline([], Selection(), to_write=path).unknown(
        merge(outcomes_of(run.results), Selection()), {file for result in run.results for file in result.files}
    )
    answer.file(path, FileState.WRITTEN)
    if named:
        answer.message(f"these are the findings for {named}: without a distro, lint counts what others find, too")
    answer.message(f"what '{path}' lists is hidden; the smoke test's findings are not in it yet: see below")


def _hook(source: Origin) -> str:
    """The configuration of pre-commit: it runs this urdfctl, if it cannot be installed from anywhere."""
    if source.lacks:
        return _HOOK.replace("LANGUAGE", "system  # the urdfctl on PATH")
    return _HOOK.replace("LANGUAGE", f'python\n        additional_dependencies: ["{source.requirement}"]')


def _common(names: Sequence[str | None]) -> str | None:
    """The only name of several robots; None if they differ, or none is known."""
    known = {name for name in names if name}
    return known.pop() if len(known) == 1 else None


def _asked(what: str, choices: Sequence[str], detected: str | None) -> str | None:
    """What was detected, or what the user answers if there is one to ask."""
    if detected or not sys.stdin.isatty():
        return detected
    sys.stderr.write(f"{what} ({', '.join(choices)}; empty: leave it open): ")
    sys.stderr.flush()
    answer = sys.stdin.readline().strip()
    if answer and answer not in choices:
        raise UserError(f"unknown {what.lower()} '{answer}'; choose from {', '.join(choices)}")
    return answer or None


def _toml(folder: str, robots: dict[str, RobotFacts], distro: str | None, simulator: str | None) -> str:
    lines = [
        f"distro = {_text(distro)}" if distro else '# distro = "jazzy"',
        f"simulator = {_text(simulator)}" if simulator else '# simulator = "gz"',
    ]
    for path in robots:
        lines += ["", "[[robot]]", f"path = {_text(os.path.relpath(path, folder).replace(os.sep, '/'))}"]
    return "\n".join([*lines, ""])


def _workflow(source: Origin, distro: str | None) -> str:
    with open(os.path.join(own_folder(), "project", "workflow.yml"), encoding="utf-8") as file:
        text = file.read()
    extras = source.requirement.replace("urdfctl", "urdfctl[smoke]", 1)
    text = text.replace("      # ACTION\n", _ACTION.replace("ACCOUNT", source.account) if source.account else "")
    text = text.replace("OPTIONS", f" --distro {distro}" if distro else "")
    return text.replace("REQUIREMENT", extras).replace("VERSION", __version__)


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False)


def _offer(path: str, text: str, option: str, answer: CommandAnswer, *, wanted: bool | None) -> None:
    """Write a file if it is wanted; else say how to get it. An existing file is left alone."""
    if wanted is False:
        return
    if would_overwrite(path):
        answer.message(f"'{path}' exists; add this to it if it is missing:\n{text}" if wanted else f"'{path}' exists")
        return
    if wanted is None and sys.stdin.isatty() and not answer.is_kept:
        sys.stderr.write(f"Write '{path}'? [y/N] ")
        sys.stderr.flush()
        wanted = sys.stdin.readline().strip().lower() in ("y", "yes")
    if not wanted:
        answer.message(f"'{path}' is not written; {option} adds it")
        return
    for problem in write_all([Change(os.path.abspath(path), None, encoded(text))]):
        raise UserError(relative_message(problem))
    answer.file(path, FileState.WRITTEN)
    answer.message(f"'{path}' written")


command = Command(InitOptions, run_init)
