# Run as: cmake -DPROGRAM=... -DLABEL=... -DLONG=... -DDEAR=... -DFILE=... -P discover_suites.cmake
# Writes into FILE a test of CTest for each suite of PROGRAM, a program of GoogleTest, such as
# unit_problems.PathRaster of unit_problems_tests. Of a case most of the time goes by until its process
# has begun; a suite needs one. Suites whose whole name LONG matches have the label `long` too; those
# that DEAR matches begin early.
get_filename_component(program "${PROGRAM}" NAME_WE)
string(REGEX REPLACE "_tests$" "" program "${program}")
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${list}")
set(tests "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  set(labels "${LABEL}")
  if(suite MATCHES "^(${LONG})$")
    set(labels "${LABEL};long")
  endif()
  set(cost 0)
  if(suite MATCHES "^(${DEAR})$")
    set(cost 50)
  endif()
  string(APPEND tests "add_test(\"${program}.${suite}\" \"${PROGRAM}\" \"--gtest_filter=${suite}.*\" --gtest_brief=1)\n"
                      "set_tests_properties(\"${program}.${suite}\" PROPERTIES LABELS \"${labels}\" COST ${cost})\n")
endforeach()
file(WRITE "${FILE}" "${tests}")
