#include "problems/machine/read_train.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

#include "problems/machine/keys.hpp"
#include "problems/toml/file_text.hpp"
#include "problems/toml/nearest.hpp"
#include "problems/toml/text_check.hpp"
#include "problems/train/transmission.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kTrain = "train";
constexpr std::string_view kWantedTrain =
    "expected the path of a file of kind = \"gear-train\", or its tables under [motor.train]";

/// The train in `table`, whose kind may be left out where it stands in another file.
GearTrainProblem read_train_tables(TableReader& table, const std::filesystem::path& folder,
                                   bool needs_kind) {
  constexpr std::string_view kWord = KindTraits<GearTrainProblem>::kWord;
  if (table.has("kind") || needs_kind) {
    const auto kind = table.text("kind");
    if (!kind && !table.has("kind")) {
      table.fault("kind", fmt::format("is missing; expected \"{}\"", kWord));
    }
    if (kind && *kind != kWord) {
      table.fault("kind", fmt::format("is {}; expected \"{}\"", in_quotes(*kind), kWord));
      return {};
    }
  }
  const auto title = table.text("title").value_or("");
  const auto length_unit = table.choice<LengthUnit>("length_unit");
  if (!table.faults().empty() && needs_kind) return {};
  GearTrainProblem train = KindTraits<GearTrainProblem>::read(table, folder);
  train.title = title;
  train.length_unit = length_unit;
  table.finish();
  return train;
}

/// The document that `text` is, or the first thing wrong with it.
tl::expected<Table, Fault> parsed(std::string_view text) {
  if (const auto fault = check_is_text(text)) return tl::unexpected(*fault);
  if (const auto fault = check_key_depth(text)) return tl::unexpected(*fault);
  return parse_document(text);
}

/// The train in `text`, or the first thing wrong with it.
tl::expected<GearTrainProblem, Fault> train_in(std::string_view text,
                                               const std::filesystem::path& folder) {
  return parsed(text).and_then([&](const Table& document) -> tl::expected<GearTrainProblem, Fault> {
    FaultList faults;
    TableReader reader(document, faults);
    GearTrainProblem train = read_train_tables(reader, folder, true);
    if (!faults.empty()) return tl::unexpected(std::move(faults).sorted().front());
    return train;
  });
}

std::optional<GearTrainProblem> read_train_file(TableReader& motor, const std::string& name,
                                                const std::filesystem::path& folder) {
  if (folder.empty()) {
    motor.fault(kTrain,
                "names a file beside the problem file, but there is none; give the tables of the "
                "train under [motor.train]");
    return std::nullopt;
  }
  const auto file = folder / name;
  const auto text = name.empty()
                        ? tl::unexpected(fmt::format("the name is empty; {}", kWantedTrain))
                        : text_of(file, NamedBy::other_file);
  if (!text) {
    motor.fault(kTrain, fmt::format("is {}: {}", in_quotes(name), text.error()));
    return std::nullopt;
  }
  auto train = train_in(*text, file.parent_path());
  if (train) return *std::move(train);
  const Fault& first = train.error();
  motor.fault(kTrain, fmt::format("{} has a fault of its own, at {}:{}: {}", in_quotes(name),
                                  first.line, first.column, first.message));
  return std::nullopt;
}

/// The train alone, complete if no fault was added.
std::optional<MotorTrain> read_whole_train(TableReader& motor, const TrainContext& context) {
  if (motor.has_text(kTrain)) {
    const auto name = motor.text(kTrain);
    auto train = read_train_file(motor, *name, context.folder);
    if (!train) return std::nullopt;
    return MotorTrain{.train = *std::move(train), .file = *name};
  }
  if (!motor.has_table(kTrain)) {
    motor.fault(kTrain, fmt::format("is neither a text nor a table; {}", kWantedTrain));
    return std::nullopt;
  }
  const std::size_t before = motor.faults().size();
  TableReader table = motor.table(kTrain);
  MotorTrain read{.train = read_train_tables(table, context.folder, false), .file = {}};
  if (motor.faults().size() > before) return std::nullopt;
  if (!read.train.length_unit) read.train.length_unit = context.length_unit;
  return read;
}

void refuse_besides_train(TableReader& motor) {
  for (const std::string_view key : {"ratio", "efficiency"}) {
    if (!motor.has(key)) continue;
    motor.fault(key, "is given beside motor.train, from which it follows; remove one of them");
  }
}

void check_transmission(TableReader& motor, const MotorTrain& train) {
  const auto found = transmission(train.train, {train.input, train.output, train.state});
  if (!found) {
    const auto& [key, message] = found.error();
    const std::string file = train.file.empty() || key != kTrain ? "" : in_quotes(train.file) + " ";
    motor.fault(key, file + message);
    return;
  }
  const auto ratio = found->ratio.convert_to<double>();
  if (kMotorRatio.accepts(std::abs(ratio)) && kMotorEfficiency.accepts(found->efficiency)) return;
  motor.fault(kTrain,
              fmt::format("has the ratio {:.6g} and the efficiency {:.6g}; expected "
                          "in magnitude {} and {}",
                          ratio, found->efficiency, kMotorRatio.allowed, kMotorEfficiency.allowed));
}

}  // namespace

std::optional<MotorTrain> read_motor_train(TableReader& motor, const TrainContext& context) {
  if (!motor.has(kTrain)) {
    for (const auto& key : kMotorTrainKeys) {
      if (motor.has(key.name)) {
        motor.fault(key.name, "is given without motor.train, whose part it is; remove it");
      }
    }
    return std::nullopt;
  }
  refuse_besides_train(motor);
  auto train = read_whole_train(motor, context);
  MotorTrain unread;
  const std::size_t before = motor.faults().size();
  read_keys(motor, kMotorTrainKeys, train ? *train : unread);
  if (train && motor.faults().size() == before) check_transmission(motor, *train);
  return train;
}

}  // namespace cognate::problems::reading
