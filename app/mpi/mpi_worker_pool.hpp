/// @file The crew of a study that runs in many processes, seen from the first and from the others.
#pragma once

#include <memory>
#include <vector>

#include "app/mpi/mpi_messages.hpp"
#include "app/study/crew.hpp"

namespace cognate::app {

/// Hands out work to the other processes as they ask for it and takes in their blocks; where there
/// are few of them, threads of this process evaluate as well.
class MpiCrew : public StudyCrew {
 public:
  /// `others`: the processes besides this one, which evaluate with `threads` each.
  MpiCrew(const EvaluatorMaker& maker, WorkList& work, int others, int threads);
  /// Ends the others.
  ~MpiCrew() override;

  std::optional<problems::StudyBlock> wait(std::chrono::milliseconds patience) override;
  void stop() override;
  bool is_finished() override;
  int size() const override;

 private:
  std::optional<problems::StudyBlock> take(const MpiMessage& message);
  void hand_out(int receiver, std::int64_t count);

  WorkList& work_;
  int threads_;
  std::vector<bool> present_;  ///< by rank: has not said `done`
  int others_;                 ///< how many of them have not
  bool stopped_ = false;
  std::string fault_;
  std::unique_ptr<ThreadCrew> own_;  ///< none where there are many others
};

/// Of a process other than the first: evaluates what that hands out until it has no more, or one of
/// the two is interrupted.
void serve_first(const EvaluatorMaker& maker, int threads);

}  // namespace cognate::app
