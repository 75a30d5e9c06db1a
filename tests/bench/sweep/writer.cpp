/// @file How fast rows reach a study file: what bounds a study of many machines, where one process
/// stores what all others send.
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>

#include "app/study/block_message.hpp"
#include "app/study/checksum.hpp"
#include "app/study/columns.hpp"
#include "app/study/database.hpp"
#include "app/study/read_columns.hpp"
#include "tests/support/study_samples.hpp"

namespace {

using namespace cognate;

constexpr std::int64_t kBlock = 8192;

/// The rows of a block; with `keeps` false those of one whose designs do not pass.
problems::StudyBlock block_at(std::int64_t first, bool keeps) {
  if (!keeps) return {.first = first, .count = kBlock, .filtered = kBlock};
  return tests::sample_block(first, kBlock);
}

struct Times {
  double pack = 0;
  double unpack = 0;
  double store = 0;
};

/// Seconds of the processor since `mark`, which becomes now: what else runs does not count.
double lap(std::clock_t& mark) {
  const auto now = std::clock();
  const double seconds = static_cast<double>(now - mark) / CLOCKS_PER_SEC;
  mark = now;
  return seconds;
}

void measure(const char* what, std::int64_t blocks, bool keeps,
             std::vector<problems::StudyObjective> objectives) {
  const tests::TestFolder folder;
  auto study = tests::sample_study(1, std::move(objectives));
  study.samples = blocks * kBlock;
  app::StudyDatabase database(folder / "writer.study.db", study, {});
  Times times;
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto block = block_at(i * kBlock, keeps);
    auto mark = std::clock();
    const auto message = app::block_message(block);
    times.pack += lap(mark);
    const auto received = app::block_of(message);
    times.unpack += lap(mark);
    database.store(received);
    database.tick();
    times.store += lap(mark);
  }
  auto mark = std::clock();
  database.commit();
  times.store += lap(mark);
  const auto per = static_cast<double>(keeps ? database.counts().kept : blocks);
  fmt::print("{:34} {:>11.4g} {:>11.4g} {:>11.4g} {:>9.1f}\n", what, per / times.pack,
             per / times.unpack, per / times.store,
             static_cast<double>(std::filesystem::file_size(folder / "writer.study.db")) * 0x1p-20);
}

/// Seconds in which HDF5 gives all rows of `file`, in the portions in which they are read.
double read_seconds(const std::filesystem::path& file, const problems::Study& study) {
  constexpr std::int64_t kAtOnce = 1 << 15;
  auto mark = std::clock();
  const auto columns = app::open_columns_file(file);
  const auto rows = columns->length("runs/id").value();
  auto names = problems::study_columns(study);
  names.emplace_back("status");
  if (!columns->open_columns(names, rows)) return INFINITY;
  app::ColumnRows part;
  for (std::int64_t from = 0; from < rows; from += kAtOnce) {
    if (!columns->read(from, std::min(kAtOnce, rows - from), part)) return INFINITY;
  }
  return lap(mark);
}

/// Rows as columns: what HDF5 takes, beside what SQLite gives them at.
void measure_columns(std::int64_t blocks) {
  const tests::TestFolder folder;
  auto study = tests::sample_study(1);
  study.samples = blocks * kBlock;
  app::StudyDatabase database(folder / "writer.study.db", study, {});
  for (std::int64_t i = 0; i < blocks; ++i) database.store(block_at(i * kBlock, true));
  database.commit();
  const auto rows = static_cast<double>(database.counts().kept);

  auto mark = std::clock();
  auto reader = database.connection().prepare("SELECT * FROM runs ORDER BY id");
  while (reader.step()) continue;
  const double stepped = lap(mark);
  const std::atomic<bool> stopped{false};
  if (!app::find_columns_module()) return fmt::print("\nno columns: HDF5 is missing\n");
  const auto written = app::write_columns(folder / "writer.study.h5", database.connection(), study,
                                          stopped, [](std::int64_t) {});
  const double whole = lap(mark);
  fmt::print(
      "\nrows as columns per processor second: {:.3g} ({}), {:.2f} of SQLite's steps alone\n",
      rows / whole, written ? "whole" : written.error(), stepped / whole);
  const double read = read_seconds(folder / "writer.study.h5", study);
  fmt::print("rows read from columns: {:.3g}, {:.2f} of SQLite's steps alone\n", rows / read,
             stepped / read);
  lap(mark);
  auto taken = app::study_rows(folder / "writer.study.h5");
  const double loaded = lap(mark);
  app::check_rows(taken);
  const double checked = lap(mark);
  app::check_rows(database.connection());
  fmt::print(
      "put into a database: {:.3g}, {:.2f} of SQLite's steps; with their checksums {:.2f} of a "
      "database with its own\n",
      rows / loaded, stepped / loaded, lap(mark) / (loaded + checked));
  lap(mark);
  const auto last = database.connection().integer("SELECT max(id) FROM runs");
  auto one = app::study_rows(folder / "writer.study.h5", {.first = last, .most = 1});
  app::check_rows(one, last);
  fmt::print("one row of them: {:.2g} ms\n", 1e3 * lap(mark));
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t blocks = argc > 1 ? std::atoll(argv[1]) : 256;
  fmt::print("{} blocks of {} designs; a row has 4 columns apart from id and status\n\n", blocks,
             kBlock);
  fmt::print("{:34} {:>11} {:>11} {:>11} {:>9}\n", "per processor second", "packed", "unpacked",
             "stored", "MiB");
  measure("rows, no objective", blocks, true, {});
  measure("rows, one objective", blocks, true, {{.name = "a.first"}});
  measure("rows, two objectives", blocks, true,
          {{.name = "a.first"}, {.name = "second", .greatest = true}});
  measure("rows, three objectives", blocks, true,
          {{.name = "a.first"}, {.name = "second", .greatest = true}, {.name = "mechanism.crank"}});
  measure("blocks without a row", 64 * blocks, false, {});
  measure_columns(blocks);
  struct rusage used {};
  getrusage(RUSAGE_SELF, &used);
  fmt::print("\npeak memory {} MiB\n", used.ru_maxrss / 1024);
}
