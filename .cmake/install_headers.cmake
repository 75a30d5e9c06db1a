# Run by `cmake --install`: lays down the headers of include/cognate, which users include, and what
# these include in turn, under include/cognate/ each by its path in the repository. No other header is
# installed. SOURCE is the root of the repository, DESTINATION where include/cognate comes.
file(GLOB waiting RELATIVE ${SOURCE}/include/cognate ${SOURCE}/include/cognate/*.hpp)
list(TRANSFORM waiting PREPEND include/cognate/)
set(found ${waiting})
while(waiting)
  list(POP_FRONT waiting header)
  file(STRINGS ${SOURCE}/${header} includes REGEX "^#include \"")
  list(TRANSFORM includes REPLACE "^#include \"(.+)\".*" "\\1")
  list(REMOVE_ITEM includes ${found})
  list(APPEND waiting ${includes})
  list(APPEND found ${includes})
endwhile()
foreach(header IN LISTS found)
  string(REGEX REPLACE "^include/cognate/" "" place ${header})
  get_filename_component(folder ${place} DIRECTORY)
  file(INSTALL ${SOURCE}/${header} DESTINATION ${DESTINATION}/${folder})
endforeach()
