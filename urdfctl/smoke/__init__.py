"""Spawns a robot without ROS and takes each of its controllers through its life."""
