/// @file Problems as Python gives them, as files or dictionaries, as the document that the reader
/// of files takes; and faults as Python gets them.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "problems/toml/document.hpp"
#include "problems/toml/fault.hpp"

namespace cognate::python {

namespace py = pybind11;

/// What stands where. What comes from Python has no lines: it is numbered instead, in the order in
/// which it was given, from `kFirstOfPython` on.
struct Place {
  problems::reading::Where where;
  std::string key;  ///< "target.points[2]", entries counted from 0
};

inline constexpr std::size_t kFirstOfPython = std::size_t{1} << 40U;

/// A problem before it is read.
struct Source {
  problems::reading::Table document;
  std::filesystem::path folder;  ///< where files that it names are looked for
  std::string file;              ///< empty where it came from no file
  std::vector<Place> places;     ///< ascending
};

/// `given` is the name of a file, a mapping, or None; `tables` (a dict) replace what the document
/// has under their keys. Raises ProblemError.
Source source_of(const py::object& given, const py::dict& tables);

/// `tables` alone.
Source source_of(const py::dict& tables);

/// Raises ProblemError with all of `faults`.
[[noreturn]] void raise_faults(const Source& source, const std::vector<problems::Fault>& faults);

/// Raises ProblemError with one fault, of an argument rather than of a document.
[[noreturn]] void raise_fault(const std::string& key, const std::string& message);

}  // namespace cognate::python
