/// @file What integers of any length, and the texts made of them, ask of a C library beyond
/// runtime.cpp: a guard of stacks, an environment, which a page has not, and an end.
#include <cstdint>

extern "C" {
// NOLINTBEGIN(*-reserved-identifier, *-identifier-naming, *-avoid-non-const-global-variables)
std::uintptr_t __stack_chk_guard = 0x5bd1e995;

[[noreturn]] void __stack_chk_fail() {
  __builtin_trap();
}

int __imported_wasi_snapshot_preview1_environ_sizes_get(int* count, int* size) {
  *count = *size = 0;
  return 0;
}
int __imported_wasi_snapshot_preview1_environ_get(int /*variables*/, int /*texts*/) {
  return 0;
}
[[noreturn]] void __imported_wasi_snapshot_preview1_proc_exit(int /*status*/) {
  __builtin_trap();
}
// NOLINTEND(*-reserved-identifier, *-identifier-naming, *-avoid-non-const-global-variables)
}
