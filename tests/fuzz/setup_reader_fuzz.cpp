// SPDX-License-Identifier: MIT
// Any bytes as a setup and as the list of recent files: refused, or read, and then written and read
// back as it is.
#include "edit/recent_files.hpp"
#include "edit/setup.hpp"
#include "flight/utf8.hpp"
#include "fuzz/require.hpp"
#include "io/problem_text.hpp"

namespace vides::test {
namespace {

void checkProblems(const std::vector<Problem>& problems) {
  require(!problems.empty() && problems.size() <= kMostProblems, "1 to 20 problems");
  for (const Problem& problem : problems) {
    const std::string line = problemLine("f", problem);
    require(line.size() > 4 && line.size() < 10'000, "a problem in words");
    require(line.find('\n') == line.npos && codePoints(line).has_value(),
            "a problem on one line of UTF-8");
  }
}

void checkRanges(const Setup& setup) {
  for (const ElementSize& size : kElementSizes) {
    require(size.range.contains(setup.display.sizes.*size.size), "sizes are in their range");
  }
  const Display& display = setup.display;
  require(display.contentScale == 0.0 || kContentScale.contains(display.contentScale),
          "the content scale is in its range");
  require(kGhostEvery.contains(display.shown.ghostEvery), "so is the distance of ghosts");
  require(kGridSteps.contains(display.gridStep), "so is the grid's step");
  const Layout& layout = setup.layout;
  require(kLeftWidth.contains(static_cast<double>(layout.left)) &&
              kRightWidth.contains(static_cast<double>(layout.right)) &&
              kTimelineHeight.contains(static_cast<double>(layout.timeline)),
          "so are columns and timeline");
}

}  // namespace
}  // namespace vides::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vides;
  using namespace vides::test;
  const std::string_view text = asText(data, size);
  if (const ReadSetup setup = readSetup(text)) {
    checkRanges(*setup);
    const std::string written = writeSetup(*setup);
    const ReadSetup again = readSetup(written);
    require(again && *again == *setup, "a setup that was written is read as it was");
    require(writeSetup(*again) == written, "and written the same again");
  } else {
    checkProblems(setup.error());
  }
  const std::vector<std::string> recent = readRecentFiles(text);
  require(readRecentFiles(writeRecentFiles(recent)) == recent, "recent files stay as they are");
  return 0;
}
