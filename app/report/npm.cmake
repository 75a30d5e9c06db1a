# cognate_npm_ci(SOURCE DESTINATION RESULT): what SOURCE/package-lock.json lists, installed into
# DESTINATION/node_modules, once for each state of the lock file. RESULT becomes TRUE, or FALSE
# where npm is missing or fails (no network), and the caller goes on without.
function(cognate_npm_ci source destination result)
  set(${result} FALSE PARENT_SCOPE)
  file(SHA256 "${source}/package-lock.json" wanted)
  set(stamp "${destination}/installed")
  if(EXISTS "${stamp}")
    file(READ "${stamp}" present)
    if(present STREQUAL wanted)
      set(${result} TRUE PARENT_SCOPE)
      return()
    endif()
  endif()
  find_program(COGNATE_NPM npm)
  mark_as_advanced(COGNATE_NPM)
  if(NOT COGNATE_NPM)
    return()
  endif()
  file(MAKE_DIRECTORY "${destination}")
  file(COPY "${source}/package.json" "${source}/package-lock.json" DESTINATION "${destination}")
  execute_process(
    COMMAND "${COGNATE_NPM}" ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
            --fetch-timeout=30000
    WORKING_DIRECTORY "${destination}" TIMEOUT 180
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    file(WRITE "${stamp}" "${wanted}")
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()
