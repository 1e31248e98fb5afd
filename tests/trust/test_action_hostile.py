"""The action in the checkout of a stranger's pull request: none of what lies there runs, and none of it is obeyed."""

from __future__ import annotations

import os
import re
import shutil
import site
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from action_steps import ACTION, STEPS, Job, obeyed
from folder import CHECKOUT
from markdown_it import MarkdownIt
from sampling import sample

pytestmark = [
    pytest.mark.skipif(shutil.which("bash") is None, reason="bash is not here"),
    pytest.mark.skipif(shutil.which("git") is None, reason="git is not here"),
    pytest.mark.skipif(sys.platform == "win32", reason="the programs of this test are shell scripts"),
]
ROBOT = '<robot name="arm"><link name="base"/></robot>\n'
BROKEN = '<robot name="arm"><link name="a"/><link name="b"/><joint name="j" type="sideways"/></robot>\n'

# -- the checkout ----------------------------------------------------------------------------------------------------

MODULES = (
    *("venv", "pip", "ensurepip", "encodings", "sitecustomize", "usercustomize", "site", "runpy", "re", "json"),
    *("urdfctl", "yaml", "xacro", "typer", "rich", "jinja2", "hatchling", "setuptools", "backend"),
)
"""Modules that Python, pip or urdfctl would import, each as a package that can also be run."""
PROGRAMS = ("python", "python3", "git", "less", "uname", "mktemp", "od", "tr", "cat", "head")
SPY = """
import posix
posix.write(posix.open({told!r}, posix.O_WRONLY | posix.O_CREAT | posix.O_APPEND), b"{name}\\n")
"""
"""Works where Python has not yet started: `encodings` is imported first of all."""
HOSTILE = {
    ".": "the top",
    "src": "a folder that PYTHONPATH or PATH may name",
    "lib/python3/site-packages": "an environment",
    ".venv/lib/python3/site-packages": "an environment",
}
PYPROJECT = '[build-system]\nrequires = ["evil"]\nbuild-backend = "backend"\nbackend-path = ["."]\n'
GIT_CONFIG = "".join(
    f'[{section}]\n{name} = "{{checkout}}/src/git"\n'
    for section, name in (
        *(("core", "fsmonitor"), ("core", "sshCommand"), ("core", "pager"), ("core", "editor"), ("core", "hooksPath")),
        *(('diff "evil"', "textconv"), ('diff "evil"', "command"), ("gpg", "program"), ("credential", "helper")),
    )
)


def write(folder: Path, files: Mapping[str, str]) -> None:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def git(checkout: Path, *words: str) -> None:
    identity = ("-c", "user.name=n", "-c", "user.email=n@example.com")
    subprocess.run(["git", *identity, *words], cwd=checkout, check=True, capture_output=True)


class Stranger:
    """A checkout with files that say so when they run."""

    def __init__(self, folder: Path) -> None:
        self.checkout = folder / "checkout"
        self._told = folder / "was_run"
        write(self.checkout, {"arm.urdf": BROKEN, ".gitattributes": "* diff=evil\n"})
        git(self.checkout, "init", "--quiet", "--initial-branch", "main")
        git(self.checkout, "add", ".")
        git(self.checkout, "commit", "--quiet", "-m", "before")
        write(self.checkout, {"arm.urdf": ROBOT})
        for place in HOSTILE:
            self._fill(place)
        git(self.checkout, "add", "arm.urdf")
        git(self.checkout, "commit", "--quiet", "-m", "after")
        git(self.checkout, "update-ref", "refs/remotes/origin/main", "HEAD~1")
        with (self.checkout / ".git/config").open("a") as config:
            config.write(GIT_CONFIG.format(checkout=self.checkout))

    def _fill(self, place: str) -> None:
        for name in MODULES:
            for file in ("__init__.py", "__main__.py"):
                write(self.checkout / place / name, {file: SPY.format(told=str(self._told), name=f"{place}/{name}")})
        for name in PROGRAMS:
            self._program(f"{place}/{name}")
        write(
            self.checkout / place,
            {
                "evil.pth": SPY.format(told=str(self._told), name="evil.pth").strip().replace("\n", "; "),
                "pyvenv.cfg": f"home = {self.checkout}/src\n",
                "pyproject.toml": PYPROJECT,
                "setup.cfg": "[install]\nprefix = /nowhere\n",
                "pip.conf": f"[install]\nrequirement = {self.checkout}/requirements.txt\n",
                "requirements.txt": f"{self.checkout}\n",
            },
        )

    def _program(self, name: str) -> None:
        write(self.checkout, {name: f"#!/bin/sh\necho {name} >> '{self._told}'\nexit 1\n"})
        (self.checkout / name).chmod(0o755)

    def run_by_us(self) -> list[str]:
        """What has run."""
        return sorted(set(self._told.read_text().split())) if self._told.exists() else []


# -- the action ------------------------------------------------------------------------------------------------------

BACKEND = """
import os
from zipfile import ZipFile

def build_wheel(folder, config_settings=None, metadata_directory=None):
    with ZipFile(os.path.join(folder, "urdfctl-0-py3-none-any.whl"), "w") as wheel:
        wheel.writestr("urdfctl_of_the_test.pth", {paths!r})
        wheel.writestr("urdfctl-0.dist-info/METADATA", "Metadata-Version: 2.1\\nName: urdfctl\\nVersion: 0\\n")
        wheel.writestr("urdfctl-0.dist-info/WHEEL", "Wheel-Version: 1.0\\nGenerator: n\\nTag: py3-none-any\\n")
        wheel.writestr("urdfctl-0.dist-info/RECORD", "")
    return "urdfctl-0-py3-none-any.whl"
"""
"""Builds a wheel that leads to this checkout and what is installed here, so that pip needs no package index."""


def source(folder: Path) -> Path:
    """The folder of an action whose package is this checkout's."""
    paths = "\n".join([str(CHECKOUT), *site.getsitepackages()])
    project = '[build-system]\nrequires = []\nbuild-backend = "backend"\nbackend-path = ["."]\n'
    write(folder / "action", {"pyproject.toml": project, "backend.py": BACKEND.format(paths=paths)})
    return folder / "action"


ENVIRONMENTS: dict[str, Callable[[Path], Mapping[str, str]]] = {
    "plain": lambda _checkout: {},
    "relative entries": lambda _checkout: {
        "PATH": os.pathsep.join([".", "", "src", os.environ["PATH"]]),
        **dict.fromkeys(("PYTHONPATH", "PIP_FIND_LINKS"), "."),
        **dict.fromkeys(("PYTHONHOME", "PYTHONUSERBASE"), "src"),
        "PIP_CONFIG_FILE": "pip.conf",
        "PIP_CONSTRAINT": "requirements.txt",
        "PIP_REQUIREMENT": "requirements.txt",
    },
    "the checkout on PYTHONPATH": lambda checkout: {
        "PYTHONPATH": f"{checkout}{os.pathsep}{checkout}/src",
        "PYTHONSTARTUP": f"{checkout}/src/json/__main__.py",
        "PIP_CONSTRAINT": f"{checkout}/requirements.txt",
    },
}
"""What a workflow may set for all steps, for the sake of the project that it checks."""


@pytest.fixture(scope="module", params=sample(reversed(ENVIRONMENTS), 3))
def used(request: pytest.FixtureRequest) -> Iterator[tuple[Stranger, Job, Mapping[str, str]]]:
    """The action, installed in a job whose checkout is a stranger's."""
    if find_spec("ensurepip") is None:
        pytest.skip("this Python cannot make environments: it has no ensurepip")
    with TemporaryDirectory() as name:
        folder = Path(name).resolve()
        stranger = Stranger(folder)
        job = Job(stranger.checkout, folder, source=source(folder), installed=False)
        variables = {"PIP_NO_INDEX": "1", **ENVIRONMENTS[request.param](stranger.checkout)}
        path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
        variables["PATH"] = variables.get("PATH", path).replace(os.environ["PATH"], path)
        ran = job.step("Install", {}, variables)
        assert stranger.run_by_us() == []
        assert ran.returncode == 0, ran.stdout + ran.stderr
        yield stranger, job, variables


def test_installing_runs_nothing_of_the_checkout_and_leaves_nothing_there(
    used: tuple[Stranger, Job, Mapping[str, str]],
) -> None:
    stranger, job, _ = used
    assert stranger.run_by_us() == []
    python = Path(job.outputs["steps.install.outputs.python"])
    assert python.is_relative_to(job.temp)
    assert not python.is_relative_to(stranger.checkout)


def test_linting_runs_nothing_of_the_checkout(used: tuple[Stranger, Job, Mapping[str, str]]) -> None:
    stranger, job, variables = used
    ran = job.step("Lint", {"paths": "arm.urdf"}, variables)
    assert (ran.returncode, stranger.run_by_us()) == (0, []), ran.stdout + ran.stderr
    assert (stranger.checkout / "urdfctl.sarif").is_file()


def test_comparing_runs_nothing_of_the_checkout(used: tuple[Stranger, Job, Mapping[str, str]]) -> None:
    stranger, job, variables = used
    ran = job.step("Diff", {"diff": "arm.urdf"}, variables, base="main")
    assert (ran.returncode, stranger.run_by_us()) == (0, []), ran.stdout + ran.stderr
    assert "joint" in job.summary.read_text()


def test_smoke_testing_runs_nothing_of_the_checkout(used: tuple[Stranger, Job, Mapping[str, str]]) -> None:
    stranger, job, variables = used
    options = "--engine none --allow-empty"
    ran = job.step("Smoke", {"paths": "arm.urdf", "smoke-options": options}, variables)
    assert (ran.returncode, stranger.run_by_us()) == (0, []), ran.stdout + ran.stderr


def test_each_python_of_the_action_is_isolated() -> None:
    scripts = "\n".join(step.get("run", "") for step in STEPS.values())
    first_words = re.findall(r'^ *"\$(?:python|URDFCTL_PYTHON)" (\S+)', scripts, re.MULTILINE)
    assert first_words == ["-I"] * 5


# -- what the runner obeys -------------------------------------------------------------------------------------------


@pytest.fixture
def job(tmp_path: Path) -> Job:
    """A job without strangers, in which urdfctl is installed."""
    (tmp_path / "checkout").mkdir()
    return Job(tmp_path / "checkout", tmp_path)


COMMANDS = ("::set-output name=sarif::/etc/passwd", "##[set-output name=sarif;]/etc/passwd")


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("step", ["Lint", "Diff", "Smoke"])
def test_a_word_in_the_checkout_is_no_command_to_the_runner(job: Job, step: str, command: str) -> None:
    git(job.checkout, "init", "--quiet")
    for number in range(2):
        hostile = BROKEN.replace('"arm"', f'"{command}"').replace('"j"', f'"\n{command} {number}\n"')
        write(job.checkout, {"arm.urdf": hostile, f"\n{command.replace('/', ':')}\n.urdf": hostile})
        git(job.checkout, "add", ".")
        git(job.checkout, "commit", "--quiet", "-m", "a change")
    sound = job.step(step, {"diff": "arm.urdf"}, {})
    write(job.checkout, {"urdfctl.toml": f'distro = "{command}"\n'})
    refused = job.step(step, {"diff": "arm.urdf"}, {})
    assert refused.returncode == 2
    printed = f"{sound.stdout}\n{sound.stderr}\n{refused.stdout}\n{refused.stderr}"
    assert command in printed
    assert [line for line in obeyed(printed) if not line.startswith(("::error file=", "::warning file="))] == []


def test_an_input_of_several_lines_adds_no_output(job: Job) -> None:
    write(job.checkout, {"arm.urdf": ROBOT})
    for step, name in (("Lint", "sarif"), ("Smoke", "smoke-report")):
        ran = job.step(step, {name: "a\nevil=1"}, {})
        assert (ran.returncode, job.told()) == (2, {})
        assert f"::error::the input '{name}' must be one line" in ran.stdout


def test_a_report_that_was_committed_is_not_passed_on_where_the_run_fails(job: Job) -> None:
    write(job.checkout, {"arm.urdf": ROBOT, "urdfctl.sarif": "{}", "urdfctl.toml": "nonsense = 1\n"})
    assert job.step("Lint", {}, {}).returncode == 2
    assert job.told() == {}
    [upload] = [step for step in ACTION["runs"]["steps"] if "uses" in step]
    assert "steps.lint.outputs.sarif != ''" in upload["if"]
    assert upload["with"]["sarif_file"] == "${{ steps.lint.outputs.sarif }}"


def test_the_summary_shows_names_of_the_checkout_as_code(job: Job) -> None:
    git(job.checkout, "init", "--quiet")
    names = ("a", "b`` <img src=x> [x](http://e.org) ``c", "\\| <b> @someone ` http://e.org", "`d` @someone")
    for name in names:
        text = name.replace("<", "&lt;")
        write(job.checkout, {"arm.urdf": f'<robot name="{text}" version="{text}"><link name="a"/></robot>'})
        git(job.checkout, "add", "arm.urdf")
        git(job.checkout, "commit", "--quiet", "-m", "one more")
        if name != "a":
            assert job.step("Diff", {"diff": "arm.urdf"}, {}).returncode == 0
    assert list(outside_of_code(job.summary.read_text())) == []


def outside_of_code(text: str) -> Iterator[str]:
    """Yield what is active in a text of Markdown, and words of a stranger outside of code."""
    in_code = False
    for block in MarkdownIt("commonmark").enable("table").parse(text):
        for token in block.children or ():
            if token.type == "html_inline" and token.content in {"<code>", "</code>"}:
                in_code = token.content == "<code>"
            elif token.type not in {"text", "text_special", "code_inline", "softbreak", "strong_open", "strong_close"}:
                yield token.type
            elif token.type == "text" and not in_code and re.search(r"[@<`|]|http|img", token.content):
                yield token.content
