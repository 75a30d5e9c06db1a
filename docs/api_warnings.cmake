# Fails on any warning of Doxygen in the file LOG but one: members of a struct and values of an
# enumeration may do with their name. cmake -DLOG=FILE -P api_warnings.cmake
file(STRINGS "${LOG}" warnings)
list(FILTER warnings EXCLUDE REGEX "\\((variable|enumvalue)\\) of .* is not documented")
if(warnings)
  list(JOIN warnings "\n" text)
  message(FATAL_ERROR "Doxygen warns:\n${text}")
endif()
