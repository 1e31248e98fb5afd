"""ROS 2 launch files in Python, XML and YAML, read into the same terms without running them."""
