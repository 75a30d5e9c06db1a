/// @file The files that `cognate new` writes: commands/new/KIND.toml, in the program as they stand.
#pragma once

#include <span>
#include <string_view>

namespace cognate::app {

struct Starter {
  std::string_view kind;
  std::string_view text;
};

/// By kind, in the order of the alphabet.
std::span<const Starter> starters();

}  // namespace cognate::app
