#include "app/studio/token.hpp"

#include <fmt/core.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace cognate::app {

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  // So few bytes come whole or not at all.
  while (::getrandom(bytes.data(), bytes.size(), 0) != std::ssize(bytes)) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "no random token");
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool is_same_secret(std::string_view one, std::string_view other) {
  if (one.size() != other.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    difference |= static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(other[i]);
  }
  return difference == 0;
}

}  // namespace cognate::app
