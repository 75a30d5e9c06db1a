/// @file Documents as Python's own values.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>

namespace cognate::python {

/// Dictionaries, lists, strings, numbers and None; numbers keep every bit.
pybind11::object to_python(const nlohmann::ordered_json& document);

}  // namespace cognate::python
