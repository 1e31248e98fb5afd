"""Build the documentation site: `python docs/site/build.py FOLDER [--pyodide NODE_MODULES/pyodide]`.

Makes the Markdown of all pages from the code and docs/, lets Zensical write them as HTML, adds the playground, and
checks every link. Nothing is fetched: `pip install -e '.[site]'` installs what it needs before, and the folder of
the npm package pyodide must be there for the playground to run.
"""

from __future__ import annotations

import argparse
import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[2]), str(Path(__file__).resolve().parent)]

from checking import ask_nobody, problems_of  # noqa: E402
from documents import ROOT, document_pages  # noqa: E402
from faults import fault_pages  # noqa: E402
from messages import message_pages  # noqa: E402
from playground import playground_pages, write_playground  # noqa: E402
from search import write_search  # noqa: E402
from texts import Pages  # noqa: E402

from urdfctl import REPOSITORY, SITE  # noqa: E402 (the folder of the source comes first)

_HERE = Path(__file__).resolve().parent
_COMMANDS = "    # a page for each command\n"
_STYLE = "site.css"
_PICTURES = {".png", ".svg", ".gif", ".webp"}


def main() -> int:
    """Build the site, print what is wrong with it, and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--pyodide", type=Path, help="the folder of the npm package, with pyodide.mjs")
    options = parser.parse_args()
    if importlib.util.find_spec("zensical") is None:
        parser.error("Zensical is not installed: pip install -e '.[site]'")
    folder = options.folder.resolve()
    write_sources(folder)
    subprocess.run([sys.executable, "-m", "zensical", "build", "--clean"], cwd=folder, check=True)
    site = folder / "site"
    ask_nobody(site)
    if options.pyodide:
        write_playground(site / "playground", options.pyodide)
    problems = [*problems_of(site)]
    print(
        "\n".join(problems) if problems else f"{sum(1 for _ in site.rglob('*.html'))} pages in {site}, no broken link"
    )
    return 1 if problems else 0


def all_pages() -> Pages:
    """Return all pages of the site as Markdown, by path."""
    return {**document_pages(), **fault_pages(), **message_pages(), **playground_pages()}


def write_sources(folder: Path) -> None:
    """Write what Zensical reads: the pages, the pictures and its configuration with the address of the site."""
    pages = folder / "pages"
    shutil.rmtree(folder, ignore_errors=True)
    for path, text in all_pages().items():
        (pages / path).parent.mkdir(parents=True, exist_ok=True)
        (pages / path).write_text(text, "utf-8")
    for picture in (ROOT / "docs").rglob("*"):
        if picture.suffix in _PICTURES:
            there = pages / picture.relative_to(ROOT / "docs")
            there.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(picture, there)
    write_search(pages)
    shutil.copyfile(_HERE / _STYLE, pages / _STYLE)
    (pages / "robots.txt").write_text(f"User-agent: *\nAllow: /\nSitemap: {SITE}sitemap.xml\n")
    settings = (_HERE / "zensical.toml").read_text("utf-8").replace(_COMMANDS, _menu_of_commands())
    address = f'[project]\nsite_url = "{SITE}"\nrepo_url = "{REPOSITORY}"\n'
    (folder / "zensical.toml").write_text(settings.replace("[project]\n", address, 1), "utf-8")


def _menu_of_commands() -> str:
    names = sorted(page.stem for page in (ROOT / "docs" / "commands").glob("*.md"))
    return "".join(f'    {{ "{name}" = "commands/{name}.md" }},\n' for name in names)


if __name__ == "__main__":
    raise SystemExit(main())
