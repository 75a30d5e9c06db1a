#include "app/python/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "problems/read.hpp"
#include "problems/task_document.hpp"

namespace cognate::python {
namespace {

namespace fs = std::filesystem;
using problems::Fault;
using problems::reading::Array;
using problems::reading::Entry;
using problems::reading::Node;
using problems::reading::Table;
using problems::reading::Where;

/// As files are bounded by their size.
constexpr std::size_t kMostValues = 2'000'000;
constexpr int kDeepest = 64;

std::string member(const std::string& within, std::string_view key) {
  return within.empty() ? std::string(key) : fmt::format("{}.{}", within, key);
}

std::string entry(const std::string& within, std::size_t index) {
  return fmt::format("{}[{}]", within, index);
}

py::object module_member(const char* module, const char* name) {
  return py::module_::import(module).attr(name);
}

bool is_a(const py::handle& value, const char* module, const char* type) {
  return py::isinstance(value, module_member(module, type));
}

std::string type_of(const py::handle& value) {
  return py::str(py::type::handle_of(value).attr("__name__")).cast<std::string>();
}

/// Turns values of Python into those of a document.
class Conversion {
 public:
  explicit Conversion(Source& source) : source_(source) {}

  Node node(const py::handle& value, const std::string& key, int depth) {
    const Where where = place(key);
    if (depth > kDeepest) raise_fault(key, "is nested too deep; 64 levels are allowed");
    if (++count_ > kMostValues) raise_fault(key, "has too many values; 2 million are allowed");
    if (PyBool_Check(value.ptr())) return {where, value.cast<bool>()};
    if (PyLong_Check(value.ptr())) return {where, integer(value, key)};
    if (PyFloat_Check(value.ptr())) return {where, value.cast<double>()};
    if (PyUnicode_Check(value.ptr())) return {where, text(value, key)};
    if (PyList_Check(value.ptr()) || PyTuple_Check(value.ptr())) {
      return {where, array(py::reinterpret_borrow<py::sequence>(value), key, depth)};
    }
    if (is_a(value, "collections.abc", "Mapping")) return {where, table(value, key, depth)};
    if (py::hasattr(value, "__fspath__")) {
      return {where, text(value.attr("__fspath__")(), key)};
    }
    if (py::hasattr(value, "__cognate_tables__")) {
      return {where, table(value.attr("__cognate_tables__")(), key, depth)};
    }
    // Arrays, numbers of arrays and columns of frames.
    if (py::hasattr(value, "tolist")) return {where, listed(value, key, depth)};
    if (PyIndex_Check(value.ptr())) {
      return {where, integer(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr())), key)};
    }
    raise_fault(key, fmt::format("is of the type {}; expected a number, a string, true or false, "
                                 "a list or an array, or a dictionary",
                                 type_of(value)));
  }

  Table table(const py::handle& mapping, const std::string& within, int depth) {
    Table all;
    for (const py::handle pair : mapping.attr("items")()) {
      const auto both = py::reinterpret_borrow<py::sequence>(pair);
      const py::object name = both[0], value = both[1];
      if (!PyUnicode_Check(name.ptr())) {
        raise_fault(within, fmt::format("has the key {}, of the type {}; keys are strings",
                                        py::repr(name).cast<std::string>(), type_of(name)));
      }
      const std::string word = text(name, within);
      const std::string key = member(within, word);
      if (value.is_none()) continue;
      const Where where = place(key);
      all.push_back({word, where, node(value, key, depth + 1)});
    }
    return all;
  }

 private:
  Where place(const std::string& key) {
    const Where where{kFirstOfPython + source_.places.size(), 1};
    source_.places.push_back({where, key});
    return where;
  }

  static std::int64_t integer(const py::handle& value, const std::string& key) {
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0) {
      raise_fault(key, "is an integer of more than 63 bits; smaller ones are allowed");
    }
    return number;
  }

  static std::string text(const py::handle& value, const std::string& key) {
    if (!PyUnicode_Check(value.ptr())) raise_fault(key, "is a path of bytes; expected text");
    Py_ssize_t size = 0;
    const char* bytes = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (bytes == nullptr) {
      PyErr_Clear();
      raise_fault(key, "holds a lone surrogate; expected text");
    }
    std::string_view view(bytes, static_cast<std::size_t>(size));
    if (view.find('\0') != std::string_view::npos) {
      raise_fault(key, "holds the character U+0000; any other one is allowed");
    }
    return std::string(view);
  }

  Array array(const py::sequence& list, const std::string& key, int depth) {
    Array all;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const py::object value = list[i];
      if (value.is_none()) {
        raise_fault(entry(key, i), "is None; a list has a value in every place");
      }
      all.push_back(node(value, entry(key, i), depth + 1));
    }
    return all;
  }

  decltype(Node::value) listed(const py::handle& value, const std::string& key, int depth) {
    if (py::hasattr(value, "size")) {
      const py::object size = value.attr("size");
      if (PyLong_Check(size.ptr()) && size.cast<py::ssize_t>() > py::ssize_t{kMostValues}) {
        raise_fault(key, "has too many values; 2 million are allowed");
      }
    }
    const py::object list = value.attr("tolist")();
    if (py::hasattr(list, "tolist")) {  // a number that Python has not: complex, long double
      raise_fault(key, fmt::format("is of the type {}; expected a number of 64 bits or less",
                                   type_of(value)));
    }
    return node(list, key, depth + 1).value;
  }

  Source& source_;
  std::size_t count_ = 0;
};

void collect(const Table& table, const std::string& within, std::vector<Place>& places);

void collect(const Node& node, const std::string& key, std::vector<Place>& places) {
  places.push_back({node.where, key});
  if (const auto* table = std::get_if<Table>(&node.value)) collect(*table, key, places);
  const auto* array = std::get_if<Array>(&node.value);
  for (std::size_t i = 0; array && i < array->size(); ++i) {
    collect((*array)[i], entry(key, i), places);
  }
}

void collect(const Table& table, const std::string& within, std::vector<Place>& places) {
  for (const Entry& each : table) {
    const std::string key = member(within, each.key);
    places.push_back({each.where, key});
    collect(each.node, key, places);
  }
}

/// What stands last before or at `where`, on its line where there is something.
std::string key_at(const std::vector<Place>& places, const Where& where) {
  const auto behind = std::ranges::upper_bound(places, where, {}, &Place::where);
  if (behind == places.begin()) return "";
  const Place& before = *std::prev(behind);
  if (where.line >= kFirstOfPython && before.where.line != where.line) return "";
  return before.key;
}

/// The key that the message begins with: "target.points" of "target.points is missing; …".
std::string key_in(std::string_view message) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '[' ||
           c == ']' || c == '-';
  };
  const auto end = std::ranges::find_if_not(message, is_part);
  return std::string(message.begin(), end);
}

/// Where a key is missing, its table is the place of the fault, and the message names it.
std::string key_of(const Source& source, const Fault& fault) {
  const std::string there = key_at(source.places, {fault.line, fault.column});
  const std::string said = key_in(fault.message);
  if (source.places.empty() && source.file.empty()) return said;
  const bool is_below = there.empty() || said.starts_with(there + ".");
  const bool is_missing = fault.message.find("is missing") != std::string::npos ||
                          fault.message.find("are missing") != std::string::npos;
  if (is_missing && !said.empty()) return said;
  return is_below && said.find('.') != std::string::npos ? said : there;
}

py::object number_or_none(bool is_there, std::size_t number) {
  return is_there ? py::object(py::int_(number)) : py::object(py::none());
}

[[noreturn]] void raise(const py::list& faults) {
  const py::object error = module_member("cognate._errors", "ProblemError");
  PyErr_SetObject(error.ptr(), error(faults).ptr());
  throw py::error_already_set();
}

py::tuple as_tuple(const std::string& file, const py::object& line, const py::object& column,
                   const std::string& key, const std::string& message) {
  return py::make_tuple(file.empty() ? py::object(py::none()) : py::object(py::str(file)), line,
                        column, key, message);
}

void read_file(const py::object& path, Source& source) {
  const py::object name = module_member("os", "fspath")(path);
  if (!PyUnicode_Check(name.ptr())) raise_fault("", "the file's name is bytes; expected a string");
  const auto text = name.cast<std::string>();
  if (text.find('\0') != std::string::npos) {
    raise_fault("", "the file's name holds the character U+0000; any other one is allowed");
  }
  source.file = text;
  auto read = problems::reading::read_source(fs::path(text));
  if (!read) raise_faults(source, read.error());
  source.document = std::move(read->document);
  source.folder = std::move(read->folder);
  collect(source.document, "", source.places);
}

}  // namespace

Source source_of(const py::object& given, const py::dict& tables) {
  Source source;
  const bool is_path = PyUnicode_Check(given.ptr()) || PyBytes_Check(given.ptr()) ||
                       py::hasattr(given, "__fspath__");
  Conversion conversion(source);
  source.folder = fs::current_path();
  if (is_path) {
    read_file(given, source);
  } else if (is_a(given, "collections.abc", "Mapping")) {
    source.document = conversion.table(given, "", 0);
  } else if (!given.is_none()) {
    raise_fault("", fmt::format("the problem is of the type {}; expected the name of a file, a "
                                "dictionary, or keywords",
                                type_of(given)));
  }
  for (Entry& added : conversion.table(tables, "", 0)) {
    std::erase_if(source.document, [&](const Entry& old) { return old.key == added.key; });
    source.document.push_back(std::move(added));
  }
  std::ranges::stable_sort(source.places, {}, &Place::where);
  return source;
}

Source source_of(const py::dict& tables) {
  return source_of(py::none(), tables);
}

void raise_faults(const Source& source, const std::vector<Fault>& faults) {
  py::list all;
  for (const Fault& fault : faults) {
    const bool has_line = fault.line < kFirstOfPython && !source.file.empty();
    all.append(as_tuple(source.file, number_or_none(has_line, fault.line),
                        number_or_none(has_line, fault.column), key_of(source, fault),
                        fault.message));
  }
  raise(all);
}

void raise_fault(const std::string& key, const std::string& message) {
  py::list all;
  all.append(as_tuple("", py::none(), py::none(), key,
                      key.empty() ? message : fmt::format("{} {}", key, message)));
  raise(all);
}

}  // namespace cognate::python
