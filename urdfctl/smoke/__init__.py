"""Run a robot without ROS: spawn it and take each controller from loading to deactivation. `run.py` has the stages."""
