"""The schema of a graph as JSON."""

from __future__ import annotations

import json
from importlib.resources import files

SCHEMA = json.loads(files("urdfctl.graph").joinpath("graph.schema.json").read_text(encoding="utf-8"))
