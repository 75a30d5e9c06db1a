#include "problems/chain/output/question.hpp"

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

}  // namespace

std::optional<OutputQuestion> output_question(const NamedMechanism& mechanism,
                                              const std::array<std::string, 2>& output,
                                              const std::vector<double>& angles) {
  auto [question, kept] = question_at(mechanism, angles);
  const auto first = point_response(mechanism, output[0]);
  const auto second = point_response(mechanism, output[1]);
  if (!first || !second || kept.size() != angles.size()) return std::nullopt;
  ToleranceQuantity angle{.name = "output", .judged = true};
  const int body = mechanism.points[second->index].at.body;
  angle.response = {.type = ResponseType::angle, .index = static_cast<std::size_t>(body)};
  return asked(mechanism, std::move(question), std::move(angle));
}

std::optional<OutputQuestion> displacement_question(const NamedMechanism& mechanism,
                                                    const std::string& pin, const Vec2d& direction,
                                                    const std::vector<double>& angles) {
  auto [question, kept] = question_at(mechanism, angles);
  auto response = point_response(mechanism, pin);
  if (!response || kept.size() != angles.size()) return std::nullopt;
  response->type = ResponseType::along;
  response->direction = direction;
  ToleranceQuantity displacement{.name = "output", .response = *response, .judged = true};
  return asked(mechanism, std::move(question), std::move(displacement));
}

}  // namespace cognate::problems
