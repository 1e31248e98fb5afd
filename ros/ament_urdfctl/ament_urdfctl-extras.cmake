find_package(ament_cmake_test QUIET REQUIRED)

include("${ament_urdfctl_DIR}/ament_urdfctl.cmake")
