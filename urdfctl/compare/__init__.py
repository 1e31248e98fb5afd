"""`urdfctl diff`: what changed between two robots, as models: what ROS reads of them, not how it is written."""
