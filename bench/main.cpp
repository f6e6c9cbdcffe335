// SPDX-License-Identifier: MIT
// Runs the benchmarks and prints beside each figure its ratio to the limit or the peer.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bars.hpp"

namespace vides::bench {
namespace {

double nanoseconds(const benchmark::BenchmarkReporter::Run& run) {
  if (run.iterations == 0) return 0.0;
  // A benchmark that measures its time itself does more than that in an iteration.
  const bool own = run.benchmark_name().find("/manual_time") != std::string::npos;
  const double seconds = own ? run.real_accumulated_time : run.cpu_accumulated_time;
  return seconds * 1e9 / static_cast<double>(run.iterations);
}

class Reporter : public benchmark::ConsoleReporter {
 public:
  Reporter() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> labelled = runs;
    for (Run& run : labelled) {
      times_[run.benchmark_name()] = nanoseconds(run);
      label(run);
    }
    ConsoleReporter::ReportRuns(labelled);
  }

 private:
  void label(Run& run) const {
    const double time = nanoseconds(run);
    if (const auto limit = run.counters.find(kLimitCounter); limit != run.counters.end()) {
      const double bar = limit->second.value;
      run.counters.erase(limit);
      run.report_label = fmt::format("{:.2f} of the limit, {:g} ns", time / bar, bar);
    }
    const std::string_view text = run.report_label;
    if (const std::string_view prefix = kPeerLabel; text.starts_with(prefix)) {
      const std::string peer(text.substr(prefix.size()));
      const auto found = times_.find(peer);
      run.report_label = found == times_.end()
                             ? fmt::format("{} was not run", peer)
                             : fmt::format("{:.2f} of {}", time / found->second, peer);
    }
  }

  std::map<std::string, double> times_;
};

}  // namespace
}  // namespace vides::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  vides::bench::Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
