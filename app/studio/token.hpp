/// @file Secrets by which the server knows the pages that it has served itself.
#pragma once

#include <string>
#include <string_view>

namespace cognate::app {

/// 128 bits from the operating system's source of random numbers, as 32 hexadecimal digits. Throws
/// std::system_error where there is none.
std::string random_token();

/// Whether both are equal, in a time that depends on their lengths alone.
bool is_same_secret(std::string_view one, std::string_view other);

}  // namespace cognate::app
