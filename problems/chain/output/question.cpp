#include "problems/chain/output/question.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "problems/chain/topology.hpp"

namespace cognate::problems {
namespace {

OutputQuestion asked(const NamedMechanism& mechanism, ToleranceQuestion question,
                     ToleranceQuantity output) {
  OutputQuestion asked;
  std::vector<Attached<double>> points;
  for (const NamedPoint& point : mechanism.points) points.push_back(point.at);
  ChangedMechanism<double> nominal({mechanism.mechanism, points});
  for (const Station& station : question.stations) {
    nominal.move_to(station);
    asked.way.push_back(nominal.value(output.response));
  }
  question.quantities.push_back(std::move(output));
  asked.question = std::move(question);
  return asked;
}

/// The body of the slider with this pin, not that of the link that is pinned to it.
std::optional<int> slider_of(const NamedMechanism& mechanism, const std::string& pin) {
  const auto dyad = slider_dyad(mechanism, pin);
  if (!dyad) return std::nullopt;
  return first_body(mechanism.mechanism, *dyad) + 1;
}

}  // namespace

std::optional<OutputQuestion> output_question(const NamedMechanism& mechanism,
                                              const std::array<std::string, 2>& output,
                                              const std::vector<double>& angles) {
  auto [question, kept] = question_at(mechanism, angles);
  const auto first = point_response(mechanism, output[0]);
  const auto second = point_response(mechanism, output[1]);
  if (!first || !second || kept.size() != angles.size()) return std::nullopt;
  ToleranceQuantity angle{.name = "output", .judged = true};
  angle.response = {.type = ResponseType::direction, .index = first->index, .to = second->index};
  return asked(mechanism, std::move(question), std::move(angle));
}

std::optional<OutputQuestion> displacement_question(const NamedMechanism& mechanism,
                                                    const std::string& pin,
                                                    const std::vector<double>& angles) {
  auto [question, kept] = question_at(mechanism, angles);
  const auto slider = slider_of(mechanism, pin);
  if (!slider || kept.size() != angles.size()) return std::nullopt;
  ToleranceQuantity displacement{
      .name = "output", .response = travel_response(mechanism.mechanism, *slider), .judged = true};
  return asked(mechanism, std::move(question), std::move(displacement));
}

}  // namespace cognate::problems
