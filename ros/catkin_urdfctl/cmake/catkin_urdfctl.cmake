# Add a test that lints and smoke-tests the robots of this package with urdfctl.
#
# :param TESTNAME: the name of the test, default: urdfctl
# :param COMMAND: check (the default), lint or smoke
# :param ARGN: files, folders and options, such as `urdf/robot.xacro --distro noetic`; default: the package
#
# It runs in `catkin run_tests`; its findings stand in ${CATKIN_TEST_RESULTS_DIR}/<package>/<TESTNAME>.xml.
function(catkin_urdfctl)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  cmake_parse_arguments(ARG "" "TESTNAME;COMMAND" "" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "urdfctl")
  endif()
  if(NOT ARG_COMMAND)
    set(ARG_COMMAND "check")
  endif()
  if(NOT ARG_UNPARSED_ARGUMENTS)
    set(ARG_UNPARSED_ARGUMENTS ".")
  endif()

  find_program(URDFCTL NAMES urdfctl)
  if(NOT URDFCTL)
    message(FATAL_ERROR "catkin_urdfctl() needs the program urdfctl: pip install urdfctl")
  endif()

  set(result_file "${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xml")
  string(REPLACE ";" " " words "${ARG_UNPARSED_ARGUMENTS}")
  catkin_run_tests_target(
    "${ARG_TESTNAME}" "package" "${ARG_TESTNAME}.xml"
    COMMAND "${URDFCTL} ${ARG_COMMAND} ${words} --format text --format junit=${result_file}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
endfunction()
