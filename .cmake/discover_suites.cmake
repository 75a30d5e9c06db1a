# Run as: cmake -DPROGRAM=... -DLABEL=... -DLONG=... -DLONG_CASES=... -DDEAR=... -DFILE=... -P discover_suites.cmake
# Writes into FILE a test of CTest for each suite of PROGRAM, a program of GoogleTest, such as
# unit_problems.PathRaster of unit_problems_tests. Of a case most of the time goes by until its process
# has begun; a suite needs one. Suites whose whole name LONG matches have the label `long` too; those
# that DEAR matches begin early. Cases named in LONG_CASES, as SUITE.CASE|SUITE.CASE, are a test of
# their own, SUITE.long, with that label.
get_filename_component(program "${PROGRAM}" NAME_WE)
string(REGEX REPLACE "_tests$" "" program "${program}")
string(REPLACE "|" ";" long_cases "${LONG_CASES}")
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${list}")
set(tests "")
function(write_test name filter labels cost)
  string(APPEND tests "add_test(\"${program}.${name}\" \"${PROGRAM}\" \"--gtest_filter=${filter}\" --gtest_brief=1)\n"
                      "set_tests_properties(\"${program}.${name}\" PROPERTIES LABELS \"${labels}\" COST ${cost})\n")
  set(tests "${tests}" PARENT_SCOPE)
endfunction()
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
  set(own_long "${long_cases}")
  list(FILTER own_long INCLUDE REGEX "^${suite}\\.")
  if(own_long)
    list(JOIN own_long ":" filter)
    write_test("${suite}" "${suite}.*-${filter}" "${labels}" ${cost})
    write_test("${suite}.long" "${filter}" "${LABEL};long" ${cost})
  else()
    write_test("${suite}" "${suite}.*" "${labels}" ${cost})
  endif()
endforeach()
file(WRITE "${FILE}" "${tests}")
