"""A git repository that a stranger wrote runs nothing, fetches nothing, and writes nowhere but where it is laid out."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest
from folder import Folder
from watched import watched

from urdfctl.compare.revisions import lay_out
from urdfctl.errors import UserError
from urdfctl.source.disk.files import MAX_BYTES

ROBOT = '<robot name="r"><link name="base"/></robot>\n'
CANARY = "CANARY-5f1d"
FILE, PROGRAM, LINK, TREE, MODULE = "100644", "100755", "120000", "40000", "160000"
needs_posix = pytest.mark.skipif(os.name != "posix", reason="links and programs are made as POSIX makes them")


def git(folder: Path, *words: str, text: bytes = b"") -> str:
    own = ["-c", "user.name=n", "-c", "user.email=n@n", "-c", "protocol.file.allow=always"]
    ran = subprocess.run(["git", *own, *words], cwd=folder, input=text, capture_output=True, check=True)
    return ran.stdout.decode().strip()


def append(path: Path, text: str) -> None:
    path.write_text(path.read_text() + text)


class Repository:
    """A repository of objects that git itself would not make."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        git(folder, "init", "-q", "-b", "main")

    def object(self, kind: str, data: bytes) -> str:
        return git(self.folder, "hash-object", "-t", kind, "-w", "--literally", "--stdin", text=data)

    def tree(self, *entries: tuple[str, str, str]) -> str:
        """Entries have a mode, a name, and the content of a file or the hash of a tree or commit."""
        data = b""
        for mode, name, content in entries:
            key = content if mode in (TREE, MODULE) else self.object("blob", content.encode())
            data += f"{mode} {name}\0".encode() + bytes.fromhex(key)
        return self.object("tree", data)

    def commit(self, *entries: tuple[str, str, str]) -> None:
        """Make HEAD a commit of these, and the work tree a plain robot."""
        made = self.object("commit", f"tree {self.tree(*entries)}\nauthor n <n> 0 +0000\n\nx\n".encode())
        (self.folder / ".git" / "refs" / "heads" / "main").write_text(f"{made}\n")
        (self.folder / "r.urdf").write_text(ROBOT)


@pytest.fixture
def repository(folder: Folder) -> Repository:
    return Repository(folder.path / "pull")


GOOD = (FILE, "r.urdf", ROBOT)


@pytest.mark.parametrize("name", ["victim.png", "victim.zip", "victim.urdf"])
@pytest.mark.parametrize("way", ["..", "../.."])
def test_no_name_of_a_revision_leads_out_of_its_folder(repository: Repository, name: str, way: str) -> None:
    laid_out = repository.folder.parent / "a" / "b"
    laid_out.mkdir(parents=True)
    for place in (laid_out.parent, laid_out.parent.parent):
        (place / name).write_text(CANARY)
    entry = (FILE, name, "")
    for part in way.split("/"):
        entry = (TREE, part, repository.tree(entry))
    repository.commit(entry, GOOD)
    with pytest.raises(UserError, match=r"has a file with the name '[./]+victim"):
        lay_out(str(repository.folder), "HEAD", str(laid_out))
    assert [(place / name).read_text() for place in (laid_out.parent, laid_out.parent.parent)] == [CANARY] * 2


@pytest.mark.parametrize("name", [".git", ".GIT", "."])
def test_a_name_that_is_none_is_refused(repository: Repository, name: str) -> None:
    repository.commit((TREE, name, repository.tree((FILE, "config", "x"))), GOOD)
    ran = Folder(repository.folder).run("diff", "HEAD:r.urdf", "r.urdf")
    assert ran.returncode == 2
    assert "which is not written" in ran.stderr


def test_what_git_cannot_read_is_an_error_in_one_line(repository: Repository) -> None:
    repository.commit((FILE, "", ROBOT))
    ran = Folder(repository.folder).run("diff", "HEAD:r.urdf", "r.urdf")
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: git fails: fatal: empty filename in tree entry\n")


@needs_posix
def test_nothing_is_written_through_a_link_of_a_revision(repository: Repository) -> None:
    outside = repository.folder.parent / "home"
    outside.mkdir()
    repository.commit((LINK, "d", str(outside)), (TREE, "d", repository.tree((FILE, "x.urdf", ROBOT))), GOOD)
    ran = Folder(repository.folder).run("diff", "HEAD:r.urdf", "r.urdf")
    assert (ran.returncode, ran.stderr.count("\n")) == (2, 1)
    assert "cannot be laid out: File exists" in ran.stderr
    assert list(outside.iterdir()) == []


@needs_posix
def test_two_files_of_one_name_are_no_revision(repository: Repository) -> None:
    repository.commit(GOOD, GOOD)
    assert "cannot be laid out: File exists" in Folder(repository.folder).run("diff", "HEAD:", "r.urdf").stderr


INCLUDE = (
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="l"/><link name="a"/></robot>'
)


@needs_posix
@pytest.mark.parametrize(
    "links",
    [
        {"l": "{home}/secret"},
        {"l": "../../../../../../../../../../../../{home}/secret"},
        {"here": ".", "l": "here/here/../../../home/secret"},
        {"up": "..", "l": "up/secret"},
    ],
    ids=str,
)
def test_no_link_of_a_revision_leads_out_of_its_folder(repository: Repository, links: Mapping[str, str]) -> None:
    home = repository.folder.parent / "home"
    home.mkdir()
    (home / "secret").write_text(f"<robot><link name='{CANARY}'/></robot>")
    laid_out = repository.folder.parent / "laid" / "out"
    laid_out.mkdir(parents=True)
    places = [(LINK, name, to.replace("{home}", str(home))) for name, to in links.items()]
    repository.commit(*places, (FILE, "r.xacro", INCLUDE))
    lay_out(str(repository.folder), "HEAD", str(laid_out))
    left = [path for path in laid_out.rglob("*") if path.is_symlink()]
    assert [path for path in left if not path.resolve().is_relative_to(laid_out)] == []
    (repository.folder / "r.xacro").write_text(INCLUDE)
    seen = watched(["diff", "HEAD:r.xacro", "r.xacro"], repository.folder, repository.folder.parent / "scratch")
    assert seen.read_in(home) | seen.looked_at_in(home) == set()
    assert CANARY not in seen.ran.stdout + seen.ran.stderr


@needs_posix
def test_links_within_a_revision_and_files_that_are_not_read_are_laid_out(repository: Repository) -> None:
    sub = repository.tree((FILE, "part.xacro", "<robot/>"), (LINK, "up", "../r.urdf"))
    large = "x" * (MAX_BYTES + 1)
    repository.commit(
        GOOD,
        (FILE, "large.urdf", large),
        (LINK, "l.urdf", "sub/part.xacro"),
        (LINK, "mesh.stl", "elsewhere.stl"),
        (PROGRAM, "run", "#!/bin/sh\n"),
        (FILE, "shape.dae", "not read"),
        (TREE, "sub", sub),
        (MODULE, "vendor", "1" * 40),
    )
    folder = repository.folder.parent / "laid"
    folder.mkdir()
    lay_out(str(repository.folder), "HEAD", str(folder))
    assert (folder / "r.urdf").read_text() == ROBOT
    assert (folder / "l.urdf").read_text() == "<robot/>"
    assert (folder / "sub" / "up").read_text() == ROBOT
    assert (folder / "run").read_text() == "#!/bin/sh\n"
    assert [(folder / name).read_bytes() for name in ("mesh.stl", "shape.dae")] == [b"", b""]
    assert (folder / "large.urdf").stat().st_size == MAX_BYTES + 1
    assert list((folder / "vendor").iterdir()) == []


def test_a_revision_whose_files_are_elsewhere_is_an_error_in_one_line(repository: Repository) -> None:
    repository.commit((FILE, "r.urdf", ROBOT.replace("base", "other")))
    key = repository.object("blob", ROBOT.replace("base", "other").encode())
    path = repository.folder / ".git" / "objects" / key[:2] / key[2:]
    path.chmod(0o600)
    path.unlink()
    ran = Folder(repository.folder).run("diff", "HEAD:", "r.urdf")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr == "urdfctl: git revision 'HEAD' cannot be read: 'r.urdf' is not in the repository\n"


def test_a_tree_of_trees_without_end_is_not_listed_to_its_end(repository: Repository) -> None:
    tree = repository.tree(*((FILE, f"f{number}", "") for number in range(10)))
    for _ in range(12):
        tree = repository.tree(*((TREE, f"d{number}", tree) for number in range(10)))
    repository.commit((TREE, "d", tree), GOOD)
    ran = Folder(repository.folder).run("diff", "HEAD:r.urdf", "r.urdf")
    assert ran.returncode == 2
    assert "has more than 200000 files" in ran.stderr


PROGRAMS = """
[core]
    fsmonitor = {run}
    hooksPath = {hooks}
    sshCommand = {run}
    pager = {run}
    askPass = {run}
    gitProxy = {run}
    alternateRefsCommand = {run}
[filter "f"]
    clean = {run}
    smudge = {run}
    process = {run}
    required = true
[diff "d"]
    textconv = {run}
    command = {run}
[diff]
    external = {run}
[alias]
    status = !{run}
    ls-tree = !{run}
    cat-file = !{run}
[gpg]
    program = {run}
[log]
    showSignature = true
[credential]
    helper = !{run}
[remote "origin"]
    url = ext::{run}
    promisor = true
    uploadpack = {run}
    partialclonefilter = blob:none
[extensions]
    partialClone = origin
[uploadpack]
    packObjectsHook = {run}
[protocol]
    allow = always
"""


@needs_posix
@pytest.mark.parametrize(
    "words",
    [["diff", "HEAD:r.urdf", "r.urdf"], ["diff", "HEAD:", "."], ["migrate", ".", "--to", "jazzy", "--in-place"]],
)
@pytest.mark.parametrize("is_missing", [False, True], ids=["whole", "with a missing object"])
def test_no_program_of_a_repository_is_run(repository: Repository, words: list[str], is_missing: bool) -> None:
    folder, ran = repository.folder, repository.folder.parent / "ran"
    script = repository.folder.parent / "run"
    script.write_text(f"#!/bin/sh\necho $0 $@ >> {ran}\ncat\n")
    script.chmod(0o755)
    hooks = repository.folder.parent / "hooks"
    hooks.mkdir()
    for name in ("post-checkout", "post-index-change", "fsmonitor-watchman", "reference-transaction", "pre-auto-gc"):
        (hooks / name).write_text(script.read_text())
        (hooks / name).chmod(0o755)
    (folder / "package.xml").write_text("<package><name>p</name></package>\n")
    (folder / "r.urdf").write_text(ROBOT)
    git(folder, "add", "package.xml", "r.urdf")
    git(folder, "commit", "-q", "-m", "x")
    (folder / ".gitattributes").write_text("* filter=f diff=d\n")
    key = git(folder, "rev-parse", "HEAD:r.urdf")
    if is_missing:
        path = folder / ".git" / "objects" / key[:2] / key[2:]
        path.chmod(0o600)
        path.unlink()
    append(folder / ".git" / "config", PROGRAMS.format(run=script, hooks=hooks))
    os.utime(folder / "r.urdf", (1, 1))  # git looks at its content again
    done = Folder(folder).run(*words)
    assert done.returncode in {0, 1, 2}, done.stderr
    assert not ran.exists(), ran.read_text()


@needs_posix
def test_a_repository_within_the_files_of_another_one_is_not_asked(folder: Folder) -> None:
    """A stranger may commit the files of a bare repository, with a configuration."""
    outer = Repository(folder.path / "pull")
    bare = outer.folder / "bare"
    git(outer.folder, "init", "-q", "--bare", str(bare))
    script, ran = folder.path / "run", folder.path / "ran"
    script.write_text(f"#!/bin/sh\necho $0 >> {ran}\n")
    script.chmod(0o755)
    append(bare / "config", f"[core]\n\tfsmonitor = {script}\n\tworktree = .\n\tbare = false\n")
    (bare / "package.xml").write_text("<package><name>p</name></package>\n")
    (bare / "r.urdf").write_text(ROBOT)
    done = Folder(bare).run("migrate", ".", "--to", "jazzy", "--in-place")
    assert done.returncode in {0, 1, 2}, done.stderr
    assert not ran.exists()


def test_a_change_that_is_not_committed_is_still_seen(folder: Folder) -> None:
    inner = Repository(folder.path)
    folder.write({"package.xml": "<package><name>p</name></package>\n", "r.urdf": ROBOT})
    git(inner.folder, "add", ".")
    git(inner.folder, "commit", "-q", "-m", "x")
    assert "not committed" not in folder.run("migrate", ".", "--to", "jazzy", "--in-place").stderr
    folder.write({"r.urdf": ROBOT.replace("base", "other")})
    assert "has changes that are not committed" in folder.run("migrate", ".", "--to", "jazzy", "--in-place").stderr
