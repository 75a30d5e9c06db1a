/// @file How the program with MPI begins and ends, and what its processes agree on.
#include <fcntl.h>
#include <fmt/core.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "app/console/messages.hpp"
#include "app/mpi/mpi_worker_pool.hpp"
#include "app/study/processes.hpp"

namespace cognate::app {
namespace {

/// Of several processes on one machine, each takes one processor by default.
int threads_of_one(int asked) {
  return std::max(asked, 1);
}

/// What all have to say is said once.
void fall_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere == -1) return;
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

class MpiProcesses : public StudyProcesses {
 public:
  MpiProcesses(int rank, int count) : rank_(rank), count_(count) {}
  ~MpiProcesses() override {
    if (!agreed_) MpiProcesses::agree(false, "");
    MPI_Finalize();
  }

  bool is_first() const override { return rank_ == 0; }

  bool agree(bool ready, std::string_view input) override {
    agreed_ = true;
    const bool same = has_input_of_first(input);
    struct {
      int ready;
      int rank;
    } mine{ready && same ? 1 : 0, rank_}, least{};
    MPI_Allreduce(&mine, &least, 1, MPI_2INT, MPI_MINLOC, MPI_COMM_WORLD);
    if (least.ready == 1) return true;
    if (ready && is_first()) {
      complain(
          fmt::format("process {} does not read the same study and base file, or has another "
                      "build of Cognate; every machine has to see the same files",
                      least.rank));
    }
    return false;
  }

  std::unique_ptr<StudyCrew> crew(const EvaluatorMaker& maker, WorkList& work,
                                  int threads) override {
    return std::make_unique<MpiCrew>(maker, work, count_ - 1, threads_of_one(threads));
  }

  void serve(const EvaluatorMaker& maker, int threads) override {
    serve_first(maker, threads_of_one(threads));
  }

 private:
  bool has_input_of_first(std::string_view input) const {
    auto size = static_cast<int>(input.size());
    MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::string first(is_first() ? input : "");
    first.resize(static_cast<std::size_t>(size));
    MPI_Bcast(first.data(), size, MPI_CHAR, 0, MPI_COMM_WORLD);
    return first == input;
  }

  int rank_;
  int count_;
  bool agreed_ = false;
};

}  // namespace

std::unique_ptr<StudyProcesses> begin_processes(int argc, char** argv) {
  int threads = MPI_THREAD_SINGLE;
  // The thread that calls MPI first is the only one that ever does.
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &threads);
  int rank = 0;
  int count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  if (rank != 0) fall_silent();
  return std::make_unique<MpiProcesses>(rank, count);
}

}  // namespace cognate::app
