"""Packages for humble, and what they are migrated to."""

from __future__ import annotations

import textwrap

from folder import Folder

MANIFEST = '<package format="3"><name>arm</name><exec_depend>ros_ign_gazebo</exec_depend></package>\n'
MANAGED = """\
controller_manager:
  ros__parameters:
    update_rate: 100  # Hz
    ctl: {type: TYPE}
ctl:
  ros__parameters:
"""


def controllers(kind: str, parameters: str) -> str:
    """A controller file with one controller."""
    return MANAGED.replace("TYPE", kind) + textwrap.indent(textwrap.dedent(parameters), "    ")


def migrated(folder: Folder, files: dict[str, str], *words: str) -> dict[str, str]:
    """The files of a package after its migration."""
    folder.write({"arm/package.xml": MANIFEST, **{f"arm/{name}": text for name, text in files.items()}})
    ran = folder.run("migrate", "arm", *words, "-o", "new", "--force")
    assert ran.returncode == 0, ran.stderr
    return {name: (folder.path / "new" / name).read_text() for name in files}


HUMBLE = ("--from", "humble")
