#include "problems/path/curve/svg_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <pugixml.hpp>
#include <string_view>
#include <system_error>
#include <vector>

#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::uintmax_t kMostBytes = 8U << 20U;
/// How many ids a message names.
constexpr std::size_t kMostNamed = 8;

/// The name of an element without its namespace: "svg:path" is a path.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

/// Whether what the element holds is drawn where it stands.
bool draws(const pugi::xml_node& node) {
  constexpr std::string_view kUndrawn[] = {"defs", "symbol", "clipPath",
                                           "mask", "marker", "pattern"};
  return std::ranges::find(kUndrawn, local_name(node)) == std::end(kUndrawn);
}

bool is_transformed(pugi::xml_node node) {
  for (; node; node = node.parent()) {
    const std::string_view style = node.attribute("style").value();
    if (node.attribute("transform") || style.find("transform") != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

/// Every path of a document, and those of them that are drawn; pugixml walks without recursion.
class Paths final : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    const auto level = static_cast<std::size_t>(depth());
    drawn_to_.resize(level);
    drawn_to_.push_back((level == 0 || drawn_to_.back()) && draws(node));
    if (local_name(node) != "path") return true;
    all.push_back(node);
    if (drawn_to_.back()) drawn.push_back(node);
    return true;
  }
  std::vector<pugi::xml_node> all, drawn;

 private:
  std::vector<bool> drawn_to_;  ///< of each element from the root to where the walk is
};

std::string ids_of(const std::vector<pugi::xml_node>& paths) {
  std::vector<std::string_view> ids;
  for (const pugi::xml_node& path : paths) {
    if (path.attribute("id") && ids.size() < kMostNamed)
      ids.push_back(path.attribute("id").value());
  }
  return ids.empty() ? "none of them has an id" : "ids are " + quoted_list(ids);
}

tl::expected<pugi::xml_node, std::string> chosen(const Paths& paths,
                                                 const std::optional<std::string>& id) {
  const std::vector<pugi::xml_node>& all = paths.all;
  std::vector<pugi::xml_node> fitting = paths.drawn;
  if (id) {
    fitting.clear();
    std::ranges::copy_if(all, std::back_inserter(fitting), [&](const pugi::xml_node& path) {
      return path.attribute("id") && path.attribute("id").value() == *id;
    });
  }
  if (fitting.size() == 1) return fitting.front();
  if (fitting.empty()) {
    return tl::unexpected(
        all.empty() ? "has no <path>; expected one that is drawn in it"
                    : fmt::format("has no such <path> among {}; {}", all.size(), ids_of(all)));
  }
  return tl::unexpected(fmt::format("has {} paths{}; svg_id = \"...\" chooses by id, and {}",
                                    fitting.size(), id ? " of this id" : "", ids_of(fitting)));
}

}  // namespace

tl::expected<std::string, std::string> path_data_of(const std::filesystem::path& file,
                                                    const std::optional<std::string>& id) {
  std::error_code error;
  // What is no regular file might never end.
  if (!std::filesystem::is_regular_file(file, error)) {
    return tl::unexpected<std::string>("is no file; expected an SVG file beside the problem file");
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > kMostBytes) {
    return tl::unexpected<std::string>("is larger than 8 MiB; at most 8 MiB are allowed");
  }
  pugi::xml_document document;
  const pugi::xml_parse_result read = document.load_file(file.c_str());
  if (!read) {
    return tl::unexpected(fmt::format("is no XML at byte {} ({}); expected an SVG file",
                                      read.offset, read.description()));
  }
  Paths paths;
  document.traverse(paths);
  return chosen(paths, id).and_then(
      [](const pugi::xml_node& path) -> tl::expected<std::string, std::string> {
        if (is_transformed(path)) {
          return tl::unexpected<std::string>(
              "has a transform on this path or around it, which is not applied; expected a path "
              "without any (drawing programs apply them when shapes are ungrouped or made paths)");
        }
        return std::string(path.attribute("d").value());
      });
}

}  // namespace cognate::problems::reading
