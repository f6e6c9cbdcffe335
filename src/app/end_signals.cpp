// SPDX-License-Identifier: MIT
// A thread that reads signals from a descriptor: there everything may be done, which in a handler
// hardly anything may.
#include "app/end_signals.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace vides {
namespace {

sigset_t ending() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&set, signal);
  }
  return set;
}

[[noreturn]] void endBy(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  raise(signal);        // its handler removes what is half written
  _exit(128 + signal);  // should it have been caught by somebody else
}

}  // namespace

EndSignals::EndSignals() {
  const sigset_t set = ending();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signals_ = signalfd(-1, &set, SFD_CLOEXEC);
  stop_ = eventfd(0, EFD_CLOEXEC);
  if (signals_ < 0 || stop_ < 0) {
    // Without descriptors they do what they always did.
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    return;
  }
  thread_ = std::thread([this] { watch(); });
}

EndSignals::~EndSignals() {
  if (thread_.joinable()) {
    eventfd_write(stop_, 1);
    thread_.join();
    const sigset_t set = ending();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
  if (signals_ >= 0) close(signals_);
  if (stop_ >= 0) close(stop_);
}

void EndSignals::leaveTo(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

void EndSignals::finish() { endBy(came_); }

void EndSignals::watch() {
  pollfd files[] = {{signals_, POLLIN, 0}, {stop_, POLLIN, 0}};
  while (true) {
    if (poll(files, 2, -1) < 0 && errno != EINTR) return;
    if (files[1].revents != 0) return;
    signalfd_siginfo info{};
    if (files[0].revents == 0 || read(signals_, &info, sizeof info) != sizeof info) continue;
    onSignal(static_cast<int>(info.ssi_signo));
  }
}

void EndSignals::onSignal(int signal) {
  const std::lock_guard lock(mutex_);
  int none = 0;
  if (!wake_ || !came_.compare_exchange_strong(none, signal)) endBy(signal);
  wake_();
}

}  // namespace vides
