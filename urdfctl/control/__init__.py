"""What a controller manager works out of controllers, their parameters and the robot."""
