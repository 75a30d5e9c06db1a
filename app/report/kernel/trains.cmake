# Gear trains of which all is given.
block(PROPAGATE COGNATE_TRAIN_KERNEL)
set(COGNATE_TRAIN_KERNEL "${CMAKE_CURRENT_BINARY_DIR}/train_kernel.base64")
list(APPEND wasm_flags -DBOOST_NO_CXX98_FUNCTION_BASE)
cognate_page_kernel(train_kernel ${problem_reader}
  analysis/train/gear_train.cpp
  analysis/train/planets.cpp
  analysis/train/train_loads.cpp
  app/report/kernel/long_integers.cpp
  app/report/kernel/train_left_out.cpp
  app/report/kernel/trains.cpp
  app/report/train_report_data.cpp
  problems/linkage/constraint_checks.cpp
  problems/linkage/constraint_words.cpp
  problems/train/analyse.cpp
  problems/train/check.cpp
  problems/train/names.cpp
  problems/train/read.cpp
  problems/train/read_target.cpp
  problems/train/resolve.cpp
  problems/train/solve.cpp
  problems/train/transmission.cpp)
endblock()
