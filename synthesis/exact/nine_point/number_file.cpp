#include "synthesis/exact/nine_point/number_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

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
  // A name of its own for each process and call, so that none renames what another is still
  // writing.
  static std::atomic<unsigned> calls{0};
  std::filesystem::path draft = file;
  draft += "." + std::to_string(getpid()) + "." + std::to_string(++calls);
  {
    std::ofstream out(draft, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(reinterpret_cast<const char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    out.close();
    if (!out) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) std::filesystem::rename(draft, file, error);
  const bool written = !error;
  if (!written) std::filesystem::remove(draft, error);
  return written;
}

}  // namespace cognate::synthesis::nine_point
