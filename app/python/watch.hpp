/// @file Long computations beside the interpreter: its lock released, Ctrl-C heard, progress shown.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "app/console/run_progress.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::python {

namespace py = pybind11;

/// What a computation is given to look at and to report to; any of its threads may.
class Watch {
 public:
  Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch();

  /// True once it is to end.
  const std::atomic<bool>& interrupted() const { return interrupted_; }
  void interrupt() { interrupted_ = true; }

  /// `share` in [0, 1]; `best` may be infinite.
  void report(double share, double best);
  /// A part of the run begins, as Run::phase has it.
  void enter(problems::Phase begun, double to);

  /// Runs `work` in a thread of its own while this one, which holds the interpreter's lock, gives
  /// it up and listens. The first Ctrl-C ends the computation in good order and raises nothing:
  /// what was found until then is its answer. A second one, and anything else that a handler of
  /// signals raises, and what `progress` raises is raised once `work` has ended, as is what `work`
  /// throws. `progress`, called with a share, the best value so far, the part of the run and all
  /// of that in words, may be None.
  void run(const py::object& progress, const std::function<void()>& work);

 private:
  bool wait();
  void listen(const py::object& progress, py::object& raised);
  /// Of the exception that is set: the first Ctrl-C ends the computation, all else is kept.
  void heed(py::object& raised);
  void keep(py::object& raised);

  std::atomic<bool> interrupted_{false};
  std::mutex guard_;
  std::condition_variable change_;
  bool is_done_ = false;
  bool has_news_ = false;
  app::RunProgress progress_;
};

/// Ends what is running and waits until all of it has returned: before the interpreter ends, which
/// threads that still run would not survive.
void end_all();

}  // namespace cognate::python
