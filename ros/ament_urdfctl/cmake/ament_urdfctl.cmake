# Add a test that lints and smoke-tests the robots of this package with urdfctl.
#
# :param TESTNAME: the name of the test, default: urdfctl
# :param COMMAND: check (the default), lint or smoke
# :param TIMEOUT: seconds, default: 120
# :param ARGN: files, folders and options, such as `urdf/robot.xacro --distro jazzy`; default: the package
#
# Its findings stand in ${AMENT_TEST_RESULTS_DIR}/<package>/<TESTNAME>.xunit.xml.
function(ament_urdfctl)
  cmake_parse_arguments(ARG "" "TESTNAME;COMMAND;TIMEOUT" "" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "urdfctl")
  endif()
  if(NOT ARG_COMMAND)
    set(ARG_COMMAND "check")
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(NOT ARG_UNPARSED_ARGUMENTS)
    set(ARG_UNPARSED_ARGUMENTS ".")
  endif()

  find_program(URDFCTL NAMES urdfctl)
  if(NOT URDFCTL)
    message(FATAL_ERROR "ament_urdfctl() needs the program urdfctl: pip install urdfctl")
  endif()

  set(result_file "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  ament_add_test(
    "${ARG_TESTNAME}"
    COMMAND "${URDFCTL}" "${ARG_COMMAND}" ${ARG_UNPARSED_ARGUMENTS} --format text --format "junit=${result_file}"
    TIMEOUT "${ARG_TIMEOUT}"
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_urdfctl/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result_file}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "urdfctl;linter")
endfunction()
