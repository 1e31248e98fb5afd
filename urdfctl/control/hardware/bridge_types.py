"""The types of messages that ros_gz_bridge translates, in any distro (ros_gz_bridge README.md, humble to rolling)."""

from __future__ import annotations

_PAIRS = """
actuator_msgs/Actuators Actuators
builtin_interfaces/Time Time
geometry_msgs/Point Vector3d
geometry_msgs/Pose Pose
geometry_msgs/PoseArray Pose_V
geometry_msgs/PoseStamped Pose
geometry_msgs/PoseWithCovariance PoseWithCovariance
geometry_msgs/PoseWithCovarianceStamped PoseWithCovariance
geometry_msgs/Quaternion Quaternion
geometry_msgs/Transform Pose
geometry_msgs/TransformStamped Pose
geometry_msgs/Twist Twist
geometry_msgs/TwistStamped Twist
geometry_msgs/TwistWithCovariance TwistWithCovariance
geometry_msgs/TwistWithCovarianceStamped TwistWithCovariance
geometry_msgs/Vector3 Vector3d
geometry_msgs/Wrench Wrench
geometry_msgs/WrenchStamped Wrench
gps_msgs/GPSFix NavSat
nav_msgs/Odometry Odometry OdometryWithCovariance
rcl_interfaces/ParameterValue Any
ros_gz_interfaces/Altimeter Altimeter
ros_gz_interfaces/Contact Contact
ros_gz_interfaces/Contacts Contacts
ros_gz_interfaces/Dataframe Dataframe
ros_gz_interfaces/Entity Entity
ros_gz_interfaces/EntityWrench EntityWrench
ros_gz_interfaces/Float32Array Float_V
ros_gz_interfaces/GuiCamera GUICamera
ros_gz_interfaces/JointWrench JointWrench
ros_gz_interfaces/Light Light
ros_gz_interfaces/ParamVec Param Param_V
ros_gz_interfaces/SensorNoise SensorNoise
ros_gz_interfaces/StringVec StringMsg_V
ros_gz_interfaces/TrackVisual TrackVisual
ros_gz_interfaces/VideoRecord VideoRecord
ros_gz_interfaces/WorldControl WorldControl
rosgraph_msgs/Clock Clock
sensor_msgs/BatteryState BatteryState
sensor_msgs/CameraInfo CameraInfo
sensor_msgs/FluidPressure FluidPressure
sensor_msgs/Image Image
sensor_msgs/Imu IMU
sensor_msgs/JointState Model
sensor_msgs/Joy Joy
sensor_msgs/LaserScan LaserScan
sensor_msgs/MagneticField Magnetometer
sensor_msgs/NavSatFix NavSat
sensor_msgs/PointCloud2 PointCloudPacked
std_msgs/Bool Boolean
std_msgs/ColorRGBA Color
std_msgs/Empty Empty
std_msgs/Float32 Float
std_msgs/Float64 Double
std_msgs/Header Header
std_msgs/Int32 Int32
std_msgs/String StringMsg
std_msgs/UInt32 UInt32
tf2_msgs/TFMessage Pose_V
trajectory_msgs/JointTrajectory JointTrajectory
vision_msgs/Detection2D AnnotatedAxisAligned2DBox
vision_msgs/Detection2DArray AnnotatedAxisAligned2DBox_V
vision_msgs/Detection3D AnnotatedOriented3DBox
vision_msgs/Detection3DArray AnnotatedOriented3DBox_V
"""
BRIDGED = {
    ros.replace("/", "/msg/"): tuple(f"gz.msgs.{name}" for name in names)
    for ros, *names in map(str.split, _PAIRS.strip().splitlines())
}
"""The types of gz by the type of ROS."""
