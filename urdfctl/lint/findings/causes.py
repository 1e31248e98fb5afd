"""Leave out findings that another finding of the same project explains: a fault is reported once, by its cause."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from urdfctl.diagnostic import Diagnostic, Remark
from urdfctl.startup.records import NamedTuple

Explains = Callable[[Diagnostic, Diagnostic], bool]
"""Whether a cause, the first finding, explains the second."""
EXPLAINS = "this explains "
"""How the note of a cause on the findings that it explains begins."""


def at_its_place(cause: Diagnostic, finding: Diagnostic) -> bool:
    """Return whether two findings are at places that overlap."""
    one, other = cause.at, finding.at
    return one.file == other.file and one.start <= other.end and other.start <= one.end


def of_its_robot(_cause: Diagnostic, _finding: Diagnostic) -> bool:
    """Return True: in a robot with the cause, every such finding follows from it."""
    return True


def of_its_name(cause: Diagnostic, finding: Diagnostic) -> bool:
    """Return whether the cause, or one of its notes, mentions the first name of the finding."""
    name = _first_name(finding.message)
    told = [cause.message, *(note.message for note in cause.notes)]
    return name != "" and any(f"'{name}'" in text or f'"{name}"' in text for text in told)


def by_the_name_meant(cause: Diagnostic, finding: Diagnostic) -> bool:
    """Return whether the finding misses the name that the cause misspells: it is first in the finding, or the finding
    names it together with the part of the robot that has it in the cause."""
    meant = re.search(_MEANT, cause.message)
    if meant is None:
        return False
    return meant[1] == _first_name(finding.message) or (
        f"'{meant[1]}'" in finding.message and of_its_name(cause, finding)
    )


def in_its_line(cause: Diagnostic, finding: Diagnostic) -> bool:
    """Return whether the source line of the finding uses the first name of the cause."""
    name = _first_name(cause.message)
    return name != "" and re.search(rf"(?<!\w){re.escape(name)}(?!\w)", finding.excerpt) is not None


def between_its_parts(cause: Diagnostic, finding: Diagnostic) -> bool:
    """Return whether the finding is about two components that both have the first name of the cause."""
    return finding.message.count(f"component '{_first_name(cause.message)}'") > 1


def below_its_path(cause: Diagnostic, finding: Diagnostic) -> bool:
    """Return whether the first name of the finding is a path below one that the cause mentions."""
    path = _first_name(finding.message)
    return any(path.startswith(f"{folder}/") for folder in re.findall(_NAME, cause.message))


class CausalLink(NamedTuple):
    """The codes of a cause and of what follows from it, and how the two belong together."""

    cause: str
    consequences: tuple[str, ...]
    explains: Explains


_UNDEFINED = CausalLink("UC007", ("UC019",), of_its_name)
LINKS = (
    CausalLink("UC003", ("UC150",), of_its_name),
    _UNDEFINED,
    CausalLink("UC023", ("UC002",), below_its_path),
    CausalLink("UC028", ("UC004", "UC007"), in_its_line),
    CausalLink("UC036", ("UC465",), of_its_robot),
    CausalLink("UC117", ("UC315",), of_its_name),
    CausalLink("UC136", ("UC137",), at_its_place),
    CausalLink("UC151", ("UC149",), at_its_place),
    CausalLink("UC206", ("UC462",), by_the_name_meant),
    CausalLink("UC303", ("UC305",), at_its_place),
    CausalLink("UC310", ("UC337",), between_its_parts),
    CausalLink("UC312", ("UC450", "UC451"), by_the_name_meant),
    CausalLink("UC324", ("UC450", "UC451"), of_its_name),
    CausalLink("UC324", ("UC472",), of_its_robot),
    CausalLink("UC345", ("UC355",), at_its_place),
    CausalLink("UC345", ("UC450", "UC451"), by_the_name_meant),
    CausalLink("UC361", ("UC471", "UC513"), of_its_robot),
    CausalLink("UC436", ("UC435",), at_its_place),
    CausalLink("UC440", ("UC467",), by_the_name_meant),
    CausalLink("UC450", ("UC464",), of_its_name),
    CausalLink("UC471", ("UC021", "UC330"), of_its_robot),
    CausalLink("UC524", ("UC525",), of_its_robot),
    CausalLink("UC601", ("UC603",), of_its_robot),
)
LINKS_OF_RUN = (_UNDEFINED, *(link for link in LINKS if link.explains is at_its_place))
"""Those that also hold between the findings of several projects."""
_CONSEQUENCES = {code for link in LINKS for code in link.consequences}
_NAME = r"'([^']+)'"
_MEANT = r"did you mean '([^']+)'"


def without_consequences(findings: Sequence[Diagnostic], links: Sequence[CausalLink] = LINKS) -> Sequence[Diagnostic]:
    """Return the findings of a project without those that another one explains.

    The cause gets their severity if it is worse, and a note that counts those elsewhere.
    """
    codes = {finding.code for finding in findings}
    links = [link for link in links if link.cause in codes] if codes & _CONSEQUENCES else []
    if not links:
        return findings
    explained: dict[int, list[Diagnostic]] = {}
    left_out: set[int] = set()
    for link in links:
        causes = [(index, finding) for index, finding in enumerate(findings) if finding.code == link.cause]
        for number, finding in enumerate(findings):
            if finding.code in link.consequences and number not in left_out:
                cause = next((index for index, one in causes if link.explains(one, finding)), None)
                if cause is not None:
                    left_out.add(number)
                    explained.setdefault(cause, []).append(finding)
    return [
        _with(finding, explained[index]) if index in explained else finding
        for index, finding in enumerate(findings)
        if index not in left_out
    ]


def _with(cause: Diagnostic, consequences: Iterable[Diagnostic]) -> Diagnostic:
    consequences = list(consequences)
    worst = max((cause, *consequences), key=lambda finding: finding.severity.weight).severity
    elsewhere = Counter(one.code for one in consequences if not at_its_place(cause, one))
    counts = [f"{number} finding{'s' * (number > 1)} of {code}" for code, number in elsewhere.items()]
    notes = (Remark(f"{EXPLAINS}{' and '.join(counts)}, not shown"),) if counts else ()
    return cause._replace(severity=worst, notes=(*cause.notes, *notes))


def _first_name(message: str) -> str:
    found = re.search(_NAME, message)
    return found[1] if found else ""
