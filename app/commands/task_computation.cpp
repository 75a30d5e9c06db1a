#include "app/commands/task_computation.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/kinds/kinds.hpp"

namespace cognate::app {
namespace {

/// Of a cam's table over its turn.
constexpr int kTurnSteps = 360;

template <class K, class Problem>
constexpr bool has_turn_table = requires(const Problem& problem, const typename K::Result& result) {
  K::csv(problem, result, kTurnSteps);
};

/// A problem, and what came of it.
template <class K, class Problem>
struct Case {
  explicit Case(Problem given) : problem(std::move(given)) {}
  Problem problem;
  typename K::Result result;
};

/// The files of a result besides the document.
template <class K, class Problem>
std::vector<OutputFile> files_of(const std::shared_ptr<const Case<K, Problem>>& of,
                                 const Options& options) {
  std::vector<OutputFile> files;
  if constexpr (requires { K::csv(of->problem, of->result); }) {
    files.push_back({".csv", [of](const auto&) { return K::csv(of->problem, of->result); }});
  } else if constexpr (has_turn_table<K, Problem>) {
    const int steps = options.steps.value_or(kTurnSteps);
    files.push_back(
        {".csv", [of, steps](const auto&) { return K::csv(of->problem, of->result, steps); }});
  }
  files.push_back({kReportEnding, [of](const auto& document) {
                     return report_html(document, of->problem, of->result);
                   }});
  return files;
}

template <class K, class Problem>
tl::expected<Computation, std::vector<problems::Fault>> computation_of(Problem problem,
                                                                       const Options& options) {
  auto known = K::known_designs(problem);
  if (!known) return tl::unexpected(std::move(known.error()));
  const auto of = std::make_shared<Case<K, Problem>>(std::move(problem));
  return Computation{
      .run =
          [of, designs = std::move(*known)](problems::Run run) {
            run.known = designs;
            of->result = K::run(of->problem, run);
            return of->result.status;
          },
      .document = [of,
                   seed = options.seed] { return result_document(of->problem, of->result, seed); },
      .files = files_of<K, Problem>(of, options),
      .when_interrupted = K::kWhenInterrupted,
      .table =
          [of](Screen screen) {
            screen.length = length_word(of->problem.length_unit);
            return K::table(of->problem, of->result, screen);
          },
      .exit_status = [of] { return K::is_done(of->result) ? exit_done : exit_no_design; }};
}

}  // namespace

tl::expected<Computation, std::vector<problems::Fault>> task_computation(problems::Task task,
                                                                         const Options& options) {
  return std::visit(
      [&]<class Problem>(Problem&& problem) {
        using Own = std::remove_cvref_t<Problem>;
        return computation_of<Kind<Own>, Own>(std::forward<Problem>(problem), options);
      },
      std::move(task));
}

std::string task_refusal(const problems::Task& task, Command command) {
  return visit_kind(task, [&]<class K>(K, const auto& problem) {
    return std::string(K::refusal(problem, command));
  });
}

bool has_steps(const problems::Task& task) {
  return visit_kind(
      task, []<class K, class Problem>(K, const Problem&) { return has_turn_table<K, Problem>; });
}

}  // namespace cognate::app
