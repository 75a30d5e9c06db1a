# The analysis kernel for the report pages: the same sources, compiled to WebAssembly by Clang,
# compressed, and written as base64 text that the pages inline: COGNATE_PAGE_KERNEL for four-bars,
# COGNATE_ANALYSIS_KERNEL for whole analyses, which reads and evaluates a problem as the program
# does, COGNATE_DESIGN_KERNEL also for designs that are no four-bars; COGNATE_CAM_KERNEL,
# COGNATE_GEAR_KERNEL, COGNATE_TRAIN_KERNEL and COGNATE_MACHINE_KERNEL do so for cams, gears, gear
# trains and machines; COGNATE_SKETCH_KERNEL to search for paths. Without the toolchain they are
# empty: pages offer no editing, and that one draws on no linkages.
set(COGNATE_PAGE_KERNEL "")
set(COGNATE_ANALYSIS_KERNEL "")
set(COGNATE_DESIGN_KERNEL "")
set(COGNATE_CAM_KERNEL "")
set(COGNATE_GEAR_KERNEL "")
set(COGNATE_MACHINE_KERNEL "")
set(COGNATE_TRAIN_KERNEL "")
set(COGNATE_SKETCH_KERNEL "")
find_program(COGNATE_WASM_CXX NAMES clang++-19 clang++)
find_program(COGNATE_BASE64 NAMES base64)
find_program(COGNATE_GZIP NAMES gzip)
mark_as_advanced(COGNATE_WASM_CXX COGNATE_BASE64 COGNATE_GZIP)

# Boost's containers take a base class that the library has no more.
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(TRANSFORM eigen_folders PREPEND "-isystem")
set(wasm_flags --target=wasm32-wasi -std=c++20 -Os -fno-exceptions -fno-rtti -DNDEBUG
               ${eigen_folders} -DBOOST_NO_CXX98_FUNCTION_BASE -DCOGNATE_ISA=scalar)
# The linker's own stack is 64 kB, and lies where what leaves it overwrites data unseen.
set(wasm_link_flags -mexec-model=reactor -Wl,--gc-sections -Wl,--strip-all -Wl,--stack-first
                    -Wl,-z,stack-size=262144)

# Whether Clang has what it takes to build for WebAssembly: the linker, both libraries, the run time.
function(cognate_check_wasm result)
  set(${result} FALSE PARENT_SCOPE)
  if(NOT COGNATE_WASM_CXX OR NOT COGNATE_BASE64 OR NOT COGNATE_GZIP)
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
  set_property(GLOBAL APPEND PROPERTY COGNATE_PAGE_KERNELS ${name})
  foreach(source IN LISTS ARGN ITEMS app/report/kernel/numbers.cpp app/report/kernel/runtime.cpp)
    set_property(GLOBAL APPEND PROPERTY COGNATE_PAGE_KERNEL_SOURCES "${source}")
    set_property(GLOBAL APPEND PROPERTY "COGNATE_PAGE_KERNELS_OF_${source}" ${name})
  endforeach()
endfunction()

set(wasm_compile ${CMAKE_CXX_COMPILER_LAUNCHER} "${COGNATE_WASM_CXX}" ${wasm_flags}
                 "-I${CMAKE_CURRENT_SOURCE_DIR}/kernel/surroundings" "-I${PROJECT_SOURCE_DIR}")

# The headers that most sources include: they take a third of the time of compiling one.
set(page_headers "${CMAKE_CURRENT_BINARY_DIR}/kernel/common.pch")
add_custom_command(
  OUTPUT "${page_headers}"
  COMMAND ${wasm_compile} -MD -MF "${page_headers}.d" -MT "${page_headers}"
          -x c++-header "${CMAKE_CURRENT_SOURCE_DIR}/kernel/common.hpp" -o "${page_headers}"
  DEPENDS kernel/common.hpp
  DEPFILE "${page_headers}.d"
  COMMENT "Precompiling headers for the report pages"
  VERBATIM)

# The object of `source`, which is one for the compiler with what it includes.
function(compile_for_pages source)
  add_custom_command(
    OUTPUT "${source}.o"
    COMMAND ${wasm_compile} -MD -MF "${source}.o.d" -MT "${source}.o"
            -include-pch "${page_headers}" -c "${source}" -o "${source}.o"
    DEPENDS "${source}" "${page_headers}"
    DEPFILE "${source}.o.d"
    COMMENT "Building ${source} for the report pages"
    VERBATIM)
endfunction()

function(link_for_pages name)
  set(module "${CMAKE_CURRENT_BINARY_DIR}/${name}")
  add_custom_command(
    OUTPUT "${module}.wasm" "${module}.base64"
    COMMAND "${COGNATE_WASM_CXX}" ${wasm_flags} ${wasm_link_flags} ${ARGN} -o "${module}.wasm"
    COMMAND "${COGNATE_GZIP}" -9 -n -c "${module}.wasm" > "${module}.wasm.gz"
    COMMAND "${COGNATE_BASE64}" "${module}.wasm.gz" > "${module}.base64"
    DEPENDS ${ARGN}
    COMMENT "Linking ${name} of the report pages"
    VERBATIM)
endfunction()

# Makes the modules. The sources of a folder that the same modules need are one for the compiler, and
# compiled once for all these.
function(cognate_make_page_kernels)
  get_property(kernels GLOBAL PROPERTY COGNATE_PAGE_KERNELS)
  get_property(sources GLOBAL PROPERTY COGNATE_PAGE_KERNEL_SOURCES)
  list(REMOVE_DUPLICATES sources)
  set(groups "")
  foreach(source IN LISTS sources)
    get_property(users GLOBAL PROPERTY "COGNATE_PAGE_KERNELS_OF_${source}")
    get_filename_component(folder "${source}" DIRECTORY)
    string(REPLACE "_kernel" "" names "${users}")
    string(MAKE_C_IDENTIFIER "${folder}_for_${names}" group)
    list(APPEND groups ${group})
    set(users_of_${group} ${users})
    string(APPEND text_of_${group} "#include \"${source}\"\n")
  endforeach()
  list(REMOVE_DUPLICATES groups)
  foreach(group IN LISTS groups)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/kernel/${group}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "${text_of_${group}}" @ONLY)
    compile_for_pages("${source}")
    foreach(kernel IN LISTS users_of_${group})
      list(APPEND objects_of_${kernel} "${source}.o")
    endforeach()
  endforeach()
  foreach(kernel IN LISTS kernels)
    link_for_pages(${kernel} ${objects_of_${kernel}})
  endforeach()
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
# What reads a problem that a page hands over, and answers with data.
set(problem_reader
  app/report/drawn_number.cpp
  app/report/kernel/answer.cpp
  app/report/kernel/document.cpp
  app/report/kernel/format.cpp
  app/report/kernel/whole_numbers.cpp
  app/report/quantity_json.cpp
  problems/basics/length_unit.cpp
  problems/linkage/names.cpp
  problems/toml/fault_list.cpp
  problems/toml/nearest.cpp
  problems/toml/table_reader.cpp
  problems/toml/table_reader_arrays.cpp
  problems/toml/table_writer.cpp)
# All types of mechanisms, as the library lists them: a module keeps of them what it calls.
get_target_property(linkages cognate_analysis SOURCES)
list(FILTER linkages INCLUDE REGEX "^linkage/")
list(TRANSFORM linkages PREPEND "analysis/")
# What reads, moves and draws a mechanism with its masses and loads.
set(mechanism_evaluator
  ${linkages}
  analysis/mechanism/assembly_fault.cpp
  analysis/mechanism/assembly_probe.cpp
  analysis/mechanism/assembly_ranges.cpp
  analysis/mechanism/circuit_range.cpp
  analysis/mechanism/dyad_reach.cpp
  analysis/mechanism/inverse_dynamics.cpp
  analysis/mechanism/group_closure.cpp
  analysis/mechanism/group_equations.cpp
  analysis/mechanism/group_track.cpp
  analysis/mechanism/joint_balance.cpp
  analysis/mechanism/joints.cpp
  analysis/mechanism/kinematics.cpp
  analysis/mechanism/output_limits.cpp
  analysis/mechanism/sliding_pairs.cpp
  analysis/mechanism/three_pin_link.cpp
  analysis/mechanism/travel.cpp
  analysis/numbers/convex_hull.cpp
  app/drawing/mechanism_poses.cpp
  app/drawing/mechanism_shapes.cpp
  app/report/drawn_rows.cpp
  app/report/mechanism_json.cpp
  problems/basics/unit_notes.cpp
  problems/evaluation/active_loads.cpp
  problems/evaluation/force_units.cpp
  problems/evaluation/load_breaks.cpp
  problems/mechanism/directions.cpp
  problems/mechanism/drawn/check_drawing.cpp
  problems/mechanism/drawn/describe_drawing.cpp
  problems/mechanism/drawn/describe_group.cpp
  problems/mechanism/drawn/determined_links.cpp
  problems/mechanism/drawn/drawing.cpp
  problems/mechanism/drawn/groups.cpp
  problems/mechanism/drawn/read_drawing.cpp
  problems/mechanism/drawn/read_drawn_chain.cpp
  problems/mechanism/joint_names.cpp
  problems/mechanism/mechanism_types.cpp
  problems/mechanism/named_mechanism.cpp
  problems/mechanism/named_parts.cpp
  problems/mechanism/names.cpp
  problems/mechanism/part_names.cpp
  problems/mechanism/read_chain.cpp
  problems/mechanism/read_chain_dyads.cpp
  problems/mechanism/read_cylinder.cpp
  problems/mechanism/read_dyad_keys.cpp
  problems/mechanism/read_extra_points.cpp
  problems/mechanism/read_group.cpp
  problems/mechanism/read_links.cpp
  problems/mechanism/read_loads.cpp
  problems/mechanism/read_simple_mechanism.cpp
  problems/mechanism/read_slides.cpp
  problems/mechanism/read_whole_mechanism.cpp
  problems/mechanism/write_mechanism.cpp)
# What evaluates a whole analysis.
set(analysis_evaluator
  analysis/cam/extremes.cpp
  analysis/cam/subdivision.cpp
  analysis/coupler_curve/circuit_samples.cpp
  analysis/coupler_curve/circuits.cpp
  analysis/coupler_curve/closed_segment.cpp
  analysis/coupler_curve/curve_features.cpp
  analysis/coupler_curve/curve_measures.cpp
  analysis/coupler_curve/fourier_descriptors.cpp
  analysis/coupler_curve/longest_segment.cpp
  analysis/coupler_curve/narrowest_strip.cpp
  analysis/coupler_curve/path_curvature.cpp
  analysis/coupler_curve/pole.cpp
  analysis/coupler_curve/sampled_segment.cpp
  analysis/coupler_curve/stationary_curvature.cpp
  analysis/mechanism/gait.cpp
  analysis/mechanism/transmission_extremes.cpp
  analysis/numbers/chebyshev_series.cpp
  app/report/analysis_report_data.cpp
  app/report/column_vectors.cpp
  app/report/load_arrows.cpp
  app/report/kernel/analysis.cpp
  app/report/kernel/left_out.cpp
  problems/evaluation/column_plan.cpp
  problems/evaluation/curve_metrics.cpp
  problems/evaluation/drive_rows.cpp
  problems/evaluation/force_extremes.cpp
  problems/evaluation/instant_geometry.cpp
  problems/evaluation/motion_quantities.cpp
  problems/evaluation/motion_summary.cpp
  problems/evaluation/open_rows.cpp
  problems/evaluation/output_travel.cpp
  problems/evaluation/read.cpp
  problems/evaluation/read_output.cpp
  problems/evaluation/row_filler.cpp
  problems/evaluation/smooth_pieces.cpp
  problems/evaluation/solve.cpp
  problems/evaluation/sweep.cpp
  problems/evaluation/type_quantities.cpp
  problems/evaluation/whole_motion.cpp)
set(COGNATE_ANALYSIS_KERNEL "${CMAKE_CURRENT_BINARY_DIR}/analysis_kernel.base64")
cognate_page_kernel(analysis_kernel ${problem_reader} ${mechanism_evaluator} ${analysis_evaluator})

include("${CMAKE_CURRENT_LIST_DIR}/cams.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/designs.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/gears.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/machines.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/trains.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/sketch.cmake")
cognate_make_page_kernels()
