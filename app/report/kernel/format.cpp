/// @file The parts of the library of formatted text that the kernel calls, which the program links.
#define FMT_STATIC_THOUSANDS_SEPARATOR ','
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
template void detail::buffer<char>::append(const char*, const char*);
template void detail::vformat_to(detail::buffer<char>&, string_view,
                                 basic_format_args<FMT_BUFFER_CONTEXT(char)>, detail::locale_ref);
template auto detail::thousands_sep_impl(detail::locale_ref) -> detail::thousands_sep_result<char>;
template char detail::decimal_point_impl(detail::locale_ref);
FMT_END_NAMESPACE
