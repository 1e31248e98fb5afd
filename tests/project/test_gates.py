"""Who opens, writes or starts something: nobody but the gates, and the places that are named here with the reason."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache

import pytest
from folder import CHECKOUT

GATES = ("urdfctl/output/", "urdfctl/source/disk/files.py", "urdfctl/source/disk/gate.py", "urdfctl/run/git.py")
"""Where files are read and written for everybody else: within bounds, and through no link that leads out of them."""

COUNTS = {
    "": "open __import__",
    "io": "open open_code FileIO",
    "os": """
        open chmod chown fchmod fchown lchown link mkdir makedirs mkfifo mknod remove removedirs rename renames replace
        rmdir symlink truncate unlink utime fork forkpty popen posix_spawn posix_spawnp startfile system
        execl execle execlp execlpe execv execve execvp execvpe
        spawnl spawnle spawnlp spawnlpe spawnv spawnve spawnvp spawnvpe
    """,
    "asyncio": "create_subprocess_exec create_subprocess_shell",
    "asyncio.subprocess": "create_subprocess_exec create_subprocess_shell",
    "jinja2": "FileSystemLoader",
}
"""What counts of a module; "" are the names that need no import."""
WHOLE = {
    "shutil": "which get_terminal_size",
    "tempfile": "gettempdir",
    "subprocess": "PIPE DEVNULL STDOUT CompletedProcess TimeoutExpired CalledProcessError SubprocessError",
    "multiprocessing": "",
    "pty": "",
    "zipfile": "",
    "tarfile": "",
    "gzip": "",
    "bz2": "",
    "lzma": "",
    "mmap": "",
    "sqlite3": "",
    "dbm": "",
    "shelve": "",
    "urllib.request": "",
    "http.client": "",
    "socket": "",
    "webbrowser": "",
}
"""Modules of which everything counts, but what is listed."""
METHODS = frozenset(
    """
    open read_text read_bytes write_text write_bytes unlink rmdir mkdir touch chmod rename symlink_to hardlink_to
    loadURDF loadMJCF loadSDF from_xml_path
    """.split()
)
"""Methods that count whatever they are called on."""

OWN = "urdfctl's own files"
INSTALLED = "of packages that the user installed beside urdfctl"
CACHE = "in the user's cache folder"
SCRATCH = "in a temporary folder that the run made and deletes"
WORKER = "urdfctl itself, in a process with limits or of its own"
TEMPLATES = "urdfctl's own templates, and the folder that --templates names"
NOWHERE = "the null device"
EXCEPTIONS = {
    "urdfctl/__main__.py open_closed_streams open": NOWHERE,
    "urdfctl/__main__.py main os.open": NOWHERE,
    "urdfctl/catalog/compiled.py _yaml .read_bytes": OWN,
    "urdfctl/catalog/compiled.py main .read_text": OWN,
    "urdfctl/catalog/compiled.py main .write_text": OWN,
    "urdfctl/catalog/schema.py _definitions open": OWN,
    "urdfctl/catalog/store.py _read open": OWN,
    "urdfctl/startup/installed_packages.py _mentions open": INSTALLED,
    "urdfctl/testing.py _findings tempfile.TemporaryDirectory": SCRATCH,
    "urdfctl/lint/cache.py RunCache.load open": CACHE,
    "urdfctl/lint/cache.py RunCache.store os.makedirs": CACHE,
    "urdfctl/lint/cache.py _delete_old os.unlink": CACHE,
    "urdfctl/commands/editor/init.py _workflow open": OWN,
    "urdfctl/doctor/collecting.py _run subprocess.run": "our own script, with the Python in which ROS is sourced",
    "urdfctl/doctor/collector.py versions open": INSTALLED,
    "urdfctl/doctor/collector_ros1.py main socket.setdefaulttimeout": "a deadline for what rospy asks",
    "urdfctl/doctor/mock_manager.py MockManager.__init__ subprocess.Popen": "the type of what `started` returns",
    "urdfctl/doctor/mock_manager.py main open": SCRATCH,
    "urdfctl/doctor/mock_manager.py main tempfile.TemporaryDirectory": SCRATCH,
    "urdfctl/doctor/mock_manager.py started open": SCRATCH,
    "urdfctl/doctor/mock_manager.py started subprocess.Popen": "ROS's own controller manager, if the user wants it",
    "urdfctl/migrate/writing.py _copy os.makedirs": SCRATCH,
    "urdfctl/migrate/writing.py _copy os.symlink": SCRATCH,
    "urdfctl/migrate/writing.py _copy shutil.copyfile": SCRATCH,
    "urdfctl/migrate/writing.py _copy shutil.copymode": SCRATCH,
    "urdfctl/commands/document.py (module) .write_text": "a developer writes the pages of this repository with it",
    "urdfctl/commands/document.py _with_part .read_text": "a developer writes the pages of this repository with it",
    "urdfctl/commands/editor/origin.py _direct_url .read_text": OWN,
    "urdfctl/compare/revisions.py _write open": SCRATCH,
    "urdfctl/compare/revisions.py _write os.makedirs": SCRATCH,
    "urdfctl/compare/revisions.py _write os.unlink": SCRATCH,
    "urdfctl/compare/revisions.py _write_link open": SCRATCH,
    "urdfctl/compare/revisions.py _write_link os.symlink": SCRATCH,
    "urdfctl/compare/sides.py _revision os.mkdir": SCRATCH,
    "urdfctl/generate/controllers/recipes.py recipes open": OWN,
    "urdfctl/generate/text/templates.py _environment jinja2.FileSystemLoader": TEMPLATES,
    "urdfctl/generate/text/templates.py _environment.Users jinja2.FileSystemLoader": TEMPLATES,
    "urdfctl/source/disk/folders.py delete_folder os.rmdir": SCRATCH,
    "urdfctl/source/disk/folders.py delete_folder os.unlink": SCRATCH,
    "urdfctl/lint/examples.py write_files open": SCRATCH,
    "urdfctl/lint/examples.py write_files os.makedirs": SCRATCH,
    "urdfctl/migrate/trial/scratch.py Scratch._copy_settings os.makedirs": SCRATCH,
    "urdfctl/migrate/trial/scratch.py Scratch._copy_settings shutil.copyfile": SCRATCH,
    "urdfctl/migrate/trial/scratch.py Scratch.write open": SCRATCH,
    "urdfctl/migrate/trial/scratch.py Scratch.write os.makedirs": SCRATCH,
    "urdfctl/migrate/trial/scratch.py Scratch.write os.unlink": SCRATCH,
    "urdfctl/migrate/trial/scratch.py _copy os.makedirs": SCRATCH,
    "urdfctl/migrate/trial/scratch.py _copy os.symlink": SCRATCH,
    "urdfctl/migrate/trial/scratch.py _copy_file os.link": SCRATCH,
    "urdfctl/migrate/trial/scratch.py _copy_file os.symlink": SCRATCH,
    "urdfctl/migrate/trial/scratch.py _copy_file shutil.copy": SCRATCH,
    "urdfctl/migrate/trial/scratch.py _mark_repository os.makedirs": SCRATCH,
    "urdfctl/report/pages.py _texts open": OWN,
    "urdfctl/report/pages.py page jinja2.FileSystemLoader": OWN,
    "urdfctl/run/fork.py ForkPool._fork os.fork": WORKER,
    "urdfctl/run/fresh.py _run_fresh subprocess.run": WORKER,
    "urdfctl/run/limits.py _address_space open": "the system tells there how much memory this process has",
    "urdfctl/schemas/robot.py _read .read_text": OWN,
    "urdfctl/server/commands/calls.py _read open": SCRATCH,
    "urdfctl/server/protocol/dialogue.py show_page open": SCRATCH,
    "urdfctl/server/commands/processes.py run_command asyncio.create_subprocess_exec": WORKER,
    "urdfctl/smoke/engines/obj_meshes.py _copied open": SCRATCH,
    "urdfctl/smoke/engines/pybullet_engine.py open_engine open": SCRATCH,
    "urdfctl/smoke/motion/engine_workers.py engine_output open": SCRATCH,
    "urdfctl/smoke/motion/engine_workers.py run_trial_job open": SCRATCH,
    "urdfctl/smoke/motion/progress.py kept open": SCRATCH,
    "urdfctl/startup/quick_imports.py _content os.open": OWN,
    "urdfctl/source/xacro/private/stand_ins.py import_what_xacro_uses __import__": OWN,
}
"""Places that need no gate: file, function and what it uses; and why."""


def uses(code: str) -> Iterator[tuple[str, str]]:
    """Yield what some code uses that counts: the function around it, and the name."""
    tree = ast.parse(code)
    imported = dict(_imported(tree))

    def visit(node: ast.AST, around: str) -> Iterator[tuple[str, str]]:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            around = f"{around}.{node.name}".lstrip(".")
        if isinstance(node, ast.Call):
            named = _name(node.func, imported)
            if named is not None and named.startswith(".") and _counts(named):
                yield around or "(module)", named
        named = _name(node, imported)
        if named is not None and not named.startswith(".") and _counts(named):
            yield around or "(module)", named
        for child in ast.iter_child_nodes(node):
            yield from visit(child, around)

    yield from visit(tree, "")


def _imported(tree: ast.AST) -> Iterator[tuple[str, str]]:
    """What imported names stand for."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield (
                    alias.asname or alias.name.partition(".")[0],
                    alias.name if alias.asname else alias.name.partition(".")[0],
                )
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            for alias in node.names:
                yield alias.asname or alias.name, f"{node.module}.{alias.name}"


def _name(node: ast.AST, imported: dict[str, str]) -> str | None:
    """The full name that a node stands for; of a method of an unknown object, it begins with a point."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        return imported.get(node.id, node.id)
    if isinstance(node, ast.Attribute):
        root = node.value
        while isinstance(root, ast.Attribute):
            root = root.value
        known = isinstance(root, ast.Name) and root.id in imported
        return f"{_name(node.value, imported)}.{node.attr}" if known else f".{node.attr}"
    return None


def _counts(name: str) -> bool:
    module, _, last = name.rpartition(".")
    if name.startswith("."):
        return last in METHODS
    whole = next((each for each in WHOLE if name.startswith(f"{each}.")), None)
    if whole is not None:
        return last not in WHOLE[whole].split()
    return last in COUNTS.get(module, "").split()


@cache
def found() -> dict[str, list[str]]:
    """Everything in the package that counts, outside of the gates."""
    places: dict[str, list[str]] = {}
    for path in sorted((CHECKOUT / "urdfctl").rglob("*.py")):
        file = path.relative_to(CHECKOUT).as_posix()
        if not file.startswith(GATES):
            for around, name in uses(path.read_text(encoding="utf-8")):
                places.setdefault(f"{file} {around} {name}", []).append(name)
    return places


def test_nobody_but_the_gates_opens_writes_or_starts_anything() -> None:
    assert sorted(found().keys() - EXCEPTIONS.keys()) == [], "use urdfctl/output and urdfctl/source/disk/files.py"


def test_each_exception_is_still_there() -> None:
    assert sorted(EXCEPTIONS.keys() - found().keys()) == []


@pytest.mark.parametrize(
    ("code", "wanted"),
    [
        ("open('a')", "open"),
        ("def f():\n    with open('a') as file: pass", "open"),
        ("use(opener=open)", "open"),
        ("import os\nos.open('a', 0)", "os.open"),
        ("import os as system\nsystem.replace('a', 'b')", "os.replace"),
        ("from os import unlink as gone\ngone('a')", "os.unlink"),
        ("def f():\n    import shutil\n    shutil.rmtree('a')", "shutil.rmtree"),
        ("from tempfile import TemporaryDirectory\nTemporaryDirectory()", "tempfile.TemporaryDirectory"),
        ("import tempfile\ndef f() -> tempfile.TemporaryDirectory[str]: ...", "tempfile.TemporaryDirectory"),
        ("import subprocess\nsubprocess.run(['git'])", "subprocess.run"),
        (
            "import asyncio\nasync def f(): await asyncio.create_subprocess_exec('git')",
            "asyncio.create_subprocess_exec",
        ),
        ("import os\nos.execv('a', [])", "os.execv"),
        ("import urllib.request\nurllib.request.urlopen('a')", "urllib.request.urlopen"),
        ("from pathlib import Path\nPath('a').read_text()", ".read_text"),
        ("def f(path): path.parent.mkdir()", ".mkdir"),
        ("print(open('a').read())", "open"),
    ],
)
def test_each_way_to_open_write_or_start_something_is_seen(code: str, wanted: str) -> None:
    assert [name for _, name in uses(code)] == [wanted]


@pytest.mark.parametrize(
    "code",
    [
        "import os\nos.path.exists('a')\nos.listdir('.')\nos.stat('a')",
        "'a'.replace('a', 'b')",
        "import subprocess\nstatus = subprocess.PIPE",
        "import shutil\nshutil.which('git')",
        "from urdfctl.output.writing import write_file\nwrite_file('a', 'b', force=True)",
        "open = 1",
        "import os\nconnector = thing.open",
    ],
)
def test_what_only_looks_like_it_is_not(code: str) -> None:
    assert list(uses(code)) == []
