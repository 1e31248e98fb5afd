"""What runs beside us in a workflow cannot change by itself, and gets no rights that it does not need."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from folder import CHECKOUT, Folder
from generating import command

WORKFLOWS = CHECKOUT / ".github" / "workflows"
TEMPLATE = "templates/project/workflow.yml"
USED = r"^ *(?:#? *- )?(?:#? *)uses: (?P<action>\S+?)@(?P<revision>\S+)(?P<comment>.*)$"
OURS = "OWNER/urdfctl"
ROBOT = '<robot name="arm"><link name="base"/></robot>'
ZIZMOR = Path(sys.executable).parent / "zizmor"
needs_workflows = pytest.mark.skipif(not WORKFLOWS.is_dir(), reason="the workflows are not part of an sdist")


def pages() -> Iterator[Path]:
    """The files that run an action, or show how to."""
    yield from WORKFLOWS.glob("*.yml")
    yield from (CHECKOUT / name for name in ("action.yml", TEMPLATE, "README.md", "CONTRIBUTING.md"))
    yield from (CHECKOUT / "docs").glob("*.md")


def used() -> list[tuple[str, str, str, str]]:
    """Each use of an action of others: the page, the action, the revision and the comment behind it."""
    return [
        (page.relative_to(CHECKOUT).as_posix(), found["action"], found["revision"], found["comment"])
        for page in pages()
        for found in re.finditer(USED, page.read_text(encoding="utf-8"), re.MULTILINE)
        if found["action"] != OURS
    ]


def test_each_action_of_others_is_pinned_by_a_hash_and_says_its_version() -> None:
    assert {page for page, *_ in used()} >= {"action.yml", TEMPLATE, "docs/pipelines.md"}
    pinned = re.compile(r"[0-9a-f]{40} # v\d+\.\d+\.\d+")
    assert [one for one in used() if not pinned.fullmatch(one[2] + one[3])] == []


def test_an_action_is_pinned_by_the_same_hash_wherever_it_is_shown() -> None:
    # dependabot changes the workflows, the action and the template; this names the pages that are to follow
    repositories: dict[str, set[str]] = {}
    for _, action, revision, comment in used():
        repositories.setdefault("/".join(action.split("/")[:2]), set()).add(revision + comment)
    assert {name: pins for name, pins in repositories.items() if len(pins) > 1} == {}


# -- our own workflows -----------------------------------------------------------------------------------------------


def workflows() -> list[tuple[str, dict[str, Any]]]:
    return [
        (path.name, yaml.safe_load(path.read_text("utf-8"))) for path in [*WORKFLOWS.glob("*.yml"), CHECKOUT / TEMPLATE]
    ]


@needs_workflows
def test_a_workflow_has_no_rights_and_each_job_names_those_that_it_needs() -> None:
    for name, workflow in workflows():
        assert workflow["permissions"] == {}, name
        assert [job for job, content in workflow["jobs"].items() if "permissions" not in content] == [], name
        assert [job for job, content in workflow["jobs"].items() if "timeout-minutes" not in content] == [], name


@needs_workflows
def test_only_the_jobs_that_publish_can_write_and_they_run_nothing_of_the_checkout() -> None:
    writing = {
        f"{name}:{job}": {key for key, right in content["permissions"].items() if right == "write"}
        for name, workflow in workflows()
        for job, content in workflow["jobs"].items()
    }
    assert {job: rights for job, rights in writing.items() if rights} == {
        "check.yml:samples": {"security-events"},
        "release.yml:publish": {"id-token"},
        "release.yml:publish-site": {"contents"},
    }
    jobs = dict(workflows())["release.yml"]["jobs"]
    assert [step for step in jobs["publish"]["steps"] if "run" in step or "checkout" in step["uses"]] == []
    site = jobs["publish-site"]["steps"]
    assert [step for step in site if "checkout" in step.get("uses", "")] == []
    programs = {line.split()[0] for step in site for line in step.get("run", "").splitlines()}
    assert programs == {"touch", "git"}


@needs_workflows
def test_no_checkout_keeps_the_token_and_no_pull_request_fills_a_cache() -> None:
    for name, workflow in workflows():
        steps = [step for job in workflow["jobs"].values() for step in job["steps"]]
        checkouts = [step for step in steps if step.get("uses", "").startswith("actions/checkout@")]
        assert checkouts, name
        assert [step for step in checkouts if step.get("with", {}).get("persist-credentials") is not False] == [], name
        caches = [step["with"]["cache"] for step in steps if "cache" in step.get("with", {})]
        assert [cache for cache in caches if not cache.startswith("${{ github.event_name == 'push' && ")] == [], name
        assert [step for step in steps if "actions/cache" in step.get("uses", "")] == [], name


@needs_workflows
def test_pip_is_isolated_from_the_checkout() -> None:
    for name, workflow in workflows():
        scripts = "\n".join(step.get("run", "") for job in workflow["jobs"].values() for step in job["steps"])
        installing = [line for line in scripts.splitlines() if re.search(r"\bpip install\b", line)]
        assert [line for line in installing if " -I -m pip install " not in line] == [], name


@needs_workflows
def test_dependabot_keeps_actions_packages_and_the_extension_up_to_date() -> None:
    config = yaml.safe_load((CHECKOUT / ".github/dependabot.yml").read_text(encoding="utf-8"))
    folders = {
        (update["package-ecosystem"], folder)
        for update in config["updates"]
        for folder in (update.get("directories") or [update["directory"]])
    }
    assert folders == {
        *(("github-actions", "/"), ("github-actions", "/templates/project")),
        *(("pip", "/"), ("npm", "/editors/vscode")),
    }
    assert all((CHECKOUT / folder[1:]).is_dir() for _, folder in folders)


@needs_workflows
def test_a_fuzzer_runs_for_an_hour_each_week() -> None:
    workflow = dict(workflows())["scheduled.yml"]
    assert [entry["cron"].split()[4] for entry in workflow[True]["schedule"]] == ["1"]  # YAML 1.1 reads `on` as true
    scripts = [step.get("run", "") for step in workflow["jobs"]["fuzz"]["steps"]]
    assert 'python tests/fuzz --seconds 3600 --seed "$GITHUB_RUN_ID"' in scripts


# -- what init writes ------------------------------------------------------------------------------------------------


def written(folder: Folder) -> str:
    """The workflow that `urdfctl init` writes."""
    folder.write({"arm.urdf": ROBOT})
    ran = command("init", "--distro", "jazzy", "--workflow", "--pre-commit")
    assert ran.returncode == 0, ran.stderr
    return (folder.path / ".github/workflows/urdfctl.yaml").read_text(encoding="utf-8")


def test_init_writes_a_workflow_that_leaves_no_placeholder(folder: Folder) -> None:
    text = written(folder)
    [job] = yaml.safe_load(text)["jobs"].values()
    assert job["permissions"] == {"contents": "read"}
    assert re.search("VERSION|ACTION|OPTIONS|REQUIREMENT|OWNER|ACCOUNT", text) is None


def test_the_workflow_that_init_writes_finds_what_check_finds(folder: Folder) -> None:
    [*_, step] = yaml.safe_load(written(folder))["jobs"]["check"]["steps"]
    words = step["run"].split()
    assert words[:4] == ["python", "-I", "-m", "urdfctl"]
    assert command(*words[4:]).returncode == 0
    folder.write({"arm.urdf": ROBOT.replace("</robot>", '<joint name="j" type="sideways"/></robot>')})
    ran = command(*words[4:])
    assert (ran.returncode, "::error file=arm.urdf," in ran.stdout) == (1, True)


# -- zizmor ----------------------------------------------------------------------------------------------------------


def audited(*paths: Path) -> subprocess.CompletedProcess[str]:
    if not ZIZMOR.is_file():
        pytest.skip("zizmor is not installed beside this Python")
    words = ["--offline", "--no-progress", "--no-config", "--strict-collection", "--persona", "pedantic"]
    return subprocess.run([str(ZIZMOR), *words, *map(str, paths)], capture_output=True, text=True, check=False)


@needs_workflows
def test_zizmor_finds_nothing_in_the_workflows_and_the_action() -> None:
    ran = audited(CHECKOUT / ".github", CHECKOUT / "action.yml")
    assert ran.returncode == 0, ran.stdout


def test_zizmor_finds_nothing_in_what_init_writes(folder: Folder) -> None:
    written(folder)
    ran = audited(folder.path)
    assert ran.returncode == 0, ran.stdout
    assert "No findings to report" in ran.stdout + ran.stderr


def test_zizmor_would_find_an_action_that_is_not_pinned(folder: Folder) -> None:
    path = folder.path / ".github/workflows/urdfctl.yaml"
    path.write_text(re.sub(r"@[0-9a-f]{40} #", "@", written(folder)))
    assert "unpinned-uses" in audited(path).stdout
