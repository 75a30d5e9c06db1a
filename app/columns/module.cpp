/// @file What the program finds in this module.
#include <hdf5.h>

#include <cerrno>
#include <stdexcept>
#include <utility>

#include "app/study/columns.hpp"

namespace cognate::app {
namespace {

/// What HDF5 says went wrong.
class Hdf5Error : public std::runtime_error {
 public:
  Hdf5Error(const std::string& what, int system) : std::runtime_error(what), system_(system) {}
  int system() const { return system_; }  ///< the errno, 0 where it was nothing of the system

 private:
  int system_;
};

/// The innermost of the errors that HDF5 has heaped up.
herr_t keep_description(unsigned /*n*/, const H5E_error2_t* error, void* text) {
  auto& kept = *static_cast<std::string*>(text);
  if (error->desc != nullptr && kept.empty()) kept = error->desc;
  return 0;
}

template <class Result>
Result checked(Result result) {
  if (result >= 0) return result;
  const int system = errno;
  std::string what;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_description, &what);
  throw Hdf5Error(what, system);
}

/// An object of HDF5, which `close` gives back.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(checked(id)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  /// Closes it now, when what is still to be written may fail.
  void close() { checked(close_(std::exchange(id_, -1))); }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

Handle word_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  checked(H5Tset_size(type, bytes));
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

Handle new_file(const std::filesystem::path& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // No other program knows the draft, and some file systems have no locks.
  checked(H5Pset_file_locking(access, false, true));
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

Handle line_of(std::size_t length) {
  const hsize_t size = length;
  return {H5Screate_simple(1, &size, nullptr), H5Sclose};
}

void write_text(hid_t group, const std::string& name, const std::string& text) {
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle type = word_type(std::max<std::size_t>(text.size(), 1));
  const Handle dataset = new_dataset(group, name, type, scalar);
  checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
}

void write_unit(hid_t dataset, const std::string& unit) {
  if (unit.empty()) return;
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle type = word_type(unit.size());
  const Handle attribute(H5Acreate2(dataset, "unit", type, scalar, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  checked(H5Awrite(attribute, type, unit.c_str()));
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

void write_rows(hid_t group, const ColumnsHead& head, const NextColumnRows& next) {
  const auto count = static_cast<std::size_t>(head.rows);
  const auto copy = [](hid_t type) { return Handle(H5Tcopy(type), H5Tclose); };
  Column ids(group, "id", copy(H5T_NATIVE_INT64), count);
  std::vector<Column> columns;
  for (const auto& [name, unit, bytes] : head.columns) {
    columns.emplace_back(group, name, bytes > 0 ? word_type(bytes) : copy(H5T_NATIVE_DOUBLE),
                         count);
    write_unit(columns.back().dataset(), unit);
  }
  ColumnRows rows;
  while (next(rows)) {
    const auto size = rows.ids.size();
    ids.append(rows.ids.data(), size);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool of_words = head.columns[i].bytes > 0;
      columns[i].append(
          of_words ? static_cast<const void*>(rows.words[i].data()) : rows.numbers[i].data(), size);
    }
  }
}

void write_columns_file(const std::filesystem::path& path, const ColumnsHead& head,
                        const NextColumnRows& next) {
  Handle file = new_file(path);
  {
    const Handle group = new_group(file, "study");
    for (const auto& [name, text] : head.study) write_text(group, name, text);
  }
  if (head.front) {
    Column front(file, "front", Handle(H5Tcopy(H5T_NATIVE_INT64), H5Tclose), head.front->size());
    front.append(head.front->data(), head.front->size());
  }
  {
    const Handle group = new_group(file, "runs");
    write_rows(group, head, next);
  }
  file.close();
}

}  // namespace
}  // namespace cognate::app

extern "C" [[gnu::visibility("default")]] int cognate_write_columns(
    const std::filesystem::path& file, const cognate::app::ColumnsHead& head,
    const cognate::app::NextColumnRows& next, std::string& fault) {
  // At the end of the program it would write once more, and crash, what a full disk refused.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  errno = 0;
  try {
    cognate::app::write_columns_file(file, head, next);
    return 0;
  } catch (const cognate::app::Hdf5Error& error) {
    fault = error.what();
    return error.system() != 0 ? error.system() : EIO;
  }
}
