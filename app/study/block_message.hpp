/// @file Blocks of rows as bytes, for another process of the same program.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "problems/study/block.hpp"

namespace cognate::app {

std::vector<std::byte> block_message(const problems::StudyBlock& block);

/// The block that became `message`. Throws std::out_of_range where the message is too short.
problems::StudyBlock block_of(std::span<const std::byte> message);

}  // namespace cognate::app
