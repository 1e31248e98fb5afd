"""Steps from Gazebo Classic to gz: those for robots, then those for the packages around them."""

from __future__ import annotations

from urdfctl.migrate.classic.bridge import BRIDGE
from urdfctl.migrate.classic.bridge_install import BRIDGE_INSTALL
from urdfctl.migrate.classic.build_files import BUILD_FILES
from urdfctl.migrate.classic.comments import COMMENTS
from urdfctl.migrate.classic.environment import ENVIRONMENT, MODEL_PATHS
from urdfctl.migrate.classic.gone_packages import GONE_PACKAGES
from urdfctl.migrate.classic.inertias import INERTIAS
from urdfctl.migrate.classic.initial_positions import INITIAL_POSITIONS
from urdfctl.migrate.classic.launch_python import CLASSIC_LAUNCH
from urdfctl.migrate.classic.launch_xml import CLASSIC_LAUNCH_XML
from urdfctl.migrate.classic.loose_sensors import LOOSE_SENSORS
from urdfctl.migrate.classic.manifest import CLASSIC_MANIFEST
from urdfctl.migrate.classic.materials import CLASSIC_MATERIALS
from urdfctl.migrate.classic.migrated_launch import MIGRATED_LAUNCH
from urdfctl.migrate.classic.model_systems import MODEL_SYSTEMS
from urdfctl.migrate.classic.multicamera import MULTICAMERA
from urdfctl.migrate.classic.plugins import CLASSIC_HARDWARE, CLASSIC_INTERFACES, CLASSIC_PLUGINS, CONTROL_PLUGIN
from urdfctl.migrate.classic.sensor_systems import SENSOR_SYSTEMS
from urdfctl.migrate.classic.sensors import CLASSIC_SENSORS
from urdfctl.migrate.classic.worlds import WORLD_MODELS, WORLD_PLUGINS
from urdfctl.migrate.step import Step

ROBOT_STEPS: tuple[Step, ...] = (
    CONTROL_PLUGIN,
    CLASSIC_HARDWARE,
    CLASSIC_INTERFACES,
    CLASSIC_PLUGINS,
    MULTICAMERA,
    CLASSIC_SENSORS,
    LOOSE_SENSORS,
    SENSOR_SYSTEMS,
    MODEL_SYSTEMS,
    CLASSIC_MATERIALS,
    WORLD_MODELS,
    WORLD_PLUGINS,
    INITIAL_POSITIONS,
    BRIDGE,
    INERTIAS,
    COMMENTS,
)
PACKAGE_STEPS: tuple[Step, ...] = (
    MIGRATED_LAUNCH,
    CLASSIC_LAUNCH,
    CLASSIC_LAUNCH_XML,
    GONE_PACKAGES,
    ENVIRONMENT,
    CLASSIC_MANIFEST,
    BUILD_FILES,
    MODEL_PATHS,
    BRIDGE_INSTALL,
)
STEPS: tuple[Step, ...] = (*ROBOT_STEPS, *PACKAGE_STEPS)
