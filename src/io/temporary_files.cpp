// SPDX-License-Identifier: MIT
// A fixed array of slots without locks, so that a signal handler may read it at any moment.
#include "io/temporary_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace vides {
namespace {

constexpr std::size_t kSlots = 64;
constexpr std::size_t kNameBytes = 64;

enum : int { kFree, kFilling, kSet };

struct Slot {
  std::atomic<int> state{kFree};
  std::atomic<int> folder{-1};
  std::array<char, kNameBytes> name{};
};
static_assert(std::atomic<int>::is_always_lock_free, "used in a signal handler");

std::array<Slot, kSlots>& slots() noexcept {
  static constinit std::array<Slot, kSlots> all{};
  return all;
}

void onSignal(int signal) {
  const int error = errno;
  removeTemporaryFiles();
  errno = error;
  // SA_RESETHAND has brought the default back.
  raise(signal);
}

}  // namespace

int rememberTemporaryFile(int folder, std::string_view name) noexcept {
  if (name.size() >= kNameBytes) return -1;
  for (std::size_t i = 0; i < kSlots; ++i) {
    Slot& slot = slots()[i];
    int expected = kFree;
    if (!slot.state.compare_exchange_strong(expected, kFilling)) continue;
    slot.folder = folder;
    std::memcpy(slot.name.data(), name.data(), name.size());
    slot.name[name.size()] = '\0';
    slot.state.store(kSet, std::memory_order_release);
    return static_cast<int>(i);
  }
  return -1;
}

void forgetTemporaryFile(int slot) noexcept {
  if (slot >= 0) slots()[static_cast<std::size_t>(slot)].state = kFree;
}

void removeTemporaryFiles() noexcept {
  for (Slot& slot : slots()) {
    if (slot.state.load(std::memory_order_acquire) != kSet) continue;
    unlinkat(slot.folder, slot.name.data(), 0);
  }
}

void removeTemporaryFilesOnSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace vides
