# join_modules(MAIN SCRIPT FILES): SCRIPT becomes the text of MAIN and of the modules it imports, each
# after those it imports itself, without imports and exports; FILES what was read. All are in
# one scope: a name at the top level of one module may not be that of another. A module imports by
# `import { a, b } from "./file.js";` and exports by `export` before a declaration, both at the start
# of a line.

set(name_form "[A-Za-z0-9_$]+")
set(import_form "import ({[^}]*} from )?\"([^\"]+)\"")
set(declaration_form "(const|let|class|function|async function) (${name_form}|{[^}]*})")

# The names that the declarations of `text` after `before` make at its top level.
function(declared_names text before names)
  string(REGEX MATCHALL "\n${before}${declaration_form}" declarations "\n${text}")
  string(REGEX REPLACE "\n${before}(const|let|class|function|async function) " " " declarations
         "${declarations}")
  string(REGEX MATCHALL "${name_form}" declarations "${declarations}")
  set(${names} "${declarations}" PARENT_SCOPE)
endfunction()

# Checks that `source` exports what the braces of an import in `file` name.
function(check_import file braces source)
  string(REGEX REPLACE "} from $" "" braces "${braces}")
  string(REGEX MATCHALL "${name_form}" wanted "${braces}")
  file(READ "${source}" text)
  declared_names("${text}" "export " exported)
  foreach(name IN LISTS wanted)
    if(NOT name IN_LIST exported)
      message(FATAL_ERROR "${file} imports ${name}, which ${source} does not export")
    endif()
  endforeach()
endfunction()

# Puts `file` and before it what it imports at the end of the global property SCRIPT, unless it is
# there. `importers`: the files being read, each imported by the one before.
function(take_module file importers)
  get_property(taken GLOBAL PROPERTY FILES)
  if(file IN_LIST importers)
    message(FATAL_ERROR "modules import one another: ${importers};${file}")
  elseif(file IN_LIST taken)
    return()
  endif()
  file(READ "${file}" text)
  get_filename_component(folder "${file}" DIRECTORY)
  string(REGEX MATCHALL "\n${import_form}" imports "\n${text}")
  foreach(import IN LISTS imports)
    string(REGEX MATCH "${import_form}" import "${import}")
    set(braces "${CMAKE_MATCH_1}")
    get_filename_component(source "${folder}/${CMAKE_MATCH_2}" ABSOLUTE)
    check_import("${file}" "${braces}" "${source}")
    take_module("${source}" "${importers};${file}")
  endforeach()

  declared_names("${text}" "(export )?" names)
  get_property(known GLOBAL PROPERTY NAMES)
  foreach(name IN LISTS names)
    if(name IN_LIST known)
      message(FATAL_ERROR "${file}: another module of the page has a ${name} as well")
    endif()
  endforeach()
  string(REGEX REPLACE "\n${import_form};" "" text "\n${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  set_property(GLOBAL APPEND_STRING PROPERTY SCRIPT "${text}")
  set_property(GLOBAL APPEND PROPERTY FILES "${file}")
  set_property(GLOBAL APPEND PROPERTY NAMES ${names})
endfunction()

function(join_modules main script files)
  get_filename_component(main "${main}" ABSOLUTE)
  take_module("${main}" "")
  get_property(text GLOBAL PROPERTY SCRIPT)
  get_property(read GLOBAL PROPERTY FILES)
  set(${script} "${text}" PARENT_SCOPE)
  set(${files} "${read}" PARENT_SCOPE)
endfunction()
