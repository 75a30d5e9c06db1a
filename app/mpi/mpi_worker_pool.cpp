#include "app/mpi/mpi_worker_pool.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <stdexcept>
#include <thread>

#include "app/console/interrupt.hpp"
#include "app/study/block_message.hpp"

namespace cognate::app {
namespace {

using problems::StudyBlock;
using namespace std::chrono_literals;

constexpr int kFirst = 0;
/// With more processes the first has enough to do with storing what they send.
constexpr int kMostOthersWithOwnThreads = 16;
/// Blocks handed out ahead for each thread, so that none waits for the answer to its request.
constexpr int kBlocksAhead = 2;
/// How often messages are looked for; a thread that waits in MPI itself would use its processor.
constexpr auto kPollPeriod = 1ms;
/// For a process that ends to say so, when another one has a fault.
constexpr auto kFarewellPatience = 10s;

}  // namespace

std::optional<MpiMessage> received_message() {
  int there = 0;
  MPI_Status status{};
  MPI_Message handle{};
  MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &handle, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  MpiMessage message{status.MPI_SOURCE, static_cast<MpiTag>(status.MPI_TAG),
                     std::vector<std::byte>(static_cast<std::size_t>(size))};
  MPI_Mrecv(message.bytes.data(), size, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
  return message;
}

void send_message(int receiver, MpiTag tag, std::span<const std::byte> bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, receiver, static_cast<int>(tag),
           MPI_COMM_WORLD);
}

void send_text(int receiver, MpiTag tag, std::string_view text) {
  send_message(receiver, tag, std::as_bytes(std::span(text)));
}

void send_range(int receiver, const DesignRange& range) {
  send_message(receiver, MpiTag::work, std::as_bytes(std::span(&range, 1)));
}

void send_count(int receiver, std::int64_t count) {
  send_message(receiver, MpiTag::want, std::as_bytes(std::span(&count, 1)));
}

DesignRange range_of(const MpiMessage& message) {
  DesignRange range;
  std::memcpy(&range, message.bytes.data(), sizeof range);
  return range;
}

std::int64_t count_of(const MpiMessage& message) {
  std::int64_t count = 0;
  std::memcpy(&count, message.bytes.data(), sizeof count);
  return count;
}

std::string_view text_of(const MpiMessage& message) {
  return {reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()};
}

MpiCrew::MpiCrew(const EvaluatorMaker& maker, WorkList& work, int others, int threads)
    : work_(work), threads_(threads), present_(others + 1, true), others_(others) {
  if (others <= kMostOthersWithOwnThreads) {
    own_ = std::make_unique<ThreadCrew>(
        maker, [&work] { return work.next(); }, threads);
  }
}

MpiCrew::~MpiCrew() {
  stop();
  const auto deadline = std::chrono::steady_clock::now() + kFarewellPatience;
  while (others_ > 0 && std::chrono::steady_clock::now() < deadline) {
    if (const auto message = received_message()) {
      if (message->tag == MpiTag::done) take(*message);
    } else {
      std::this_thread::sleep_for(kPollPeriod);
    }
  }
  if (others_ > 0) MPI_Abort(MPI_COMM_WORLD, 3);
}

int MpiCrew::size() const {
  return threads_ * static_cast<int>(present_.size() - (own_ ? 0 : 1));
}

void MpiCrew::stop() {
  if (stopped_) return;
  stopped_ = true;
  if (own_) own_->stop();
  for (int rank = 1; rank < static_cast<int>(present_.size()); ++rank) {
    if (present_[rank]) send_message(rank, MpiTag::stop);
  }
}

bool MpiCrew::is_finished() {
  const bool own_finished = !own_ || own_->is_finished();
  if (others_ > 0 || !own_finished) return false;
  if (!fault_.empty()) throw std::runtime_error(std::exchange(fault_, ""));
  return true;
}

void MpiCrew::hand_out(int receiver, std::int64_t count) {
  for (; count > 0 && !stopped_; --count) {
    const auto range = work_.next();
    if (!range) {
      send_message(receiver, MpiTag::no_more);
      return;
    }
    send_range(receiver, *range);
  }
}

std::optional<StudyBlock> MpiCrew::take(const MpiMessage& message) {
  switch (message.tag) {
    case MpiTag::want:
      hand_out(message.sender, count_of(message));
      return std::nullopt;
    case MpiTag::block:
      hand_out(message.sender, 1);
      return block_of(message.bytes);
    case MpiTag::fault:
      fault_ = text_of(message);
      stop();
      return std::nullopt;
    default:
      present_[message.sender] = false;
      --others_;
      send_message(message.sender, MpiTag::farewell);
      return std::nullopt;
  }
}

std::optional<StudyBlock> MpiCrew::wait(std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  do {
    const auto message = received_message();
    if (message) {
      if (auto block = take(*message)) return block;
    }
    const auto pause = message ? 0ms : std::chrono::milliseconds(kPollPeriod);
    if (own_ && !own_->is_finished()) {
      if (auto block = own_->wait(pause)) return block;
    } else {
      std::this_thread::sleep_for(pause);
    }
  } while (std::chrono::steady_clock::now() < deadline && !(others_ == 0 && is_finished()));
  return std::nullopt;
}

namespace {

/// The work that a process has been given and not yet begun.
class Block {
 public:
  std::optional<DesignRange> next() { return queue_.pop(); }
  void close() { queue_.close(); }

  /// Takes in what the first process says.
  void take(const MpiMessage& message, StudyCrew& crew) {
    if (message.tag == MpiTag::work) queue_.push(range_of(message));
    if (message.tag == MpiTag::no_more) close();
    if (message.tag == MpiTag::stop) crew.stop();
  }

 private:
  /// As many as are requested.
  BoundedQueue<DesignRange> queue_{std::numeric_limits<std::size_t>::max()};
};

/// Sends the blocks of `crew` until it has finished.
void send_blocks(ThreadCrew& crew, Block& work) {
  const auto& interrupted = catch_interrupts();
  while (!crew.is_finished()) {
    while (const auto message = received_message()) work.take(*message, crew);
    if (interrupted) crew.stop();
    if (crew.is_stopped()) work.close();  // threads that wait for work end
    while (const auto block = crew.wait(kPollPeriod)) {
      send_message(kFirst, MpiTag::block, block_message(*block));
    }
  }
}

}  // namespace

void serve_first(const EvaluatorMaker& maker, int threads) {
  const auto work = std::make_shared<Block>();
  std::optional<ThreadCrew> crew;  // none where the system has no thread to give
  try {
    crew.emplace(
        maker, [work] { return work->next(); }, threads);
    send_count(kFirst, std::int64_t{kBlocksAhead} * crew->size());
    send_blocks(*crew, *work);
  } catch (const std::exception& error) {
    send_text(kFirst, MpiTag::fault, error.what());
  }
  work->close();
  send_message(kFirst, MpiTag::done);
  for (bool is_last = false; !is_last;) {
    if (const auto message = received_message()) {
      is_last = message->tag == MpiTag::farewell;
    } else {
      std::this_thread::sleep_for(kPollPeriod);
    }
  }
}

}  // namespace cognate::app
