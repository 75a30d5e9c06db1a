/// @file Damaged study files: what is broken, be it on a page, in a block or in the front, is
/// refused, and what is whole again is taken.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "app/study/database.hpp"
#include "tests/support/study_samples.hpp"

namespace cognate::app::study_damage_test {
namespace {

using problems::Study;
using tests::sample_block;
using tests::sample_study;
using tests::TestFolder;

const StudyOrigin kOrigin{.text = "base = 'base.toml'\n", .version = "1.2.3", .seed = 4};

std::vector<std::string> strings(const std::filesystem::path& file, const char* sql) {
  SqliteDatabase database(file, SqliteDatabase::Access::read);
  auto rows = database.prepare(sql);
  std::vector<std::string> texts;
  while (rows.step()) texts.push_back(rows.text(0));
  return texts;
}

/// The message with which the file is refused; empty if it is not.
std::string refusal(const std::filesystem::path& file, const Study& study,
                    const StudyOrigin& origin) {
  try {
    StudyDatabase database(file, study, origin);
  } catch (const StudyFileError& error) {
    return error.what();
  }
  return "";
}

TEST(StudyDatabase, RefusesADamagedFile) {
  const TestFolder folder;
  const auto file = folder / "a.study.db";
  const auto study = sample_study(20'000);
  {
    StudyDatabase database(file, study, kOrigin);
    database.store(sample_block(0, 20'000));
    database.commit();
  }
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file) / 2));
  bytes << std::string(8192, '\xA5');
  bytes.close();
  EXPECT_NE(refusal(file, study, kOrigin).find("is damaged"), std::string::npos);
}

TEST(StudyDatabase, RefusesAFrontThatIsNotThatOfItsRows) {
  const TestFolder folder;
  const auto file = folder / "a.study.db";
  const auto study = sample_study(600, {{.name = "a.first"}, {.name = "second"}});
  {
    StudyDatabase database(file, study, kOrigin);
    for (std::int64_t i = 0; i < 6; ++i) database.store(sample_block(100 * i, 100));
    database.commit();
  }
  const auto front = strings(file, "SELECT id FROM front ORDER BY id");
  ASSERT_GT(front.size(), 3U);
  ASSERT_EQ(refusal(file, study, kOrigin), "");
  // Without one of them none of the others is surpassed, and no row is missing.
  int tested = 0;
  for (const auto& id : front) {
    const auto other = std::to_string(std::stoll(id) + 100'000);
    for (const auto& [change, undo] :
         {std::pair("DELETE FROM front WHERE id = " + id, "INSERT INTO front VALUES (" + id + ")"),
          std::pair("UPDATE front SET id = " + other + " WHERE id = " + id,
                    "UPDATE front SET id = " + id + " WHERE id = " + other)}) {
      SqliteDatabase(file, SqliteDatabase::Access::write_or_create).execute(change);
      EXPECT_NE(refusal(file, study, kOrigin).find("is damaged (its front is not that of its rows"),
                std::string::npos)
          << change;
      SqliteDatabase(file, SqliteDatabase::Access::write_or_create).execute(undo);
      EXPECT_EQ(refusal(file, study, kOrigin), "");
      ++tested;
    }
  }
  EXPECT_EQ(tested, 2 * static_cast<int>(front.size()));
}

/// Bytes of a file changed at a place.
void overwrite(const std::filesystem::path& file, std::size_t place, const std::string& with) {
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(static_cast<std::streamoff>(place));
  bytes << with;
}

TEST(StudyDatabase, RefusesABrokenPageThatNoRowIsOn) {
  const TestFolder folder;
  const auto file = folder / "a.study.db";
  const auto study = sample_study(3000);
  {
    StudyDatabase database(file, study, kOrigin);
    database.store(sample_block(0, 3000));
    database.commit();
  }
  // The header of SQLite's files: size of a page at 16, pages at 28, pages of the free list at 36.
  const auto word = [](std::size_t number) {
    return std::string{char(number >> 24 & 255), char(number >> 16 & 255), char(number >> 8 & 255),
                       char(number & 255)};
  };
  std::string whole;
  {
    std::ifstream stream(file, std::ios::binary);
    whole.assign(std::istreambuf_iterator<char>(stream), {});
  }
  const std::size_t page = std::size_t{static_cast<unsigned char>(whole[16])} << 8 |
                           static_cast<unsigned char>(whole[17]);
  const std::size_t pages = whole.size() / page;
  ASSERT_GT(pages, 5U);
  const auto expect_damage = [&](const char* what) {
    const auto message = refusal(file, study, kOrigin);
    EXPECT_NE(message.find("is damaged ("), std::string::npos) << what << ": " << message;
    EXPECT_NE(message.find("move it away"), std::string::npos) << what << ": " << message;
    std::ofstream(file, std::ios::binary | std::ios::trunc) << whole;
    EXPECT_EQ(refusal(file, study, kOrigin), "") << what;
  };
  // Every row and every sum are as they were: only SQLite's own check sees these two.
  overwrite(file, 36, word(3));
  expect_damage("a free list that is not there");
  overwrite(file, whole.size(), std::string(page, '\0'));
  overwrite(file, 28, word(pages + 1));
  expect_damage("a page that nothing uses");
  // The kind of a page, each in turn; the first begins with the header of the file.
  for (std::size_t i = 1; i < pages; ++i) {
    overwrite(file, i * page, std::string(1, '\x7F'));
    expect_damage(("page " + std::to_string(i + 1)).c_str());
  }
}

}  // namespace
}  // namespace cognate::app::study_damage_test
