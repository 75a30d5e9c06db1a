/// @file One design of a result file, before it is understood.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "problems/basics/length_unit.hpp"

namespace cognate::app {

struct ResultDesign {
  nlohmann::ordered_json problem;  ///< the table `problem` of the document, whatever it holds
  nlohmann::ordered_json table;    ///< an object; its `mechanism` is one with a `type`
  int design = 1;                  ///< counted from 1
  std::string name;                ///< what messages call the document
};

/// The result document in `file`, a `cognate-result/1`. The error is a message that begins with the
/// file's name: what is wrong; what is allowed.
tl::expected<nlohmann::ordered_json, std::string> read_result(const std::filesystem::path& file);

/// NAME of NAME.result.json.
std::string stem_of_result(const std::filesystem::path& file);

/// The string under `key` of `table`; empty where there is none.
std::string text_under(const nlohmann::ordered_json& table, const char* key);

/// Design number `design`, counted from 1, of the result document in `file`. The error is a message
/// that begins with the file's name: what is wrong; what is allowed.
tl::expected<ResultDesign, std::string> read_result_design(const std::filesystem::path& file,
                                                           int design);

/// `design` of a problem whose lengths are in `unit`, where the document names none. The error says
/// that it names another one.
tl::expected<ResultDesign, std::string> in_length_unit(ResultDesign design,
                                                       std::optional<problems::LengthUnit> unit);

/// The unit of the problem's lengths, where the document names one.
std::optional<problems::LengthUnit> length_unit_of(const ResultDesign& design);

/// `kind`, and of the problem `title` and `length_unit`: how a file made of the design begins.
nlohmann::ordered_json head_of(const ResultDesign& design, std::string_view kind);

/// The same for the text of a document; `name` is what messages call it.
tl::expected<ResultDesign, std::string> parse_result_design(std::string_view text, int design,
                                                            const std::string& name);

/// The same of a document that has been read.
tl::expected<ResultDesign, std::string> result_design(const nlohmann::ordered_json& document,
                                                      int design, const std::string& name);

}  // namespace cognate::app
