# What `cmake --install` lays down: the program, the libraries, their headers under
# include/cognate/, and what find_package(cognate) reads.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/cognate)

foreach(room IN ITEMS analysis synthesis problems)
  set_target_properties(cognate_${room} PROPERTIES EXPORT_NAME ${room})
  install(TARGETS cognate_${room} EXPORT cognate)
endforeach()
install(CODE "set(SOURCE \"${PROJECT_SOURCE_DIR}\")
set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/cognate\")")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake)
if(TARGET cognate)
  install(TARGETS cognate)
  install(FILES ${PROJECT_BINARY_DIR}/app/cognate.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${PROJECT_BINARY_DIR}/app/cognate.bash RENAME cognate
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${PROJECT_BINARY_DIR}/app/cognate.zsh RENAME _cognate
          DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${PROJECT_BINARY_DIR}/app/cognate.fish
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()
foreach(module IN ITEMS cognate_solids cognate_columns)
  if(TARGET ${module})
    install(TARGETS ${module} DESTINATION ${CMAKE_INSTALL_LIBDIR}/cognate)
  endif()
endforeach()
if(TARGET cognate-mpi)
  install(TARGETS cognate-mpi)
endif()

install(EXPORT cognate NAMESPACE cognate:: FILE cognateTargets.cmake DESTINATION ${config_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/cognateConfig.cmake.in
                              cognateConfig.cmake INSTALL_DESTINATION ${config_dir}
                              PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(cognateConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cognateConfig.cmake
              ${PROJECT_BINARY_DIR}/cognateConfigVersion.cmake
        DESTINATION ${config_dir})
