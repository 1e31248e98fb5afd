"""$(find pkg) without ROS: install prefixes made of links into a folder of sources.

xacro asks ament_index_python for a package. It gets a module of that name that does as little as possible (the real one
is slower); urdfctl gets no such help.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from race.process import environment

AMENT = '''"""As much of ament_index_python as xacro asks for."""
import os


def get_package_share_directory(package):
    for prefix in os.environ["AMENT_PREFIX_PATH"].split(os.pathsep):
        if os.path.exists(os.path.join(prefix, "share", "ament_index", "resource_index", "packages", package)):
            return os.path.join(prefix, "share", package)
    raise KeyError(f"package '{package}' not found")
'''


class Packages:
    """The packages below a folder, as xacro finds them."""

    def __init__(self, corpus: Path, temp: Path) -> None:
        self.temp = temp
        self.overlays: dict[tuple[Path, ...], Path] = {}
        found: dict[str, list[Path]] = {}
        for folder, name in packages_below(corpus):
            found.setdefault(name, []).append(folder)
        self.twice = {name: folders for name, folders in sorted(found.items()) if len(folders) > 1}
        self.common = self.prefix("common", {n: f[0] for n, f in found.items() if len(f) == 1})
        module = temp / "python" / "ament_index_python"
        module.mkdir(parents=True)
        (module / "__init__.py").touch()
        (module / "packages.py").write_text(AMENT)

    def prefix(self, name: str, packages: Mapping[str, Path]) -> Path:
        share = self.temp / name / "share"
        marks = share / "ament_index" / "resource_index" / "packages"
        marks.mkdir(parents=True)
        for package, folder in packages.items():
            (share / package).symlink_to(folder, target_is_directory=True)
            (marks / package).touch()
        return self.temp / name

    def environment(self, file: Path) -> dict[str, str]:
        """For one robot; where a name occurs more than once, the package nearest to the robot is the one."""
        nearest = {name: max(folders, key=lambda f: shared_parts(f, file)) for name, folders in self.twice.items()}
        key = tuple(nearest.values())
        if key not in self.overlays:
            self.overlays[key] = self.prefix(f"overlay{len(self.overlays)}", nearest)
        python = [str(self.temp / "python"), *filter(None, [os.environ.get("PYTHONPATH")])]
        prefixes = os.pathsep.join([str(self.overlays[key]), str(self.common)])
        return environment(AMENT_PREFIX_PATH=prefixes, PYTHONPATH=os.pathsep.join(python))


def packages_below(corpus: Path) -> Iterable[tuple[Path, str]]:
    for folder, below, files in os.walk(corpus):
        below[:] = sorted(name for name in below if not name.startswith(".") and name != "known_bad")
        if "package.xml" in files:
            text = Path(folder, "package.xml").read_text(encoding="utf-8", errors="replace")
            if match := re.search(r"<name>\s*([^<\s]+)\s*</name>", text):
                yield Path(folder), match[1]


def shared_parts(one: Path, other: Path) -> int:
    return len(Path(os.path.commonpath([one, other])).parts)
