#include "app/python/watch.hpp"

#include <pthread.h>

#include <chrono>
#include <exception>
#include <set>
#include <string>
#include <thread>

#include "problems/basics/names.hpp"

namespace cognate::python {
namespace {

using namespace std::chrono_literals;

/// The computations that run now, for the end of the interpreter alone.
struct Running {
  std::mutex guard;
  std::condition_variable left;
  std::set<Watch*> watches;
};

Running& running() {
  static Running all;
  return all;
}

/// In a forked process the computations of the other threads do not run, and never end.
void forget_in_forks() {
  pthread_atfork([] { running().guard.lock(); }, [] { running().guard.unlock(); },
                 [] {
                   running().watches.clear();
                   running().guard.unlock();
                 });
}

}  // namespace

Watch::Watch() {
  static std::once_flag once;
  std::call_once(once, forget_in_forks);
  const std::scoped_lock lock(running().guard);
  running().watches.insert(this);
}

Watch::~Watch() {
  {
    const std::scoped_lock lock(running().guard);
    running().watches.erase(this);
  }
  running().left.notify_all();
}

void Watch::report(double share, double best) {
  const std::scoped_lock lock(guard_);
  progress_.update(share, best);
  has_news_ = true;
}

void Watch::enter(problems::Phase begun, double to) {
  const std::scoped_lock lock(guard_);
  progress_.enter(problems::to_string(begun), to);
  has_news_ = true;
}

bool Watch::wait() {
  std::unique_lock lock(guard_);
  return change_.wait_for(lock, 50ms, [&] { return is_done_; });
}

void Watch::keep(py::object& raised) {
  interrupted_ = true;
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  if (trace != nullptr) PyException_SetTraceback(value, trace);
  Py_XDECREF(type);
  Py_XDECREF(trace);
  raised = py::reinterpret_steal<py::object>(value);
}

void Watch::heed(py::object& raised) {
  const bool is_first = !interrupted_ && PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) != 0;
  if (!is_first) return keep(raised);
  PyErr_Clear();
  interrupted_ = true;
}

void Watch::listen(const py::object& progress, py::object& raised) {
  if (PyErr_CheckSignals() != 0) heed(raised);
  if (progress.is_none() || !raised.is_none()) return;
  double share = 0, best = 0;
  std::string part, words;
  {
    const std::scoped_lock lock(guard_);
    if (!std::exchange(has_news_, false)) return;
    share = progress_.share();
    best = progress_.best();
    part = progress_.part().words;
    words = progress_.words(app::RunProgress::Clock::now());
  }
  const auto shown = py::reinterpret_steal<py::object>(
      PyObject_CallFunction(progress.ptr(), "ddss", share, best, part.c_str(), words.c_str()));
  if (!shown) heed(raised);  // Ctrl-C may come while progress is shown
}

void Watch::run(const py::object& progress, const std::function<void()>& work) {
  std::exception_ptr thrown;
  py::object raised = py::none();
  {
    const py::gil_scoped_release unlocked;
    std::thread worker([&] {
      try {
        work();
      } catch (...) {
        thrown = std::current_exception();
      }
      {
        const std::scoped_lock lock(guard_);
        is_done_ = true;
      }
      change_.notify_one();
    });
    while (!wait()) {
      const py::gil_scoped_acquire locked;
      listen(progress, raised);
    }
    worker.join();
  }
  if (thrown) std::rethrow_exception(thrown);
  if (raised.is_none()) return;
  PyErr_SetObject(py::type::handle_of(raised).ptr(), raised.ptr());
  throw py::error_already_set();
}

void end_all() {
  const py::gil_scoped_release unlocked;
  std::unique_lock lock(running().guard);
  for (Watch* watch : running().watches) watch->interrupt();
  running().left.wait_for(lock, 30s, [] { return running().watches.empty(); });
}

}  // namespace cognate::python
