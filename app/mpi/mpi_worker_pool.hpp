/// @file The crew of a study that runs in many processes, seen from the first and from the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/study/crew.hpp"
#include "app/study/design_range.hpp"

namespace cognate::app {

/// From the first process to another: `work` (a DesignRange), `no_more` work, `stop` now,
/// `farewell` (the last message). To the first: `want` (how many blocks of work, a count), `block`
/// (its rows; wants one more), `fault` (its words), `done` (the last message, answered by
/// `farewell`).
enum class MpiTag { work, no_more, stop, farewell, want, block, fault, done };

struct MpiMessage {
  int sender = 0;
  MpiTag tag = MpiTag::work;
  std::vector<std::byte> bytes;
};

/// The next message that has come, if one has.
std::optional<MpiMessage> received_message();

void send_message(int receiver, MpiTag tag, std::span<const std::byte> bytes = {});
void send_text(int receiver, MpiTag tag, std::string_view text);
void send_range(int receiver, const DesignRange& range);
void send_count(int receiver, std::int64_t count);

DesignRange range_of(const MpiMessage& message);
std::int64_t count_of(const MpiMessage& message);
std::string_view text_of(const MpiMessage& message);

/// Hands out work to the other processes as they ask for it and takes in their blocks; where there
/// are few of them, threads of this process evaluate as well.
class MpiCrew : public StudyCrew {
 public:
  /// `others`: the other processes, which evaluate with `threads` each.
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
