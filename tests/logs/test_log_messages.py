"""The messages of ROS and Gazebo: their data is valid, and each pattern matches only its own entry."""

from __future__ import annotations

import re

from urdfctl.catalog.log_messages import KINDS, log_messages
from urdfctl.logs.index import index
from urdfctl.logs.pattern import filled, found_in, parsed
from urdfctl.rules import all_faults

MESSAGES = log_messages()


def test_every_message_has_a_meaning_causes_and_a_fix() -> None:
    for message in MESSAGES:
        assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", message.id)
        assert message.kind in KINDS, message.id
        assert message.distros, message.id
        assert message.authority, message.id
        if message.kind == "progress":
            continue
        assert message.meaning.endswith((".", ")")), message.id
        assert message.fix, message.id
        assert message.causes or message.kind == "harmless", message.id


def test_every_rule_that_a_cause_names_exists() -> None:
    codes = {rule.code for rule in all_faults()}
    assert [(message.id, code) for message in MESSAGES for code in message.rules if code not in codes] == []


def test_the_texts_of_a_message_use_only_values_that_it_prints() -> None:
    for message in MESSAGES:
        printed = {gap.name for pattern in message.patterns for gap in parsed(pattern).gaps}
        given = {"debian"} if "package" in printed else set()
        texts = [message.meaning, message.fix, *(cause.text for cause in message.causes if not cause.only_if)]
        assert {gap.name for text in texts for gap in parsed(text).gaps} <= printed | given, message.id


def test_a_cause_with_a_condition_uses_only_values_that_the_message_prints_or_that_the_condition_gives() -> None:
    for message in MESSAGES:
        printed = {gap.name for pattern in message.patterns for gap in parsed(pattern).gaps}
        for cause in message.causes:
            given = {"meant"} if " near " in cause.only_if else set()
            used = {gap.name for text in (cause.text, cause.fix) for gap in parsed(text).gaps}
            given |= {"debian"} if "package" in printed else set()
            assert used <= printed | given, (message.id, cause.text)


def test_the_conditions_of_causes_are_well_formed_and_name_known_messages_and_values() -> None:
    ids = {message.id for message in MESSAGES}
    for message in MESSAGES:
        printed = {gap.name for pattern in message.patterns for gap in parsed(pattern).gaps}
        assert {*message.settles, *message.ends} <= ids, message.id
        for condition in (one for cause in message.causes for one in (cause.first_if, cause.only_if) if one):
            for clause in re.split(r" and | or ", condition):
                name, relation, *rest = clause.strip().removeprefix("not ").split(" ", 2)
                if name == "seen":
                    assert relation in ids, clause
                else:
                    assert name in printed, (message.id, clause)
                    assert relation in {"~", "in", "near", "only", "known"}, clause
                    assert relation == "known" or re.compile(rest[0])


def test_each_pattern_matches_in_a_log_line_and_only_for_its_own_entry() -> None:
    for spelling in index().spellings:
        printed = "elbow".join(spelling.pattern.literals)
        hits = index().hits(f"[ros2_control_node-1] [ERROR] [1699.9] [controller_manager]: {printed}")
        assert [hit.message.id for hit in hits] == [spelling.message.id], printed


def test_no_pattern_is_duplicated() -> None:
    texts = [spelling.pattern.shown for spelling in index().spellings]
    assert sorted(texts) == sorted(set(texts))


def test_the_values_of_a_message_are_those_between_its_literals() -> None:
    pattern = parsed("Transmission '{transmission}' of '{hardware}' has {count:word} joints in {what}")
    match = found_in(pattern, "[x]: Transmission 't1' of 'arm' has 2 joints in all of it")
    assert match is not None
    assert match.values == {"transmission": "t1", "hardware": "arm", "count": "2", "what": "all of it"}
    assert found_in(pattern, "Transmission 't1' of 'arm' has 2 or 3 joints in it") is None


def test_a_value_at_the_beginning_is_the_word_before() -> None:
    match = found_in(parsed("{joint:word} couldn't be retrieved"), "[ERROR] [1.2]: left_wheel couldn't be retrieved")
    assert match is not None
    assert match.values == {"joint": "left_wheel"}


def test_the_first_value_is_the_shortest_possible() -> None:
    match = found_in(parsed("joint '{joint}' is bad"), "joint 'a' is good, joint 'b' is bad")
    assert match is not None
    assert match.values == {"joint": "b"}


def test_printed_braces_are_not_values() -> None:
    pattern = parsed("parameter {{{parameter}}} is of type {{{type}}}")
    match = found_in(pattern, "parameter {use_sim_time} is of type {bool}")
    assert match is not None
    assert match.values == {"parameter": "use_sim_time", "type": "bool"}
    assert filled("{{p: {parameter}}} {other}", match.values) == "{p: use_sim_time} …"
