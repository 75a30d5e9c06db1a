# The analysis kernel for the report pages: the same sources, compiled to WebAssembly by Clang, and
# written as base64 text that the pages inline: COGNATE_PAGE_KERNEL for four-bars,
# COGNATE_MECHANISM_KERNEL for mechanisms of the simple types. Without the toolchain both are empty,
# and the pages offer no editing.
set(COGNATE_PAGE_KERNEL "")
set(COGNATE_MECHANISM_KERNEL "")
find_program(COGNATE_WASM_CXX NAMES clang++-19 clang++)
find_program(COGNATE_BASE64 NAMES base64)
mark_as_advanced(COGNATE_WASM_CXX COGNATE_BASE64)

set(wasm_flags --target=wasm32-wasi -std=c++20 -Os -fno-exceptions -fno-rtti -DNDEBUG)
set(wasm_link_flags -mexec-model=reactor -Wl,--gc-sections -Wl,--strip-all)

# Whether Clang has what it takes to build for WebAssembly: the linker, both libraries, the run time.
function(cognate_check_wasm result)
  set(${result} FALSE PARENT_SCOPE)
  if(NOT COGNATE_WASM_CXX OR NOT COGNATE_BASE64)
    return()
  endif()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/kernel")
  file(WRITE "${folder}/probe.cpp" "#include <__verbose_abort>\n#include <vector>\n\
extern \"C\" __attribute__((export_name(\"probe\"))) int probe(int n) {\n\
  return static_cast<int>(std::vector<double>(n).size());\n}\n")
  execute_process(
    COMMAND "${COGNATE_WASM_CXX}" ${wasm_flags} ${wasm_link_flags} probe.cpp -o probe.wasm
    WORKING_DIRECTORY "${folder}" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed)
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

cognate_check_wasm(can_build_wasm)
if(NOT can_build_wasm)
  message(WARNING "Clang cannot build for WebAssembly here: report pages will offer no editing. "
                  "Install clang-19, lld-19, wasi-libc, libc++-19-dev-wasm32, "
                  "libc++abi-19-dev-wasm32 and libclang-rt-19-dev-wasm32 and configure anew to "
                  "have it.")
  return()
endif()

# cognate_page_kernel(NAME SOURCES...): NAME.base64 in the build folder, a module of the sources
# and of what all modules need.
function(cognate_page_kernel name)
  set(objects "")
  foreach(source IN LISTS ARGN ITEMS app/report/kernel/numbers.cpp app/report/kernel/runtime.cpp)
    set(object "${CMAKE_CURRENT_BINARY_DIR}/${name}/${source}.o")
    get_filename_component(folder "${object}" DIRECTORY)
    file(MAKE_DIRECTORY "${folder}")
    add_custom_command(
      OUTPUT "${object}"
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} "${COGNATE_WASM_CXX}" ${wasm_flags}
              "-I${PROJECT_SOURCE_DIR}" -MD -MF "${object}.d" -MT "${object}"
              -c "${PROJECT_SOURCE_DIR}/${source}" -o "${object}"
      DEPENDS "${PROJECT_SOURCE_DIR}/${source}"
      DEPFILE "${object}.d"
      COMMENT "Building ${source} for the report pages"
      VERBATIM)
    list(APPEND objects "${object}")
  endforeach()
  set(module "${CMAKE_CURRENT_BINARY_DIR}/${name}")
  add_custom_command(
    OUTPUT "${module}.wasm" "${module}.base64"
    COMMAND "${COGNATE_WASM_CXX}" ${wasm_flags} ${wasm_link_flags} ${objects}
            -o "${module}.wasm"
    COMMAND "${COGNATE_BASE64}" "${module}.wasm" > "${module}.base64"
    DEPENDS ${objects}
    COMMENT "Linking ${name} of the report pages"
    VERBATIM)
endfunction()

set(COGNATE_PAGE_KERNEL "${CMAKE_CURRENT_BINARY_DIR}/kernel.base64")
cognate_page_kernel(kernel
  analysis/linkage/defects.cpp
  analysis/linkage/four_bar.cpp
  analysis/linkage/frame_axes.cpp
  analysis/linkage/mobility.cpp
  analysis/linkage/motion.cpp
  app/drawing/design_motion.cpp
  app/report/kernel/four_bar.cpp
  app/report/kernel/nearest.cpp)
set(COGNATE_MECHANISM_KERNEL "${CMAKE_CURRENT_BINARY_DIR}/mechanism_kernel.base64")
cognate_page_kernel(mechanism_kernel
  analysis/linkage/change_point.cpp
  analysis/linkage/double_slider.cpp
  analysis/linkage/double_slider_travel.cpp
  analysis/linkage/four_bar.cpp
  analysis/linkage/frame_axes.cpp
  analysis/linkage/guide_bar.cpp
  analysis/linkage/guide_bar_mobility.cpp
  analysis/mechanism/circuit_range.cpp
  analysis/mechanism/assembly_ranges.cpp
  analysis/mechanism/assembly_probe.cpp
  analysis/mechanism/dyad_reach.cpp
  analysis/mechanism/joints.cpp
  analysis/mechanism/kinematics.cpp
  analysis/mechanism/output_limits.cpp
  analysis/mechanism/sliding_pairs.cpp
  analysis/mechanism/transmission_extremes.cpp
  analysis/mechanism/travel.cpp
  analysis/linkage/mobility.cpp
  analysis/linkage/slider_crank.cpp
  analysis/linkage/slider_crank_mobility.cpp
  app/drawing/convex_hull.cpp
  app/report/kernel/mechanism.cpp
  app/drawing/mechanism_poses.cpp
  app/drawing/mechanism_shapes.cpp
  problems/mechanism/joint_names.cpp
  problems/evaluation/motion_summary.cpp
  problems/mechanism/named_mechanism.cpp
  problems/evaluation/output_travel.cpp
  problems/mechanism/mechanism_types.cpp
  problems/evaluation/type_quantities.cpp
  problems/evaluation/whole_motion.cpp
  problems/linkage/names.cpp
  problems/mechanism/names.cpp)
