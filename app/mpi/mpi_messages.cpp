#include "app/mpi/mpi_messages.hpp"

#include <mpi.h>

#include <cstring>

namespace cognate::app {

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

}  // namespace cognate::app
