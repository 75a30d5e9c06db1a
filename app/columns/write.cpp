/// @file Columns of studies as files of HDF5.
#include <cerrno>
#include <utility>

#include "app/columns/hdf5.hpp"
#include "app/study/columns_module.hpp"

namespace cognate::app {
namespace {

Handle new_file(const std::filesystem::path& path) {
  const Handle access = unlocked_access();
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST));
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose};
}

/// A group whose members are listed in the order in which they are made.
Handle new_group(hid_t file, const char* name) {
  const Handle making(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  checked(H5Pset_link_creation_order(making, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  return {H5Gcreate2(file, name, H5P_DEFAULT, making, H5P_DEFAULT), H5Gclose};
}

Handle new_dataset(hid_t group, const std::string& name, hid_t type, hid_t space) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  checked(H5Pset_char_encoding(links, H5T_CSET_UTF8));
  // A name with a slash is that of a member of a group.
  checked(H5Pset_create_intermediate_group(links, 1));
  return {H5Dcreate2(group, name.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT), H5Dclose};
}

void write_text(hid_t group, const std::string& name, const std::string& text) {
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle type = word_type(std::max<std::size_t>(text.size(), 1));
  const Handle dataset = new_dataset(group, name, type, scalar);
  checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
}

void write_attribute(hid_t object, const char* name, hid_t type, const void* value) {
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type, scalar, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  checked(H5Awrite(attribute, type, value));
}

void write_word(hid_t object, const char* name, const std::string& word) {
  if (!word.empty()) write_attribute(object, name, word_type(word.size()), word.c_str());
}

Handle copied(hid_t type) {
  return {H5Tcopy(type), H5Tclose};
}

/// A dataset of one value for each row, written from the first on.
class Column {
 public:
  Column(hid_t group, const std::string& name, Handle type, std::size_t rows)
      : type_(std::move(type)),
        space_(line_of(rows)),
        dataset_(new_dataset(group, name, type_, space_)) {}

  hid_t dataset() const { return dataset_; }

  void append(const void* values, std::size_t count) {
    if (count == 0) return;
    const hsize_t from = written_, size = count;
    const Handle memory = line_of(count);
    checked(H5Sselect_hyperslab(space_, H5S_SELECT_SET, &from, nullptr, &size, nullptr));
    checked(H5Dwrite(dataset_, type_, memory, space_, H5P_DEFAULT, values));
    written_ += count;
  }

 private:
  Handle type_, space_, dataset_;
  hsize_t written_ = 0;
};

/// A column of words or numbers, and of the kinds of its rows where it has these.
class RowsColumn {
 public:
  RowsColumn(hid_t runs, hid_t kinds, const ColumnHead& head, std::size_t rows)
      : has_words_(head.bytes > 0),
        values_(runs, head.name, has_words_ ? word_type(head.bytes) : copied(H5T_NATIVE_DOUBLE),
                rows) {
    write_word(values_.dataset(), "unit", head.unit);
    if (head.has_kinds) kinds_.emplace(kinds, head.name, copied(H5T_NATIVE_INT8), rows);
  }

  void append(const ColumnRows& rows, std::size_t column) {
    const void* const numbers = rows.numbers[column].data();
    values_.append(has_words_ ? rows.words[column].data() : numbers, rows.ids.size());
    if (kinds_) kinds_->append(rows.kinds[column].data(), rows.ids.size());
  }

 private:
  bool has_words_;
  Column values_;
  std::optional<Column> kinds_;
};

void write_rows(hid_t file, const ColumnsHead& head, const NextColumnRows& next) {
  const auto count = static_cast<std::size_t>(head.rows);
  const Handle runs = new_group(file, "runs");
  const Handle kinds = new_group(file, "kinds");
  Column ids(runs, "id", copied(H5T_NATIVE_INT64), count);
  std::vector<RowsColumn> columns;
  for (const auto& column : head.columns) columns.emplace_back(runs, kinds, column, count);
  ColumnRows rows;
  while (next(rows)) {
    ids.append(rows.ids.data(), rows.ids.size());
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].append(rows, i);
  }
}

void write_blocks(hid_t file, const ColumnsHead& head, const NextBlocks& next) {
  const Handle group = new_group(file, "blocks");
  std::vector<Column> columns;
  for (const auto& name : head.block_columns) {
    columns.emplace_back(group, name, copied(H5T_NATIVE_INT64),
                         static_cast<std::size_t>(head.blocks));
  }
  std::vector<std::vector<std::int64_t>> blocks;
  while (next(blocks)) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i].append(blocks[i].data(), blocks[i].size());
    }
  }
}

void write_columns_file(const std::filesystem::path& path, const ColumnsHead& head,
                        const NextColumnRows& next, const NextBlocks& next_blocks) {
  Handle file = new_file(path);
  write_word(file, "format", kColumnsFormat);
  {
    const Handle group = new_group(file, "study");
    write_attribute(group, "checksum", H5T_NATIVE_INT64, &head.study_checksum);
    for (const auto& [name, text] : head.study) write_text(group, name, text);
  }
  if (head.front) {
    Column front(file, "front", copied(H5T_NATIVE_INT64), head.front->size());
    front.append(head.front->data(), head.front->size());
  }
  write_rows(file, head, next);
  write_blocks(file, head, next_blocks);
  file.close();
}

}  // namespace
}  // namespace cognate::app

extern "C" [[gnu::visibility("default")]] int cognate_write_columns_2(
    const std::filesystem::path& file, const cognate::app::ColumnsHead& head,
    const cognate::app::NextColumnRows& next, const cognate::app::NextBlocks& next_blocks,
    std::string& fault) {
  cognate::app::begin_hdf5();
  try {
    cognate::app::write_columns_file(file, head, next, next_blocks);
    return 0;
  } catch (const cognate::app::Hdf5Error& error) {
    fault = error.what();
    return error.system() != 0 ? error.system() : EIO;
  }
}
