#include "synthesis/exact/nine_point/number_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "synthesis/whole_file.hpp"

namespace cognate::synthesis::nine_point {
namespace {

/// To be raised whenever other numbers are found or written otherwise.
constexpr std::uint64_t kVersion = 2;
constexpr char kName[8] = {'c', 'o', 'g', 's', 't', 'a', 'r', 't'};

struct Header {
  char name[8];
  std::uint64_t version;
  FileKey key;
  std::uint64_t numbers, checksum;
};

/// FNV-1a of all bytes.
std::uint64_t checksum(const std::vector<double>& numbers) {
  std::uint64_t sum = 0xcbf29ce484222325;
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  for (std::size_t i = 0; i < numbers.size() * sizeof(double); ++i) {
    sum = (sum ^ bytes[i]) * 0x100000001b3;
  }
  return sum;
}

Header header_of(const FileKey& key, const std::vector<double>& numbers) {
  Header header{{}, kVersion, key, numbers.size(), checksum(numbers)};
  std::copy(std::begin(kName), std::end(kName), header.name);
  return header;
}

}  // namespace

std::optional<std::vector<double>> read_numbers(const std::filesystem::path& file,
                                                const FileKey& key, std::size_t most) {
  std::error_code error;
  // What is no regular file might never end.
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  Header header{};
  in.read(reinterpret_cast<char*>(&header), sizeof header);
  if (!in || header.numbers > most) return std::nullopt;
  std::vector<double> numbers(header.numbers);
  in.read(reinterpret_cast<char*>(numbers.data()),
          static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  const Header wanted = header_of(key, numbers);
  if (!in || std::memcmp(&header, &wanted, sizeof header) != 0) return std::nullopt;
  if (!std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) {
    return std::nullopt;
  }
  return numbers;
}

bool write_numbers(const std::filesystem::path& file, const FileKey& key,
                   const std::vector<double>& numbers) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const Header header = header_of(key, numbers);
  std::string bytes(sizeof header + numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  if (!numbers.empty()) {
    std::memcpy(bytes.data() + sizeof header, numbers.data(), numbers.size() * sizeof(double));
  }
  return write_whole_file(file, bytes) == 0;
}

}  // namespace cognate::synthesis::nine_point
