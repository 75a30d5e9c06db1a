# worked_problems.cpp in the build folder: every file of problems/library that names no other, as a
# string.
set(library "${PROJECT_SOURCE_DIR}/problems/library")
file(GLOB files CONFIGURE_DEPENDS RELATIVE "${library}" "${library}/*/*.toml")
list(SORT files)
set(WORKED_PROBLEMS "")
foreach(file IN LISTS files)
  file(READ "${library}/${file}" text)
  if(text MATCHES "\n(svg|atlas|base) *=")
    continue()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${library}/${file}")
  string(REGEX REPLACE "\\.toml$" "" name "${file}")
  string(APPEND WORKED_PROBLEMS "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
configure_file("${CMAKE_CURRENT_LIST_DIR}/worked_problems.cpp.in"
               "${CMAKE_CURRENT_BINARY_DIR}/worked_problems.cpp" @ONLY)
