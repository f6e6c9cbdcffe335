// SPDX-License-Identifier: MIT
// How long files take: opening and writing a `.vid` with 100,000 keys.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "bars.hpp"
#include "flight/limits.hpp"
#include "io/read_file.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

constexpr std::size_t kKeys = 100'000;

// As a program would write it: all digits.
Flight largeFlight() {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  std::vector<KeyPointer> keys;
  for (std::size_t i = 0; i < kKeys; ++i) {
    Key key;
    key.position = {share(engine), share(engine), share(engine)};
    Orientation& o = key.orientations.front();
    o.aim = {3.0 + share(engine), share(engine), share(engine)};
    o.roll = 30.0 * share(engine);
    o.zoom = 50.0 + 40.0 * share(engine);
    for (double& v : o.speed) v = std::round(50.0 + 40.0 * share(engine));
    keys.emplace_back(std::move(key));
  }
  Flight flight;
  flight.keys = KeyList(std::move(keys));
  return flight;
}

// A file for as long as the benchmarks run.
class LargeFile {
 public:
  LargeFile()
      : path_((std::filesystem::temp_directory_path() /
               ("vides-bench-" + std::to_string(getpid()) + ".vid"))
                  .string()) {
    if (saveVid(largeFlight(), path_)) std::abort();
  }
  ~LargeFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  LargeFile(const LargeFile&) = delete;
  LargeFile& operator=(const LargeFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

const std::string& largeFile() {
  static const LargeFile file;
  return file.path();
}

void parseVidNlohmann(benchmark::State& state) {
  const std::string& path = largeFile();
  for (auto _ : state) {
    const auto text = readFile(path, limits::kFileSize);
    nlohmann::json json = nlohmann::json::parse(*text);
    benchmark::DoNotOptimize(json);
  }
}
BENCHMARK(parseVidNlohmann)->Unit(benchmark::kMillisecond);

void openVid(benchmark::State& state) {
  const std::string& path = largeFile();
  for (auto _ : state) {
    ReadFlight flight = readVidFile(path);
    if (!flight) std::abort();
    benchmark::DoNotOptimize(flight);
  }
  bench::setPeer(state, "parseVidNlohmann");
}
BENCHMARK(openVid)->Unit(benchmark::kMillisecond);

void writeLargeVid(benchmark::State& state) {
  const Flight flight = readVidFile(largeFile()).value();
  for (auto _ : state) {
    std::size_t bytes = 0;
    writeVid(flight, [&](std::string_view piece) {
      bytes += piece.size();
      return true;
    });
    benchmark::DoNotOptimize(bytes);
  }
}
BENCHMARK(writeLargeVid)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vides
