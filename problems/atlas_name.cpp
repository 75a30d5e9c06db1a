#include "problems/atlas_name.hpp"

#include "problems/reading/file_text.hpp"
#include "problems/reading/key_path.hpp"
#include "problems/reading/task_document.hpp"

namespace cognate::problems {

std::optional<std::string> atlas_name(const std::filesystem::path& file) {
  const auto text = reading::text_of(file);
  if (!text) return std::nullopt;
  auto table = reading::read_text(*text);
  if (!table) return std::nullopt;
  const auto* const node = reading::find_node(*table, {"solve", "atlas"});
  if (!node) return std::nullopt;
  const auto* const name = std::get_if<std::string>(&node->value);
  return name ? std::optional(*name) : std::nullopt;
}

}  // namespace cognate::problems
