# Machines.
block(PROPAGATE COGNATE_MACHINE_KERNEL)
set(COGNATE_MACHINE_KERNEL "${CMAKE_CURRENT_BINARY_DIR}/machine_kernel.base64")
list(APPEND wasm_flags -DBOOST_NO_CXX98_FUNCTION_BASE)
cognate_page_kernel(machine_kernel ${problem_reader} ${mechanism_evaluator}
  analysis/machine/adaptive_steps.cpp
  analysis/machine/cycle.cpp
  analysis/machine/excess_work.cpp
  analysis/machine/flywheel.cpp
  analysis/machine/mean_torques.cpp
  analysis/machine/pieces.cpp
  analysis/machine/reduction.cpp
  analysis/machine/run.cpp
  analysis/machine/steady_state.cpp
  analysis/machine/step_limits.cpp
  analysis/machine/torque_breakpoints.cpp
  analysis/train/gear_train.cpp
  analysis/train/planets.cpp
  analysis/train/train_loads.cpp
  app/report/kernel/expressions.cpp
  app/report/kernel/formula.cpp
  app/report/kernel/long_integers.cpp
  app/report/kernel/machine_left_out.cpp
  app/report/kernel/machines.cpp
  app/report/machine_report_data.cpp
  problems/evaluation/whole_motion.cpp
  problems/function/target/jumps.cpp
  problems/machine/expression_jumps.cpp
  problems/machine/gearing.cpp
  problems/machine/load_travel.cpp
  problems/machine/model.cpp
  problems/machine/motion_table.cpp
  problems/machine/names.cpp
  problems/machine/notes.cpp
  problems/machine/periodic_table.cpp
  problems/machine/read.cpp
  problems/machine/read_function.cpp
  problems/machine/read_motor.cpp
  problems/machine/read_train.cpp
  problems/machine/run.cpp
  problems/machine/vanishing_inertia.cpp
  problems/toml/derivative.cpp
  problems/toml/interpolation.cpp
  problems/train/check.cpp
  problems/train/names.cpp
  problems/train/read.cpp
  problems/train/read_target.cpp
  problems/train/resolve.cpp
  problems/train/transmission.cpp)
endblock()
