#include "app/studio/workbench.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/commands/problem_text.hpp"
#include "app/commands/task_computation.hpp"
#include "app/study/cache_folder.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

std::string page_of(const Computation& computation, const nlohmann::ordered_json& document) {
  const auto page = std::ranges::find(computation.files, kReportEnding, &OutputFile::ending);
  return page == computation.files.end() ? "" : page->text(document);
}

}  // namespace

struct Workbench::Job {
  std::uint64_t number;
  Computation computation;
  std::atomic<bool> stopping{false};
};

Workbench::Workbench(Options options)
    : options_(std::move(options)), report_(std::make_shared<std::string>()) {
  worker_ = std::thread([this] { work(); });
}

Workbench::~Workbench() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    if (job_) job_->stopping = true;
  }
  asked_.notify_all();
  worker_.join();
}

tl::expected<std::uint64_t, std::vector<problems::Fault>> Workbench::solve(
    const std::string& text, const std::filesystem::path& folder) {
  auto computation = text_computation(text, folder, options_);
  if (!computation) return tl::unexpected(std::move(computation.error()));
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (job_) job_->stopping = true;
    number = state_.run + 1;
    job_ = std::make_shared<Job>(number, std::move(*computation));
    is_taken_ = false;
    state_ = {.run = number,
              .phase = RunState::Phase::solving,
              .report = state_.report,
              .designs = state_.designs};
    begun_ = Clock::now();
  }
  asked_.notify_all();
  changed_();
  return number;
}

void Workbench::stop() {
  const std::lock_guard lock(mutex_);
  if (job_) job_->stopping = true;
}

RunState Workbench::state() const {
  const std::lock_guard lock(mutex_);
  RunState state = state_;
  if (state.phase == RunState::Phase::solving) {
    state.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
  }
  return state;
}

std::shared_ptr<const std::string> Workbench::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

std::shared_ptr<const nlohmann::ordered_json> Workbench::result() const {
  const std::lock_guard lock(mutex_);
  return result_;
}

void Workbench::work() {
  while (true) {
    std::shared_ptr<Job> job;
    {
      std::unique_lock lock(mutex_);
      asked_.wait(lock, [this] { return closing_ || !is_taken_; });
      if (closing_) return;
      is_taken_ = true;
      job = job_;
      begun_ = Clock::now();
    }
    try {
      run(job);
    } catch (const std::exception& error) {
      update(*job, [&] {
        state_.phase = RunState::Phase::failed;
        state_.message = std::string("a fault of Cognate's own: ") + error.what();
      });
    }
  }
}

template <class Change>
void Workbench::update(const Job& job, Change change) {
  {
    const std::lock_guard lock(mutex_);
    if (closing_ || job_->number != job.number) return;
    change();
  }
  changed_();
}

void Workbench::run(const std::shared_ptr<Job>& job) {
  const auto note_progress = [&](double share, double best) {
    update(*job, [&] { state_.progress.update(share, best); });
  };
  const auto note_phase = [&](problems::Phase begun, double to) {
    update(*job, [&] { state_.progress.enter(problems::to_string(begun), to); });
  };
  note_phase(problems::Phase::search, 1);
  const auto status = job->computation.run({.seed = options_.seed,
                                            .threads = options_.threads,
                                            .time_limit = options_.time_limit,
                                            .interrupted = &job->stopping,
                                            .cache = cache_folder(),
                                            .progress = note_progress,
                                            .phase = note_phase});
  {
    const std::lock_guard lock(mutex_);
    if (closing_ || job_ != job) return;  // nobody waits for its page
  }
  auto document = job->computation.document();
  auto page = std::make_shared<const std::string>(document ? page_of(job->computation, *document)
                                                           : std::string());
  update(*job, [&] {
    state_.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    state_.phase = document ? RunState::Phase::done : RunState::Phase::failed;
    state_.status = problems::to_string(status);
    if (!document) {
      state_.message = "a fault of Cognate's own: " + document.error();
      return;
    }
    const auto designs = document->find("designs");
    state_.report = job->number;
    state_.designs = designs == document->end() ? 0 : designs->size();
    report_ = std::move(page);
    result_ = std::make_shared<const nlohmann::ordered_json>(std::move(*document));
  });
}

}  // namespace cognate::app
