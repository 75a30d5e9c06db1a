#include "problems/machine/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<MachineTask> kMachineTasks[] = {
    {"steady", MachineTask::steady}, {"start", MachineTask::start}, {"stop", MachineTask::stop}};

}  // namespace

template <>
std::span<const Named<MachineTask>> names<MachineTask>() {
  return kMachineTasks;
}

}  // namespace cognate::problems
