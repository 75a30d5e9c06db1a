/// @file Files of HDF5 as columns of studies. They may hold anything: types, shapes and lengths are
/// looked at before anything is read, and what a length asks for is bounded.
#include <fmt/core.h>

#include <type_traits>

#include "app/columns/hdf5.hpp"
#include "app/study/columns_module.hpp"

namespace cognate::app {
namespace {

constexpr std::size_t kMostTextBytes = std::size_t{64} << 20U;  // files of problems are smaller
constexpr std::size_t kMostWordBytes = std::size_t{1} << 16U;

/// What is wrong with the file, in words that go on after its name.
class Misfit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `body` gives, or what is wrong.
template <class Body>
auto guarded(Body&& body) -> ColumnsResult<decltype(body())> {
  try {
    if constexpr (std::is_void_v<decltype(body())>) {
      body();
      return {};
    } else {
      return body();
    }
  } catch (const Misfit& misfit) {
    return tl::unexpected(std::string(misfit.what()));
  } catch (const Hdf5Error& error) {
    return tl::unexpected(fmt::format("is damaged (HDF5 says {})", error.what()));
  } catch (const std::exception& error) {
    return tl::unexpected(fmt::format("cannot be read: {}", error.what()));
  }
}

Handle opened_file(const std::filesystem::path& path) {
  const Handle access = unlocked_access();
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (id < 0) {
    throw Misfit(H5Fis_hdf5(path.c_str()) > 0 ? "is a damaged file of HDF5" : "is no file of HDF5");
  }
  return {id, H5Fclose};
}

/// A link that leads to nothing readable, too, is none.
Handle opened_object(const char* what, const std::string& name, hid_t id, herr_t (*close)(hid_t)) {
  if (id < 0) throw Misfit(fmt::format("has no {} {}", what, name));
  return {id, close};
}

Handle dataset_of(hid_t file, const std::string& name) {
  return opened_object("dataset", name, H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
}

bool is_number(hid_t type, H5T_class_t kind, std::size_t bytes) {
  return H5Tget_class(type) == kind && H5Tget_size(type) == bytes &&
         (kind != H5T_INTEGER || H5Tget_sign(type) == H5T_SGN_2);
}

/// The bytes of each word; 0 where the type is none of words of fixed length.
std::size_t word_bytes(hid_t type) {
  const bool is_fixed = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
  return is_fixed ? H5Tget_size(type) : 0;
}

/// The words of `type` as they lie in memory: filled up with zeros, in ASCII or UTF-8 as in the
/// file.
Handle padded(hid_t type) {
  Handle memory(H5Tcopy(type), H5Tclose);
  checked(H5Tset_strpad(memory, H5T_STR_NULLPAD));
  return memory;
}

std::string scalar_text(hid_t type, hid_t space, const std::string& name, const auto& read) {
  const std::size_t bytes = word_bytes(type);
  if (bytes == 0 || bytes > kMostTextBytes || H5Sget_simple_extent_npoints(space) != 1) {
    throw Misfit(fmt::format("has in {} something else than one text of fixed length", name));
  }
  std::string text(bytes, '\0');
  checked(read(padded(type), text.data()));
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

/// A dataset of one value for each row.
class ReadColumn {
 public:
  ReadColumn(hid_t file, std::string name)
      : name_(std::move(name)),
        dataset_(dataset_of(file, name_)),
        type_(H5Dget_type(dataset_), H5Tclose),
        space_(H5Dget_space(dataset_), H5Sclose) {
    if (H5Sget_simple_extent_ndims(space_) != 1)
      throw Misfit(fmt::format("has no list in {}", name_));
    length_ = checked(H5Sget_simple_extent_npoints(space_));
  }

  const std::string& name() const { return name_; }
  hid_t type() const { return type_; }
  std::int64_t length() const { return length_; }

  void expect(H5T_class_t kind, std::size_t bytes, const char* what) const {
    if (!is_number(type_, kind, bytes)) throw Misfit(fmt::format("has no {} in {}", what, name_));
  }

  void expect_length(std::int64_t rows) const {
    if (length_ == rows) return;
    throw Misfit(fmt::format("has {} rows in {}, and {} in runs/id", length_, name_, rows));
  }

  /// Values from `from` on into `values`, which has room for `count` of `memory_type`.
  void read(std::int64_t from, std::int64_t count, hid_t memory_type, void* values) {
    if (count == 0) return;
    if (from < 0 || count < 0 || from > length_ - count) {
      throw Misfit(fmt::format("has too few rows in {}", name_));
    }
    const auto start = static_cast<hsize_t>(from), size = static_cast<hsize_t>(count);
    const Handle memory = line_of(size);
    checked(H5Sselect_hyperslab(space_, H5S_SELECT_SET, &start, nullptr, &size, nullptr));
    checked(H5Dread(dataset_, memory_type, memory, space_, H5P_DEFAULT, values));
  }

 private:
  std::string name_;
  Handle dataset_, type_, space_;
  std::int64_t length_ = 0;
};

ReadColumn integers_of(hid_t file, const std::string& name) {
  ReadColumn column(file, name);
  column.expect(H5T_INTEGER, sizeof(std::int64_t), "64-bit integers");
  return column;
}

/// A column of words or numbers, with the kinds of its rows where it has these.
class ReadRowsColumn {
 public:
  ReadRowsColumn(hid_t file, hid_t kinds, const std::string& name, std::int64_t rows)
      : values_(file, "runs/" + name), bytes_(word_bytes(values_.type())) {
    values_.expect_length(rows);
    if (bytes_ == 0) {
      values_.expect(H5T_FLOAT, sizeof(double), "doubles and no words of fixed length");
      return;
    }
    if (bytes_ > kMostWordBytes) throw Misfit(fmt::format("has too long words in {}", name));
    if (!has_dataset(kinds, name)) return;
    kinds_.emplace(file, "kinds/" + name);
    kinds_->expect_length(rows);
    kinds_->expect(H5T_INTEGER, 1, "bytes");
  }

  ColumnHead head(const std::string& name) const {
    return {.name = name, .unit = "", .bytes = bytes_, .has_kinds = kinds_.has_value()};
  }

  void read(std::int64_t from, std::int64_t count, ColumnRows& rows, std::size_t column) {
    const auto size = static_cast<std::size_t>(count);
    rows.numbers[column].resize(bytes_ == 0 ? size : 0);
    rows.words[column].resize(bytes_ * size);
    rows.kinds[column].resize(kinds_ ? size : 0);
    if (bytes_ == 0) {
      values_.read(from, count, H5T_NATIVE_DOUBLE, rows.numbers[column].data());
    } else {
      values_.read(from, count, padded(values_.type()), rows.words[column].data());
    }
    if (kinds_) kinds_->read(from, count, H5T_NATIVE_INT8, rows.kinds[column].data());
  }

 private:
  /// Whether every part of the name leads on.
  static bool has_dataset(hid_t group, const std::string& name) {
    for (auto end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1)) {
      if (H5Lexists(group, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    }
    return H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0;
  }

  ReadColumn values_;
  std::size_t bytes_;
  std::optional<ReadColumn> kinds_;
};

class Hdf5Columns final : public ColumnsFile {
 public:
  explicit Hdf5Columns(const std::filesystem::path& path) : file_(opened_file(path)) {}

  ColumnsResult<std::string> format() override {
    return guarded([&] {
      if (H5Aexists(file_, "format") <= 0) return std::string();
      const Handle attribute(H5Aopen(file_, "format", H5P_DEFAULT), H5Aclose);
      const Handle type(H5Aget_type(attribute), H5Tclose);
      const Handle space(H5Aget_space(attribute), H5Sclose);
      return scalar_text(type, space, "its format",
                         [&](hid_t memory, char* to) { return H5Aread(attribute, memory, to); });
    });
  }

  ColumnsResult<std::string> text(const std::string& name) override {
    return guarded([&] {
      const Handle dataset = dataset_of(file_, name);
      const Handle type(H5Dget_type(dataset), H5Tclose);
      const Handle space(H5Dget_space(dataset), H5Sclose);
      return scalar_text(type, space, name, [&](hid_t memory, char* to) {
        return H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
      });
    });
  }

  ColumnsResult<std::int64_t> attribute(const std::string& group,
                                        const std::string& name) override {
    return guarded([&] {
      const Handle object =
          opened_object("group", group, H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
      const Handle attribute = opened_object("attribute", group + "@" + name,
                                             H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
      const Handle type(H5Aget_type(attribute), H5Tclose);
      const Handle space(H5Aget_space(attribute), H5Sclose);
      std::int64_t value = 0;
      if (!is_number(type, H5T_INTEGER, sizeof value) || H5Sget_simple_extent_npoints(space) != 1) {
        throw Misfit(fmt::format("has no 64-bit integer in {}@{}", group, name));
      }
      checked(H5Aread(attribute, H5T_NATIVE_INT64, &value));
      return value;
    });
  }

  ColumnsResult<std::int64_t> length(const std::string& name) override {
    return guarded([&] { return integers_of(file_, name).length(); });
  }

  ColumnsResult<std::vector<std::int64_t>> integers(const std::string& name, std::int64_t from,
                                                    std::int64_t count) override {
    return guarded([&] {
      auto column = integers_of(file_, name);
      std::vector<std::int64_t> values(static_cast<std::size_t>(count));
      column.read(from, count, H5T_NATIVE_INT64, values.data());
      return values;
    });
  }

  ColumnsResult<std::vector<ColumnHead>> open_columns(const std::vector<std::string>& names,
                                                      std::int64_t rows) override {
    return guarded([&] {
      ids_.emplace(integers_of(file_, "runs/id"));
      if (ids_->length() != rows) {
        throw Misfit(
            fmt::format("has {} rows in runs/id, and {} in its blocks", ids_->length(), rows));
      }
      const Handle kinds =
          opened_object("group", "kinds", H5Gopen2(file_, "kinds", H5P_DEFAULT), H5Gclose);
      columns_.clear();
      std::vector<ColumnHead> heads;
      for (const auto& name : names) {
        columns_.emplace_back(file_, kinds, name, rows);
        heads.push_back(columns_.back().head(name));
      }
      return heads;
    });
  }

  ColumnsResult<void> read(std::int64_t from, std::int64_t count, ColumnRows& rows) override {
    return guarded([&] {
      rows.ids.resize(static_cast<std::size_t>(count));
      rows.numbers.resize(columns_.size());
      rows.words.resize(columns_.size());
      rows.kinds.resize(columns_.size());
      ids_->read(from, count, H5T_NATIVE_INT64, rows.ids.data());
      for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].read(from, count, rows, i);
    });
  }

 private:
  Handle file_;
  std::optional<ReadColumn> ids_;
  std::vector<ReadRowsColumn> columns_;
};

}  // namespace
}  // namespace cognate::app

/// What the program finds in this module.
extern "C" [[gnu::visibility("default")]] void cognate_open_columns_2(
    const std::filesystem::path& file,
    cognate::app::ColumnsResult<std::unique_ptr<cognate::app::ColumnsFile>>& opened) {
  cognate::app::begin_hdf5();
  opened = cognate::app::guarded([&]() -> std::unique_ptr<cognate::app::ColumnsFile> {
    return std::make_unique<cognate::app::Hdf5Columns>(file);
  });
}
