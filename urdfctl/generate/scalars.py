"""How values are written so that their readers read them as they are meant: YAML, XML, xacro and Python."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence

_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_./-]*")
_WORDS = frozenset({"y", "n", "yes", "no", "on", "off", "true", "false", "null", "none", "nan", "inf", "infinity"})


def yaml_value(value: object) -> str:
    """A value in YAML's flow form, on one line; texts that YAML or ROS would take for something else are quoted."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return yaml_float(value)
    if isinstance(value, str):
        return yaml_text(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{yaml_text(str(key))}: {yaml_value(part)}" for key, part in value.items()) + "}"
    if isinstance(value, Sequence):
        return "[" + ", ".join(map(yaml_value, value)) + "]"
    return str(value)


def yaml_text(text: str) -> str:
    """A text as it stands where every reader takes it for that text, else between quotes."""
    if _PLAIN.fullmatch(text) and text.lower() not in _WORDS:
        return text
    if text.isprintable():
        return json.dumps(text, ensure_ascii=False)
    import yaml

    quoted: str = yaml.safe_dump(text, default_style='"', allow_unicode=True, width=1 << 30)
    return quoted.strip()


def yaml_float(value: float) -> str:
    """A number with a decimal point, as ROS 2 wants a double; never `1e-05`, which YAML 1.1 takes for a text."""
    if not math.isfinite(value):
        return ".nan" if math.isnan(value) else ".inf" if value > 0 else "-.inf"
    text = repr(value)
    if "e" in text:
        digits, _, exponent = text.partition("e")
        return f"{digits if '.' in digits else digits + '.0'}e{int(exponent):+03d}"
    return text


def xml_text(text: object) -> str:
    """A text for an attribute between double quotes, or between tags, of plain XML."""
    escaped = str(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
    return "".join(f"&#{ord(c)};" if c in "\t\n\r" else c for c in escaped)


def xacro_text(text: object) -> str:
    """The same for xacro: `${` and `$(` stay what they are, for xacro takes one dollar of several."""
    return re.sub(r"\$+(?=[{(])", r"$\g<0>", xml_text(text))


def python_text(text: object) -> str:
    """A literal of Python, between double quotes."""
    return json.dumps(str(text), ensure_ascii=not str(text).isprintable())


def one_line(text: str) -> str:
    """A text for a comment of YAML or Python: without line ends, and what cannot be printed."""
    return "".join(c if c.isprintable() else " " for c in text)


def xml_comment(text: str) -> str:
    """A text for a comment of XML, which may not hold two dashes in a row: a zero-width space keeps them apart."""
    return re.sub(r"-(?=-)", "-\u200b", one_line(text))
