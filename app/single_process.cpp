/// @file How the program without MPI begins: where mpirun started it to sweep, it becomes the one
/// with MPI beside it, so that all other runs need not load MPI.
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "app/console/messages.hpp"
#include "app/study/processes.hpp"

namespace cognate::app {
namespace {

int number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : 0;
}

/// Started with others, by Open MPI, by MPICH and its kin, or by Slurm through PMIx.
bool is_one_of_many() {
  const bool by_slurm = std::getenv("PMIX_RANK") != nullptr && number_in("SLURM_NTASKS") > 1;
  return number_in("OMPI_COMM_WORLD_SIZE") > 1 || number_in("PMI_SIZE") > 1 || by_slurm;
}

bool is_first_of_many() {
  for (const char* variable : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"}) {
    if (std::getenv(variable) != nullptr) return number_in(variable) == 0;
  }
  return true;
}

}  // namespace

std::unique_ptr<StudyProcesses> begin_processes(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "sweep" && is_one_of_many()) {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::string with_mpi = (self.parent_path() / "cognate-mpi").string();
    ::execv(with_mpi.c_str(), argv);
    if (is_first_of_many()) {
      complain(
          "one of several processes, but Cognate was built without MPI; install "
          "libopenmpi-dev and openmpi-bin and build again, or call it without mpirun");
    }
    return nullptr;
  }
  return std::make_unique<StudyProcesses>();
}

}  // namespace cognate::app
