"""A plain URDF beside a xacro file that expands to just it: findings are told once, in the xacro file."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable

from urdfctl.lint.results import TargetResult
from urdfctl.source.disk.gate import is_file
from urdfctl.source.xml.dom import COMMENT, Element, XmlText

_ENDINGS = (".urdf.xacro", ".xacro", ".urdf")


def twin_digest(path: str, root: Element | None) -> str | None:
    """Return a digest of an expanded description if a file of the same name, plain or xacro, is beside it."""
    ending = next((ending for ending in _ENDINGS if path.endswith(ending)), "")
    stem = path.removesuffix(ending)
    others = [stem + other for other in (_ENDINGS[:2] if ending == ".urdf" else _ENDINGS[2:])]
    if root is None or not ending or not any(map(is_file, others)):
        return None
    from hashlib import blake2b

    digest = blake2b(digest_size=16)
    pending = [root]
    while pending:
        element = pending.pop()
        texts = (c.data.strip() for c in element.children() if isinstance(c, XmlText) and c.nodeType != COMMENT)
        attributes = sorted((k, v) for k, v in element.attrs.items() if not k.startswith("xmlns"))
        children = element.elements()
        facts = (element.tagName, attributes, "".join(texts), len(children))
        digest.update(repr(facts).encode("utf-8", "surrogatepass"))
        pending += children
    return digest.hexdigest()


def equal_to_xacro(results: Iterable[TargetResult]) -> set[str]:
    """Return the plain URDF files whose twin expands to the same, without arguments."""
    results = [result for result in results if result.twin]
    sources = {(os.path.dirname(r.path), r.twin) for r in results if not r.path.endswith(".urdf") and not r.arguments}
    plain = (result for result in results if result.path.endswith(".urdf"))
    return {result.path for result in plain if (os.path.dirname(result.path), result.twin) in sources}


def without_findings_in(result: TargetResult, generated: Collection[str]) -> TargetResult:
    """Return a result without the findings in some files."""
    diagnostics = [found for found in result.outcome.diagnostics if found.at.file not in generated]
    return result._replace(outcome=result.outcome._replace(diagnostics=diagnostics))
