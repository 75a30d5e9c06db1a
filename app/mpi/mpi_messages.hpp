/// @file What the processes of a study say to one another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

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

}  // namespace cognate::app
