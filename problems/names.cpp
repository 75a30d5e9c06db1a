#include "problems/names.hpp"

namespace cognate::problems {
namespace {

constexpr Named<Assembly> kAssemblies[] = {{"open", Assembly::open},
                                           {"crossed", Assembly::crossed}};
constexpr Named<MobilityClass> kMobilityClasses[] = {
    {"crank-rocker", MobilityClass::crank_rocker},
    {"double-crank", MobilityClass::double_crank},
    {"rocker-crank", MobilityClass::rocker_crank},
    {"double-rocker", MobilityClass::double_rocker},
    {"triple-rocker", MobilityClass::triple_rocker}};
constexpr Named<RequiredClass> kRequiredClasses[] = {
    {"crank-rocker", RequiredClass::crank_rocker},
    {"double-crank", RequiredClass::double_crank},
    {"rocker-crank", RequiredClass::rocker_crank},
    {"double-rocker", RequiredClass::double_rocker},
    {"triple-rocker", RequiredClass::triple_rocker},
    {"grashof", RequiredClass::grashof},
    {"non-grashof", RequiredClass::non_grashof}};
constexpr Named<MovingPoint> kMovingPoints[] = {
    {"coupler-point", MovingPoint::coupler_point}, {"B", MovingPoint::b}, {"C", MovingPoint::c}};
constexpr Named<MovingLink> kMovingLinks[] = {
    {"crank", MovingLink::crank}, {"coupler", MovingLink::coupler}, {"rocker", MovingLink::rocker}};
constexpr Named<SolverChoice> kSolvers[] = {
    {"auto", SolverChoice::automatic}, {"gauss-newton", SolverChoice::gauss_newton},
    {"ceres", SolverChoice::ceres},    {"slsqp", SolverChoice::slsqp},
    {"mma", SolverChoice::mma},        {"ccsaq", SolverChoice::ccsaq},
    {"cobyla", SolverChoice::cobyla},  {"bobyqa", SolverChoice::bobyqa},
    {"ags", SolverChoice::ags},        {"isres", SolverChoice::isres},
    {"crs", SolverChoice::crs},        {"mlsl", SolverChoice::mlsl},
    {"direct", SolverChoice::direct},  {"ipopt", SolverChoice::ipopt}};
constexpr Named<Timing> kTimings[] = {
    {"free", Timing::free}, {"prescribed", Timing::prescribed}, {"mixed", Timing::mixed}};
constexpr Named<CrankReference> kCrankReferences[] = {{"first", CrankReference::first},
                                                      {"frame", CrankReference::frame},
                                                      {"global", CrankReference::global}};
constexpr Named<CrankSense> kCrankSenses[] = {
    {"either", CrankSense::either}, {"ccw", CrankSense::ccw}, {"cw", CrankSense::cw}};
constexpr Named<PointOrder> kPointOrders[] = {{"cyclic", PointOrder::cyclic},
                                              {"any", PointOrder::any}};
constexpr Named<CurvePlace> kCurvePlaces[] = {{"given", CurvePlace::given},
                                              {"similar", CurvePlace::similar}};
constexpr Named<PathMethod> kPathMethods[] = {{"least-squares", PathMethod::least_squares},
                                              {"exact", PathMethod::exact}};
constexpr Named<MotionMethod> kMotionMethods[] = {{"exact", MotionMethod::exact},
                                                  {"least-squares", MotionMethod::least_squares}};
constexpr Named<FunctionStart> kFunctionStarts[] = {
    {"free", FunctionStart::free},
    {"outer-dead-centre", FunctionStart::outer_dead_centre},
    {"inner-dead-centre", FunctionStart::inner_dead_centre}};
constexpr Named<FunctionObjective> kFunctionObjectives[] = {
    {"exact", FunctionObjective::exact},
    {"least-squares", FunctionObjective::least_squares},
    {"minimax", FunctionObjective::minimax}};
constexpr Named<PointSpacing> kPointSpacings[] = {{"chebyshev", PointSpacing::chebyshev},
                                                  {"equal-peaks", PointSpacing::equal_peaks}};
constexpr Named<BestBy> kBestBy[] = {{"error", BestBy::error},
                                     {"transmission", BestBy::transmission}};
constexpr Named<Measure> kMeasures[] = {{"error", Measure::error},
                                        {"transmission_angle", Measure::transmission_angle},
                                        {"link_ratio", Measure::link_ratio},
                                        {"size", Measure::size},
                                        {"peak_acceleration", Measure::peak_acceleration},
                                        {"torque_ripple", Measure::torque_ripple},
                                        {"speed_fluctuation", Measure::speed_fluctuation},
                                        {"flywheel_inertia", Measure::flywheel_inertia},
                                        {"motor_power", Measure::motor_power}};
constexpr Named<ErrorMeasure> kErrorMeasures[] = {
    {"rms_error_max", ErrorMeasure::rms_length},
    {"rms_error_deg_max", ErrorMeasure::rms_angle},
    {"max_error_deg_max", ErrorMeasure::largest_angle}};
constexpr Named<MechanismType> kMechanismTypes[] = {
    {"four-bar", MechanismType::four_bar},
    {"slider-crank", MechanismType::slider_crank},
    {"guide-bar", MechanismType::guide_bar},
    {"oscillating-block", MechanismType::oscillating_block},
    {"fixed-block", MechanismType::fixed_block},
    {"scotch-yoke", MechanismType::scotch_yoke},
    {"tangent-generator", MechanismType::tangent_generator},
    {"elliptic-trammel", MechanismType::elliptic_trammel},
    {"oldham-coupling", MechanismType::oldham_coupling},
    {"chain", MechanismType::chain}};
constexpr Named<QuickReturnType> kQuickReturnTypes[] = {
    {"four-bar", QuickReturnType::four_bar},
    {"slider-crank", QuickReturnType::slider_crank},
    {"guide-bar", QuickReturnType::guide_bar},
    {"shaper", QuickReturnType::shaper}};
constexpr Named<DyadType> kDyadTypes[] = {{"RRR", DyadType::rrr},
                                          {"RRP", DyadType::rrp},
                                          {"RPR", DyadType::rpr},
                                          {"PRP", DyadType::prp},
                                          {"RPP", DyadType::rpp}};
constexpr Named<LoadSense> kLoadSenses[] = {
    {"always", LoadSense::always}, {"advance", LoadSense::advance}, {"return", LoadSense::retreat}};
constexpr Named<MachineTask> kMachineTasks[] = {
    {"steady", MachineTask::steady}, {"start", MachineTask::start}, {"stop", MachineTask::stop}};
constexpr Named<Status> kStatuses[] = {{"solved", Status::solved},
                                       {"infeasible", Status::infeasible},
                                       {"no-solution", Status::no_solution},
                                       {"time-limit", Status::time_limit},
                                       {"interrupted", Status::interrupted}};
constexpr Named<Defect> kDefects[] = {
    {"circuit", Defect::circuit}, {"branch", Defect::branch}, {"order", Defect::order}};

constexpr Named<synthesis::Loss> kLosses[] = {
    {"none", synthesis::Loss::none},       {"huber", synthesis::Loss::huber},
    {"soft-l1", synthesis::Loss::soft_l1}, {"cauchy", synthesis::Loss::cauchy},
    {"arctan", synthesis::Loss::arctan},   {"tukey", synthesis::Loss::tukey}};
constexpr Named<synthesis::DyadKind> kDyadKinds[] = {{"RR", synthesis::DyadKind::rr},
                                                     {"PR", synthesis::DyadKind::pr},
                                                     {"RP", synthesis::DyadKind::rp}};

}  // namespace

template <>
std::span<const Named<Assembly>> names<Assembly>() {
  return kAssemblies;
}

template <>
std::span<const Named<MobilityClass>> names<MobilityClass>() {
  return kMobilityClasses;
}

template <>
std::span<const Named<RequiredClass>> names<RequiredClass>() {
  return kRequiredClasses;
}

template <>
std::span<const Named<MovingPoint>> names<MovingPoint>() {
  return kMovingPoints;
}

template <>
std::span<const Named<MovingLink>> names<MovingLink>() {
  return kMovingLinks;
}

template <>
std::span<const Named<SolverChoice>> names<SolverChoice>() {
  return kSolvers;
}

template <>
std::span<const Named<Timing>> names<Timing>() {
  return kTimings;
}

template <>
std::span<const Named<CrankReference>> names<CrankReference>() {
  return kCrankReferences;
}

template <>
std::span<const Named<CrankSense>> names<CrankSense>() {
  return kCrankSenses;
}

template <>
std::span<const Named<PointOrder>> names<PointOrder>() {
  return kPointOrders;
}

template <>
std::span<const Named<CurvePlace>> names<CurvePlace>() {
  return kCurvePlaces;
}

template <>
std::span<const Named<PathMethod>> names<PathMethod>() {
  return kPathMethods;
}

template <>
std::span<const Named<MotionMethod>> names<MotionMethod>() {
  return kMotionMethods;
}

template <>
std::span<const Named<FunctionStart>> names<FunctionStart>() {
  return kFunctionStarts;
}

template <>
std::span<const Named<FunctionObjective>> names<FunctionObjective>() {
  return kFunctionObjectives;
}

template <>
std::span<const Named<PointSpacing>> names<PointSpacing>() {
  return kPointSpacings;
}

template <>
std::span<const Named<BestBy>> names<BestBy>() {
  return kBestBy;
}

template <>
std::span<const Named<Measure>> names<Measure>() {
  return kMeasures;
}

template <>
std::span<const Named<ErrorMeasure>> names<ErrorMeasure>() {
  return kErrorMeasures;
}

template <>
std::span<const Named<MechanismType>> names<MechanismType>() {
  return kMechanismTypes;
}

template <>
std::span<const Named<QuickReturnType>> names<QuickReturnType>() {
  return kQuickReturnTypes;
}
template <>
std::span<const Named<DyadType>> names<DyadType>() {
  return kDyadTypes;
}

template <>
std::span<const Named<LoadSense>> names<LoadSense>() {
  return kLoadSenses;
}

template <>
std::span<const Named<MachineTask>> names<MachineTask>() {
  return kMachineTasks;
}

template <>
std::span<const Named<Status>> names<Status>() {
  return kStatuses;
}

template <>
std::span<const Named<Defect>> names<Defect>() {
  return kDefects;
}

template <>
std::span<const Named<synthesis::Loss>> names<synthesis::Loss>() {
  return kLosses;
}

template <>
std::span<const Named<synthesis::DyadKind>> names<synthesis::DyadKind>() {
  return kDyadKinds;
}

}  // namespace cognate::problems
