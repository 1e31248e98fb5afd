#!/usr/bin/env bash
# Runs the tests of doctor and of smoke --engine ros2 on real controller managers, in an official image of ROS 2.
set -eo pipefail
apt-get update -qq
DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends python3-venv \
  "ros-$ROS_DISTRO-ros2-control" "ros-$ROS_DISTRO-ros2-controllers" "ros-$ROS_DISTRO-robot-state-publisher" >/dev/null
cp -r /urdfctl /tmp/urdfctl
cd /tmp/urdfctl
python3 -m venv /tmp/venv
/tmp/venv/bin/python -m pip install --quiet -e '.[dev]'
. "/opt/ros/$ROS_DISTRO/setup.bash"
/tmp/venv/bin/python -m pytest tests/doctor/test_doctor_real.py -q -p no:cacheprovider
