"""The pages of docs/ as they stand in the repository, with links that lead to pages of the site or to the source."""

from __future__ import annotations

import os
import re
from pathlib import Path

from texts import Pages

from urdfctl import REPOSITORY
from urdfctl.rules import all_faults
from urdfctl.rules.readme import readme

ROOT = Path(__file__).resolve().parents[2]
_LINK = re.compile(r"(\]\()([^)\s]+)(\))")
_FENCE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)
_NOT_A_PAGE = ("http://", "https://", "mailto:", "#")


def document_pages() -> Pages:
    """Return the pages of docs/, the overview of the rules, and README.md as the first page, by path."""
    files = sorted((ROOT / "docs").rglob("*.md"))
    sources = {file: file.relative_to(ROOT / "docs").as_posix() for file in files if "site" not in file.parts}
    sources |= {ROOT / "README.md": "index.md", ROOT / "CONTRIBUTING.md": "contributing.md"}
    sources |= {ROOT / "CHANGELOG.md": "changelog.md", ROOT / "SECURITY.md": "security.md"}
    sources |= {ROOT / "samples" / "README.md": "samples.md"}
    places = {str(file): path for file, path in sources.items()}
    places[str(ROOT / "urdfctl" / "rules" / "README.md")] = "rules/index.md"
    for fault in all_faults():
        places[str(ROOT / f"{fault.module.replace('.', '/')}.py")] = f"rules/{fault.code}.md"
    pages = {path: linked(file.read_text("utf-8"), file, path, places) for file, path in sources.items()}
    pages["rules/index.md"] = linked(readme(), ROOT / "urdfctl" / "rules" / "README.md", "rules/index.md", places)
    return pages


def linked(text: str, file: Path, path: str, places: dict[str, str]) -> str:
    """Return a page whose links to files lead to the site's pages, to its pictures, or to the source."""

    def there(match: re.Match[str]) -> str:
        target, mark, anchor = match[2].partition("#")
        if match[2].startswith(_NOT_A_PAGE):
            return match[0]
        named = os.path.normpath(file.parent / target)
        page = places.get(named)
        if page is None and named.startswith(f"{ROOT}/docs/") and Path(named).is_file():
            page = os.path.relpath(named, ROOT / "docs")
        if page is not None:
            way = os.path.relpath(page, os.path.dirname(path) or ".").replace(os.sep, "/")
            return f"{match[1]}{way}{mark}{anchor}{match[3]}"
        kind = "tree" if Path(named).is_dir() else "blob"
        return f"{match[1]}{REPOSITORY}/{kind}/main/{os.path.relpath(named, ROOT)}{mark}{anchor}{match[3]}"

    parts, end = [], 0
    for code in _FENCE.finditer(text):
        parts += [_LINK.sub(there, text[end : code.start()]), code[0]]
        end = code.end()
    return "".join([*parts, _LINK.sub(there, text[end:])])
