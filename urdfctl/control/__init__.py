"""Model of what a controller manager does with controllers, their parameters and the robot."""
