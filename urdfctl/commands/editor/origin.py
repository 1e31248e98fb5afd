"""Where this urdfctl was installed from: what a pipeline elsewhere has to install to get the same."""

from __future__ import annotations

import json
import os
import re
from importlib.metadata import PackageNotFoundError, distribution
from typing import Any

from urdfctl import __version__
from urdfctl.errors import UserError
from urdfctl.run.git import commit_of, remote_of, repository_of
from urdfctl.startup.records import NamedTuple

_GITHUB = re.compile(r"(?:https://|git@|ssh://git@)github\.com[:/](?P<account>[\w.-]+)/(?P<name>[\w.-]+?)(?:\.git)?/?$")


class Origin(NamedTuple):
    """Where urdfctl comes from.

    requirement: what pip installs.
    account: the account at GitHub that owns the repository, if it is known.
    lacks: what does not exist, so that the requirement cannot be installed; empty if it can.
    """

    requirement: str
    account: str | None = None
    lacks: str = ""


def origin() -> Origin:
    """Return where this urdfctl was installed from: a release, a repository, or a folder with or without a remote."""
    said = _direct_url()
    if said is None:
        return Origin(f"urdfctl=={__version__}")
    url, commit = str(said.get("url", "")), (said.get("vcs_info") or {}).get("commit_id")
    if commit is None:
        url, commit = _remote()
    known = _GITHUB.match(url)
    if known and commit:
        place = f"https://github.com/{known['account']}/{known['name']}"
        lacks = "" if "vcs_info" in said else f"commit {commit[:10]} at {place} (push it)"
        return Origin(f"urdfctl @ git+{place}@{commit}", known["account"], lacks)
    return Origin(f"urdfctl=={__version__}", None, f"a release {__version__} of urdfctl at the package index")


def _direct_url() -> dict[str, Any] | None:
    """What pip wrote of a package that is not from an index (PEP 610)."""
    try:
        text = distribution("urdfctl").read_text("direct_url.json")
        said = json.loads(text) if text else None
    except (PackageNotFoundError, ValueError):
        return {}
    return said if isinstance(said, dict) else None


def _remote() -> tuple[str, str | None]:
    """The remote of the repository that this file is in, and its commit."""
    try:
        repository = repository_of(os.path.dirname(os.path.abspath(__file__)))
        return remote_of(repository), commit_of(repository, "HEAD")
    except UserError:
        return "", None
