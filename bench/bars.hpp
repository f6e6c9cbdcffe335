// SPDX-License-Identifier: MIT
// What a benchmark is held against: a limit in nanoseconds, or a peer measured in the same run.
//
// The reporter in main.cpp prints the ratio beside the figure; nothing fails by it.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

namespace vides::bench {

inline constexpr const char* kLimitCounter = "limit_ns";
inline constexpr const char* kPeerLabel = "peer: ";

// One iteration (one item) shall take no longer than this.
inline void setLimit(benchmark::State& state, double nanoseconds) {
  state.counters[kLimitCounter] = nanoseconds;
}

// The name of a benchmark that is registered before this one and does the same by other means.
inline void setPeer(benchmark::State& state, const std::string& name) {
  state.SetLabel(kPeerLabel + name);
}

}  // namespace vides::bench
