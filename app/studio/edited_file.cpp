#include "app/studio/edited_file.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <system_error>
#include <utility>

#include "app/console/messages.hpp"
#include "app/documents/output_files.hpp"
#include "app/studio/local_server.hpp"
#include "problems/toml/file_text.hpp"
#include "problems/toml/text_check.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

namespace reading = problems::reading;

/// So that a text with every character escaped still fits a request.
constexpr std::size_t kGreatestText = LocalServer::kGreatestBody / 2;

tl::expected<std::string, std::string> text_on_disk(const fs::path& file) {
  const auto cannot_edit = [&](std::string_view why) {
    return tl::unexpected(fmt::format("cannot edit '{}': {}", file.string(), why));
  };
  auto text = reading::text_of(file, reading::NamedBy::other_file);
  if (!text) return cannot_edit(text.error());
  if (text->size() > kGreatestText) return cannot_edit("is larger than 512 KiB");
  if (const auto fault = reading::check_is_text(*text)) return cannot_edit(fault->message);
  return *std::move(text);
}

}  // namespace

tl::expected<std::unique_ptr<EditedFile>, std::string> EditedFile::open(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  auto text = text_on_disk(error ? file : real);
  if (!text) return tl::unexpected(printable(text.error()));
  return std::unique_ptr<EditedFile>(new EditedFile(real, std::move(*text)));
}

EditedFile::EditedFile(fs::path path, std::string text)
    : path_(std::move(path)), watch_(path_), version_{1, std::move(text)} {}

FileVersion EditedFile::version() const {
  const std::lock_guard lock(mutex_);
  return version_;
}

bool EditedFile::take(tl::expected<std::string, std::string> text) {
  if (!text || *text == version_.text) return false;
  version_ = {version_.number + 1, std::move(*text)};
  return true;
}

bool EditedFile::look() {
  const std::lock_guard lock(mutex_);
  if (!watch_.has_changed()) return false;
  auto text = text_on_disk(path_);
  // What is read while another program writes is half a text; the whole one is reported in its
  // turn.
  return watch_.is_as_reported() && take(std::move(text));
}

tl::expected<FileVersion, SaveFault> EditedFile::save(std::string_view text, std::uint64_t edited) {
  const std::lock_guard lock(mutex_);
  take(text_on_disk(path_));
  if (edited != version_.number) {
    return tl::unexpected(SaveFault{true, "the file has been saved by another program meanwhile"});
  }
  std::error_code error;
  const auto before = fs::status(path_, error);
  if (const auto written = write_file(path_, text); !written) {
    return tl::unexpected(SaveFault{false, written.error()});
  }
  // Whom the owner keeps from reading the file must not read the new one.
  if (!error && fs::exists(before)) fs::permissions(path_, before.permissions(), error);
  version_ = {version_.number + 1, std::string(text)};
  return version_;
}

}  // namespace cognate::app
