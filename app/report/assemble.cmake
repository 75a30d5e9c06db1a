# Puts the page together from its parts and writes it as a C++ source, with the modules read in
# OUTPUT.d for the build.
# OUTPUT: the source; FUNCTION: its function; CONTENT: what stands in the page's frame; MAIN: the
# module of the page that imports all others; STYLES in order; WORDS: the texts, a file for each
# language; LICENCE, LIBRARY and LIBRARY_STYLES: files of the plotting library, or empty; KERNEL: the
# analysis kernel in base64, or empty; MECHANISM_KERNEL: likewise that for mechanisms of any kind.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/modules.cmake")

# join(VARIABLE FILES...): the text of all.
function(join variable)
  set(joined "")
  foreach(part IN LISTS ARGN)
    file(READ ${part} text)
    string(APPEND joined "${text}\n")
  endforeach()
  set(${variable} "${joined}" PARENT_SCOPE)
endfunction()

file(READ page/index.html page)
file(READ ${CONTENT} content)
join(style ${STYLES})
join_modules(${MAIN} script modules)
# A page is for its reader: what is for those who read its sources would be a tenth of it.
string(REGEX REPLACE "\n[ ]+" "\n" script "${script}")
string(REGEX REPLACE "\n//[^\n]*" "" script "${script}")
string(REGEX REPLACE "\n\n+" "\n" script "${script}")

join(library_style ${LIBRARY_STYLES})
set(library "")
if(LIBRARY)
  file(READ "${LICENCE}" licence)
  file(READ "${LIBRARY}" text)
  set(library "/*\n${licence}*/\n${text}")
endif()

# One object with a member for each language.
set(words "")
foreach(file IN LISTS WORDS)
  get_filename_component(language ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND words ",\"${language}\": ${text}")
endforeach()
string(SUBSTRING "${words}" 1 -1 words)
string(REGEX REPLACE "\n[ ]+" "\n" words "${words}")

string(REPLACE "@CONTENT@" "${content}" page "${page}")
string(REPLACE "@STYLE@" "${library_style}\n${style}" page "${page}")
string(REPLACE "@LIBRARY@" "${library}" page "${page}")
string(REPLACE "@WORDS@" "{${words}}" page "${page}")
set(kernel "")
if(KERNEL)
  file(READ "${KERNEL}" kernel)
endif()
string(REPLACE "@KERNEL@" "${kernel}" page "${page}")
set(kernel "")
if(MECHANISM_KERNEL)
  file(READ "${MECHANISM_KERNEL}" kernel)
endif()
string(REPLACE "@MECHANISM_KERNEL@" "${kernel}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")

# Compilers need take no literal longer than 65536 bytes: pieces, cut after an ASCII character so
# that each is valid UTF-8.
set(source "// Written by assemble.cmake.\n#include \"app/report/page.hpp\"\n\n")
string(APPEND source "namespace cognate::app {\n\nstd::string ${FUNCTION}() {\n  std::string text;\n")
string(LENGTH "${page}" left)
while(left GREATER 0)
  string(SUBSTRING "${page}" 0 30000 piece)
  if(left GREATER 30000)
    string(REGEX MATCH "^.*[\n,;]" piece "${piece}")
  endif()
  string(LENGTH "${piece}" length)
  if(length EQUAL 0)
    message(FATAL_ERROR "no place to cut the page")
  endif()
  string(SUBSTRING "${page}" ${length} -1 page)
  string(LENGTH "${page}" left)
  string(APPEND source "  text += R\"~page~(${piece})~page~\";\n")
endwhile()
string(APPEND source "  return text;\n}\n\n}  // namespace cognate::app\n")
file(WRITE "${OUTPUT}" "${source}")
list(JOIN modules " " modules)
file(WRITE "${OUTPUT}.d" "${OUTPUT}: ${modules}\n")
