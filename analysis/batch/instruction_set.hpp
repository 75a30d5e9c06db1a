/// @file Which vector instructions a batch uses.
#pragma once

#include <span>

namespace cognate {

/// `scalar` is portable C++; the others are of x86-64: `avx2` with FMA, `avx512` with the F, DQ, BW
/// and CD parts.
enum class InstructionSet { scalar, sse2, avx2, avx512 };

/// The sets that this machine and this build have, the widest last.
std::span<const InstructionSet> instruction_sets();

/// "scalar", "sse2", "avx2" or "avx512".
const char* name(InstructionSet set);

}  // namespace cognate
