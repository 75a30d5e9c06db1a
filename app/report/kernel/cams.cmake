# Cams of which all is given. Boost's containers take a base class that the library has no more.
block(PROPAGATE COGNATE_CAM_KERNEL)
set(COGNATE_CAM_KERNEL "${CMAKE_CURRENT_BINARY_DIR}/cam_kernel.base64")
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(TRANSFORM eigen_folders PREPEND "-isystem")
list(APPEND wasm_flags ${eigen_folders} -DBOOST_NO_CXX98_FUNCTION_BASE)
cognate_page_kernel(cam_kernel ${problem_reader}
  analysis/cam/extremes.cpp
  analysis/cam/motion_law.cpp
  analysis/cam/motion_programme.cpp
  analysis/cam/peak_factors.cpp
  analysis/cam/piece_bounds.cpp
  analysis/cam/profile.cpp
  analysis/cam/self_crossing.cpp
  analysis/cam/spline_law.cpp
  analysis/cam/subdivision.cpp
  analysis/cam/turn_extremes.cpp
  analysis/numbers/chebyshev_series.cpp
  app/drawing/cam_drawing.cpp
  app/report/cam_json.cpp
  app/report/cam_report_data.cpp
  app/report/kernel/cam_left_out.cpp
  app/report/kernel/cams.cpp
  problems/cam/checks.cpp
  problems/cam/exact.cpp
  problems/cam/extremes.cpp
  problems/cam/largest_roller.cpp
  problems/cam/limits.cpp
  problems/cam/names.cpp
  problems/cam/notes.cpp
  problems/cam/quantities.cpp
  problems/cam/read.cpp
  problems/cam/read_bounds.cpp
  problems/cam/read_conditions.cpp
  problems/cam/read_constraints.cpp
  problems/cam/read_follower.cpp
  problems/cam/read_lengths.cpp
  problems/cam/read_motion.cpp
  problems/cam/read_operation.cpp
  problems/cam/read_segment.cpp
  problems/cam/second_contact.cpp
  problems/cam/solve.cpp
  problems/cam/variables.cpp
  problems/linkage/constraint_checks.cpp
  problems/linkage/constraint_words.cpp
  problems/linkage/read_constraints.cpp
  problems/toml/table_writer.cpp
  synthesis/exact/cam/half_planes.cpp
  synthesis/exact/cam/smallest_cam.cpp
  synthesis/optimise/solver_traits.cpp)
endblock()
