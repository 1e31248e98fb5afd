"""Read the parameters that a ROS 1 launch file contains as the YAML that they are, at their places in it."""

from __future__ import annotations

import re

from urdfctl.model.launch import InlineParameters
from urdfctl.source.yaml.tree import Mapping, Scalar, YamlEntry, YamlFile, read_yaml_in

_CDATA = re.compile(rb"<!\[CDATA\[|\]\]>")


def inline_tree(inline: InlineParameters) -> YamlFile:
    """Return the tree of contained parameters, as a file with nothing else in it would have it."""
    source, span = inline.at.source, inline.at.span
    if inline.name and "\n" not in span.text.strip() and not span.text.lstrip().startswith(("[", "{")):
        name = Scalar(text=inline.name, style="", tag=None, source=source, start=span.start, end=span.end)
        value = Scalar(text=span.text.strip(), style="", tag=None, source=source, start=span.start, end=span.end)
        document = Mapping((YamlEntry(name, value),), None, source, span.start, span.end)
        return YamlFile(source, (document,), (), ())
    text = _CDATA.sub(lambda mark: b" " * len(mark[0]), source.data[span.start : span.end])
    start = source.line_starts()[source.position(span.start).line - 1]
    read = read_yaml_in(source, start, b" " * (span.start - start) + text)
    if not inline.name or not read.documents:
        return read
    name = Scalar(text=inline.name, style="", tag=None, source=source, start=span.start, end=span.start)
    document = Mapping((YamlEntry(name, read.documents[0]),), None, source, span.start, span.end)
    return read._replace(documents=(document,))
