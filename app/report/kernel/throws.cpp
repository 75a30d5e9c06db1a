/// @file What other libraries throw in the kernel of the pages, which has no exceptions.
#include <boost/throw_exception.hpp>
#include <cstddef>

/// Where Boost finds a fault the module stops, which the page sees as an error of the call.
void boost::throw_exception(const std::exception& /*fault*/, const source_location& /*where*/) {
  __builtin_trap();
}

// What its headers throw ends the call, too.
extern "C" {
// NOLINTBEGIN(*-reserved-identifier)
void* __cxa_allocate_exception(std::size_t /*size*/) noexcept {
  __builtin_trap();
}
[[noreturn]] void __cxa_throw(void* /*thrown*/, void* /*type*/, void (* /*destroy*/)(void*)) {
  __builtin_trap();
}
// NOLINTEND(*-reserved-identifier)
}
