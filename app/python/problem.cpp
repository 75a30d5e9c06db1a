#include "app/python/problem.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/export_design.hpp"
#include "app/documents/result_json.hpp"
#include "app/documents/version.hpp"
#include "app/export/exported.hpp"
#include "app/kinds/kinds.hpp"
#include "app/python/arguments.hpp"
#include "app/python/document.hpp"
#include "app/python/json.hpp"
#include "app/python/watch.hpp"
#include "app/study/cache_folder.hpp"
#include "app/study/metrics.hpp"
#include "app/study/summary.hpp"
#include "problems/read.hpp"
#include "problems/study/read.hpp"
#include "problems/task_document.hpp"

namespace cognate::python {
namespace {

using app::Kind;
using nlohmann::ordered_json;
using problems::Fault;
using problems::Task;

/// Of a cam's table over its turn, as `cognate solve` has it.
constexpr int kTurnSteps = 360;

/// What `parse` makes of a value as its text; None is nothing. Faults name the option.
template <class Parse>
auto parsed(const py::object& value, const Parse& parse, std::vector<std::string>& faults) {
  using Value = typename std::invoke_result_t<Parse, std::string_view>::value_type;
  std::optional<Value> result;
  if (value.is_none()) return result;
  const auto read = parse(py::str(value).cast<std::string>());
  if (read) {
    result = *read;
  } else {
    faults.push_back(read.error());
  }
  return result;
}

/// `message` with the options that it names, "--cutter-radius", as keywords, "cutter_radius".
std::string as_keywords(std::string message) {
  for (auto at = message.find("--"); at != std::string::npos; at = message.find("--", at)) {
    message.erase(at, 2);
    const auto is_part = [](char c) { return c == '-' || ('a' <= c && c <= 'z'); };
    for (; at < message.size() && is_part(message[at]); ++at) {
      if (message[at] == '-') message[at] = '_';
    }
  }
  return message;
}

void raise_arguments(const std::vector<std::string>& messages) {
  if (messages.empty()) return;
  std::vector<Fault> faults;
  for (const std::string& message : messages) {
    faults.push_back({kFirstOfPython, 1, as_keywords(message)});
  }
  Source arguments;
  raise_faults(arguments, faults);
}

template <class K, class Problem>
std::function<std::string()> table_of(const std::shared_ptr<const Task>& task,
                                      const std::shared_ptr<const typename K::Result>& result) {
  if constexpr (requires(const Problem& p, const typename K::Result& r) { K::csv(p, r); }) {
    return [task, result] { return K::csv(std::get<Problem>(*task), *result); };
  } else if constexpr (requires(const Problem& p, const typename K::Result& r) {
                         K::csv(p, r, kTurnSteps);
                       }) {
    return [task, result] { return K::csv(std::get<Problem>(*task), *result, kTurnSteps); };
  } else {
    return {};
  }
}

/// What a run of `task`, which has kind K, gives; nothing of Python's is touched.
template <class K, class Problem>
tl::expected<Answer, std::vector<Fault>> answer_of(const std::shared_ptr<const Task>& task,
                                                   const RunOptions& options, Watch& watch) {
  const auto& problem = std::get<Problem>(*task);
  auto known = K::known_designs(problem);
  if (!known) return tl::unexpected(std::move(known.error()));
  const problems::Run run{
      .seed = options.seed,
      .threads = options.threads,
      .time_limit = options.time_limit,
      .interrupted = &watch.interrupted(),
      .known = *std::move(known),
      .cache = app::cache_folder(),
      .progress = [&](double share, double best) { watch.report(share, best); },
      .phase = [&](problems::Phase begun, double to) { watch.enter(begun, to); }};
  watch.enter(problems::Phase::search, 1);
  const auto result = std::make_shared<const typename K::Result>(K::run(problem, run));
  auto document = app::result_document(problem, *result, options.seed);
  if (!document) throw std::runtime_error("a fault of Cognate's own: " + document.error());
  return Answer{*std::move(document),
                [task, result](const ordered_json& of) {
                  return app::report_html(of, std::get<Problem>(*task), *result);
                },
                table_of<K, Problem>(task, result)};
}

problems::TaskAt read_task(const Source& source) {
  auto read = [&] {
    const py::gil_scoped_release unlocked;
    return problems::reading::read_task(source.document, source.folder);
  }();
  if (!read) raise_faults(source, read.error());
  return *std::move(read);
}

Answer compute(const std::string& command, const py::object& given, const py::dict& tables,
               const Steering& steering) {
  const RunOptions options = checked(steering);
  const Source source = source_of(given, tables);
  problems::TaskAt read = read_task(source);
  const auto task = std::make_shared<const Task>(std::move(read.task));
  const auto as = command == "solve" ? app::Command::solve : app::Command::analyze;
  tl::expected<Answer, std::vector<Fault>> answer;
  app::visit_kind(*task, [&]<class K, class Problem>(K, const Problem& problem) {
    const std::string why = K::refusal(problem, as);
    if (!why.empty()) raise_faults(source, {{read.line, read.column, why}});
    Watch watch;
    watch.run(steering.progress, [&] { answer = answer_of<K, Problem>(task, options, watch); });
  });
  if (!answer) raise_faults(source, answer.error());
  return *std::move(answer);
}

/// What `problem` is, with every default filled in.
ordered_json description(const Task& task) {
  return app::visit_kind(task, []<class K, class Problem>(K, const Problem& problem) {
    return ordered_json{{"description", K::describe(problem)},
                        {"problem", app::problem_json(problem)}};
  });
}

py::object check(const py::object& given, const py::dict& tables) {
  const Source source = source_of(given, tables);
  if (problems::reading::is_study(source.document) && !source.file.empty() && tables.empty()) {
    const auto study = app::read_study(source.file);
    if (!study) raise_faults(source, study.error());
    return to_python(
        {{"description", app::describe_study(*study)}, {"problem", app::study_json(*study)}});
  }
  const Task task = read_task(source).task;
  auto faults = app::visit_kind(
      task, []<class K, class Problem>(K, const Problem& problem) { return K::faults(problem); });
  if (!faults.empty()) raise_faults(source, faults);
  return to_python(description(task));
}

py::object list(const py::object& of, bool metrics) {
  const std::string kind = text_of(of, "kind");
  const auto document = app::list_document(kind, metrics);
  if (!document) raise_fault("kind", app::unknown_kind(kind));
  return to_python(*document);
}

/// "chord_tolerance" of "--chord-tolerance".
std::string keyword(std::string_view option) {
  std::string word(option.substr(2));
  std::ranges::replace(word, '-', '_');
  return word;
}

/// A value as the command line has it: lists with commas between.
std::string option_text(const py::handle& value) {
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) {
    return py::str(value).cast<std::string>();
  }
  std::string text;
  for (const py::handle item : value) {
    text += (text.empty() ? "" : ",") + py::str(item).cast<std::string>();
  }
  return text;
}

/// Why an option is none of an export, or has no value that it can have.
std::vector<std::string> option_faults(const py::dict& options) {
  std::set<std::string> known{"length_unit"}, flags;
  for (const auto& option : app::kExportTexts) known.insert(keyword(option.name));
  for (const auto& flag : app::kExportFlags) flags.insert(keyword(flag.name));
  known.insert(flags.begin(), flags.end());
  std::vector<std::string> faults;
  for (const auto& [key, value] : options) {
    const std::string name = py::str(key);
    if (!known.contains(name)) {
      faults.push_back(fmt::format("{}: is no option of an export; allowed are {}", name,
                                   fmt::join(known, ", ")));
    } else if (flags.contains(name) && !py::isinstance<py::bool_>(value)) {
      faults.push_back(name + ": expected True or False");
    }
  }
  return faults;
}

app::ExportOptions export_options(const py::dict& options) {
  raise_arguments(option_faults(options));
  app::ExportTexts texts;
  for (const auto& [name, member] : app::kExportTexts) {
    const std::string key = keyword(name);
    if (options.contains(key) && !py::object(options[key.c_str()]).is_none()) {
      texts.*member = option_text(options[key.c_str()]);
    }
  }
  for (const auto& [name, member] : app::kExportFlags) {
    const std::string key = keyword(name);
    texts.*member = options.contains(key) && options[key.c_str()].cast<bool>();
  }
  const auto read = app::export_options(texts);
  if (!read) raise_arguments(read.error());
  return *read;
}

/// Of the result document `text`, called `name` in messages: the files, as (name, text), notes, and
/// quantities.
py::dict export_files(const std::string& document, const std::string& name, const std::string& stem,
                      const py::dict& options) {
  const app::ExportOptions exporting = export_options(options);
  std::vector<std::string> faults;
  const auto unit =
      parsed(options.contains("length_unit") ? py::object(options["length_unit"]) : py::none(),
             app::parse_length_unit, faults);
  raise_arguments(faults);
  const auto design = app::parse_result_design(document, exporting.design, name)
                          .and_then([&](app::ResultDesign read) {
                            return app::in_length_unit(std::move(read), unit);
                          });
  if (!design) raise_fault("", design.error());
  const auto made = [&] {
    const py::gil_scoped_release unlocked;
    return app::export_design(*design, exporting, stem, {});
  }();
  if (!made) raise_fault("", made.error().message);
  py::dict files;
  for (const auto& file : made->files) files[py::str(file.name)] = py::bytes(file.text);
  py::dict all;
  all["files"] = files;
  all["notes"] = made->notes;
  all["summary"] = made->summary;
  all["quantities"] = to_python(made->quantities);
  return all;
}

/// The tables of the analysis of a design of a result.
py::object analysis_tables(const std::string& document, int design) {
  const auto given = app::parse_result_design(document, design, "the result");
  if (!given) raise_fault("", given.error());
  const auto tables = app::analysis_of_design(*given);
  if (!tables) raise_fault("", tables.error());
  return to_python(*tables);
}

Answer answer_of_document(const std::string& text, const std::string& name) {
  ordered_json document = ordered_json::parse(text, nullptr, false);
  const bool is_result = document.is_object() && document.value("format", ordered_json()) ==
                                                     ordered_json("cognate-result/1");
  if (!is_result)
    raise_fault("", name +
                        ": is no result of Cognate; expected a document with "
                        "\"format\": \"cognate-result/1\"");
  return {std::move(document), {}, {}};
}

/// What is left of an answer when it is written down: the document, and the page and the table as
/// they are made of it.
py::tuple state(const Answer& answer) {
  std::vector<std::uint8_t> document;
  std::string page, table;
  {
    const py::gil_scoped_release unlocked;
    document = ordered_json::to_cbor(answer.document);
    if (answer.report) page = answer.report(answer.document);
    if (answer.csv) table = answer.csv();
  }
  const std::string_view bytes(reinterpret_cast<const char*>(document.data()), document.size());
  return py::make_tuple(py::bytes(bytes), py::bytes(page), py::bytes(table));
}

Answer answer_of_state(const py::bytes& document, const py::bytes& page, const py::bytes& table) {
  const auto cbor = document.cast<std::string>();
  Answer answer{ordered_json::from_cbor(cbor), {}, {}};
  if (const auto text = page.cast<std::string>(); !text.empty()) {
    answer.report = [text](const ordered_json&) { return text; };
  }
  if (const auto text = table.cast<std::string>(); !text.empty()) {
    answer.csv = [text] { return text; };
  }
  return answer;
}

void bind_answer(py::module_& module) {
  using Unlocked = py::call_guard<py::gil_scoped_release>;
  py::class_<Answer>(module, "Answer")
      .def("document", [](const Answer& answer) { return to_python(answer.document); })
      .def(
          "json", [](const Answer& answer) { return app::write_json(answer.document); }, Unlocked())
      .def_property_readonly("has_report", [](const Answer& answer) { return bool(answer.report); })
      .def(
          "report", [](const Answer& answer) { return answer.report(answer.document); }, Unlocked())
      .def_property_readonly("has_csv", [](const Answer& answer) { return bool(answer.csv); })
      .def(
          "csv", [](const Answer& answer) { return answer.csv(); }, Unlocked())
      .def("state", &state);
}

}  // namespace

RunOptions checked(const Steering& steering) {
  std::vector<std::string> faults;
  RunOptions options;
  options.seed = parsed(steering.seed, app::parse_seed, faults).value_or(options.seed);
  options.threads = parsed(steering.threads, app::parse_threads, faults).value_or(options.threads);
  options.time_limit = parsed(steering.time_limit, app::parse_time_limit, faults);
  if (!steering.progress.is_none() && PyCallable_Check(steering.progress.ptr()) == 0) {
    faults.emplace_back(
        "progress is no function; expected True, False or a function of the share "
        "done and the best value so far");
  }
  raise_arguments(faults);
  return options;
}

void bind_problems(py::module_& module) {
  bind_answer(module);
  module.attr("__version__") = app::version();
  module.def("compute",
             [](const std::string& command, const py::object& given, const py::dict& tables,
                const py::object& seed, const py::object& threads, const py::object& time_limit,
                const py::object& progress) {
               return compute(command, given, tables, {seed, threads, time_limit, progress});
             });
  module.def("check", &check);
  module.def("list", &list);
  module.def("export_files", &export_files);
  module.def("analysis_tables", &analysis_tables);
  module.def("answer_of_document", &answer_of_document);
  module.def("answer_of_state", &answer_of_state);
  module.def("end_all", &end_all);
}

}  // namespace cognate::python
