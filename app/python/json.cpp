#include "app/python/json.hpp"

#include <nlohmann/json.hpp>

namespace cognate::python {

namespace py = pybind11;
using nlohmann::ordered_json;

py::object to_python(const ordered_json& document) {
  switch (document.type()) {
    case ordered_json::value_t::object: {
      py::dict table;
      for (const auto& [key, value] : document.items()) table[py::str(key)] = to_python(value);
      return table;
    }
    case ordered_json::value_t::array: {
      py::list list(document.size());
      for (std::size_t i = 0; i < document.size(); ++i) list[i] = to_python(document[i]);
      return list;
    }
    case ordered_json::value_t::string: {
      const auto& text = document.get_ref<const std::string&>();
      return py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
    }
    case ordered_json::value_t::boolean:
      return py::bool_(document.get<bool>());
    case ordered_json::value_t::number_integer:
      return py::int_(document.get<std::int64_t>());
    case ordered_json::value_t::number_unsigned:
      return py::int_(document.get<std::uint64_t>());
    case ordered_json::value_t::number_float:
      return py::float_(document.get<double>());
    default:
      return py::none();
  }
}

}  // namespace cognate::python
