"""UC8: what is wrong in a running system, as `urdfctl doctor` finds it in a recording.

The checks in `urdfctl.doctor.checks` find them, and give the facts of their messages.
"""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.running.clock_stands_still import clock_stands_still
from urdfctl.rules.running.command_topic_not_read import command_topic_not_read
from urdfctl.rules.running.description_not_received import description_not_received
from urdfctl.rules.running.hardware_not_loaded import hardware_not_loaded
from urdfctl.rules.running.joint_states_incomplete import joint_states_incomplete
from urdfctl.rules.running.joint_states_not_finite import joint_states_not_finite
from urdfctl.rules.running.joint_states_not_read import joint_states_not_read
from urdfctl.rules.running.joint_states_stand_still import joint_states_stand_still
from urdfctl.rules.running.joint_states_too_slow import joint_states_too_slow
from urdfctl.rules.running.manager_not_running import manager_not_running
from urdfctl.rules.running.manager_without_types import manager_without_types
from urdfctl.rules.running.no_joint_states import no_joint_states
from urdfctl.rules.running.node_runs_twice import node_runs_twice
from urdfctl.rules.running.running_controller_not_active import running_controller_not_active
from urdfctl.rules.running.running_controller_not_in_files import running_controller_not_in_files
from urdfctl.rules.running.running_controller_not_loaded import running_controller_not_loaded
from urdfctl.rules.running.running_hardware_differs import running_hardware_differs
from urdfctl.rules.running.running_hardware_not_active import running_hardware_not_active
from urdfctl.rules.running.running_parameter_differs import running_parameter_differs
from urdfctl.rules.running.running_part_missing import running_part_missing
from urdfctl.rules.running.running_type_differs import running_type_differs
from urdfctl.rules.running.running_type_unknown import running_type_unknown
from urdfctl.rules.running.running_value_differs import running_value_differs
from urdfctl.rules.running.simulation_time_mixed import simulation_time_mixed
from urdfctl.rules.running.spawner_waits import spawner_waits
from urdfctl.rules.running.state_publisher_not_running import state_publisher_not_running
from urdfctl.rules.running.topic_qos_incompatible import topic_qos_incompatible
from urdfctl.rules.running.topic_types_differ import topic_types_differ
from urdfctl.rules.running.transform_has_two_parents import transform_has_two_parents
from urdfctl.rules.running.transform_is_stale import transform_is_stale
from urdfctl.rules.running.transform_sent_twice import transform_sent_twice
from urdfctl.rules.running.two_joint_state_publishers import two_joint_state_publishers

FAULTS: tuple[Fault, ...] = (
    manager_not_running,
    description_not_received,
    hardware_not_loaded,
    clock_stands_still,
    simulation_time_mixed,
    state_publisher_not_running,
    spawner_waits,
    manager_without_types,
    running_part_missing,
    running_hardware_differs,
    running_value_differs,
    running_hardware_not_active,
    running_controller_not_loaded,
    running_type_unknown,
    running_controller_not_active,
    running_controller_not_in_files,
    running_parameter_differs,
    running_type_differs,
    no_joint_states,
    joint_states_incomplete,
    two_joint_state_publishers,
    joint_states_not_read,
    joint_states_not_finite,
    joint_states_too_slow,
    joint_states_stand_still,
    command_topic_not_read,
    topic_types_differ,
    topic_qos_incompatible,
    node_runs_twice,
    transform_has_two_parents,
    transform_sent_twice,
    transform_is_stale,
)
