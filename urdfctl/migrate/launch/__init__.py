"""Launch files of ROS 1 as launch files of ROS 2: read into actions, then written in Python or XML."""
