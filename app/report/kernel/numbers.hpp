/// @file What the kernel in a page is called through: functions without arguments or with counts
/// alone, and one block of numbers that both sides read and write.
#pragma once

#include <span>

/// Makes a function one that the page can call, by `name`.
#ifdef __wasm__
#define COGNATE_EXPORT(name) extern "C" __attribute__((export_name(#name), used))
#else
#define COGNATE_EXPORT(name) extern "C"
#endif

namespace cognate::page {

/// Room for 65536 numbers: what a call takes lies at its start, and what it gives replaces that.
std::span<double> numbers();

}  // namespace cognate::page
