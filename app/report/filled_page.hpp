/// @file Data put into the report pages.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace cognate::app {

/// `page` (of page.hpp) with `data` in its place, as JSON that no text in it can break out of, and
/// the units that it shows: of limits over the cycle, and of lengths, one of the words of
/// `length_unit`; empty where there is none.
std::string filled_page(std::string page, const nlohmann::ordered_json& data,
                        std::string_view length_unit);

/// `page` without one of its kernels, the script `name`: they are large, and not every page needs
/// them.
std::string without_kernel(std::string page, std::string_view name);

/// Takes `member` out of `table` where its JSON is so long that it would make a page too large.
void erase_large(nlohmann::ordered_json& table, const char* member);

/// Whether `table` has `member` and that is so long.
bool is_large(const nlohmann::ordered_json& table, const char* member);

}  // namespace cognate::app
