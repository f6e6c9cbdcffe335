// SPDX-License-Identifier: MIT
// OSMesa: a context without a screen draws, the same bytes each time, and refuses in sentences.
#include "host/osmesa_host.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "support/picture_check.hpp"
#include "support/process.hpp"
#include "support/triangle.hpp"

namespace vides {
namespace {

using test::drawTriangle;
using test::runProcess;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::unique_ptr<OffscreenHost> openHost(PixelSize size, int samples = 4) {
  OsmesaOptions options;
  options.size = size;
  options.samples = samples;
  auto host = openOsmesaHost(options);
  EXPECT_TRUE(host) << host.error();
  return host ? std::move(*host) : nullptr;
}

Picture triangle(PixelSize size) {
  const auto host = openHost(size);
  EXPECT_TRUE(drawTriangle(*host));
  return host->picture().value();
}

std::string fileOf(const std::string& name) {
  const auto folder = std::filesystem::path(testing::TempDir());
  return (folder / (name + "." + std::to_string(getpid()) + ".rgba")).string();
}

std::string bytesOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(OsmesaHost, HasOpenGl33) {
  const auto host = openHost({64, 48});
  const GlLimits& limits = host->gl().limits;
  EXPECT_GE(limits.major * 10 + limits.minor, 33);
  EXPECT_GE(limits.maxWidth, 8192);
  EXPECT_GE(limits.maxSamples, 4);
  EXPECT_NE(limits.renderer, "");
}

TEST(OsmesaHost, DrawsTopRowFirst) {
  const Picture picture = triangle({200, 100});
  ASSERT_EQ(picture.width, 200);
  ASSERT_EQ(picture.height, 100);
  // The ground, in a corner; then close to the corners of the triangle.
  EXPECT_THAT(picture.pixel(1, 1), ElementsAre(26, 26, 26, 255));
  EXPECT_GT(picture.pixel(24, 93)[0], 200);   // red, left below
  EXPECT_GT(picture.pixel(184, 84)[1], 200);  // green, right below
  EXPECT_GT(picture.pixel(109, 13)[2], 200);  // blue, on top
}

TEST(OsmesaHost, SmoothsEdgesBySamples) {
  const auto count = [](int samples) {
    const auto host = openHost({200, 100}, samples);
    EXPECT_TRUE(drawTriangle(*host));
    const Picture picture = host->picture().value();
    // Inside the triangle the three colours add up to 255; the ground is 26 in each.
    int between = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      const int sum = picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2];
      if (sum > 78 + 5 && sum < 255 - 5) ++between;
    }
    return between;
  };
  EXPECT_EQ(count(0), 0);
  EXPECT_EQ(count(1), 0);
  EXPECT_GT(count(4), 200);
  EXPECT_GT(count(1000), 200);  // as many as there are
}

TEST(OsmesaHost, EqualsItsBaseline) {
  EXPECT_TRUE(test::equalsBaseline(triangle({200, 100}), "host_triangle"));
}

TEST(OsmesaHost, SamePixelsOverRunsAndThreads) {
  const Picture here = triangle({320, 240});
  const std::string expected(here.rgba.begin(), here.rgba.end());
  for (const char* threads : {"0", "1", "2", "2"}) {
    const std::string file = fileOf("triangle");
    const auto result = runProcess({VIDES_HOST_PROBE, "osmesa", "320x240", file},
                                   {std::string("LP_NUM_THREADS=") + threads});
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_TRUE(bytesOf(file) == expected) << threads << " threads";
    std::filesystem::remove(file);
  }
  EXPECT_TRUE(triangle({320, 240}) == here);
}

TEST(OsmesaHost, TwoAtOnceEachWithItsTable) {
  const auto small = openHost({40, 30});
  const auto large = openHost({80, 60});
  EXPECT_TRUE(drawTriangle(*small));
  EXPECT_TRUE(drawTriangle(*large));
  EXPECT_EQ(small->picture().value(), triangle({40, 30}));
  EXPECT_EQ(large->picture().value(), triangle({80, 60}));
}

// Other code that uses the library tells nobody.
TEST(OsmesaHost, DrawsAfterOtherCodeHasTakenItsContextAway) {
  const auto host = openHost({40, 30});
  void* const library = dlopen("libOSMesa.so.8", RTLD_NOW);
  using MakeCurrent = unsigned char (*)(void*, void*, unsigned, int, int);
  const auto makeCurrent = reinterpret_cast<MakeCurrent>(dlsym(library, "OSMesaMakeCurrent"));
  ASSERT_NE(makeCurrent, nullptr);
  makeCurrent(nullptr, nullptr, 0x1401, 0, 0);  // unsigned bytes
  EXPECT_TRUE(drawTriangle(*host));
  makeCurrent(nullptr, nullptr, 0x1401, 0, 0);
  EXPECT_EQ(host->picture().value(), triangle({40, 30}));
  dlclose(library);
}

TEST(OsmesaHost, NothingDrawnIsTransparentBlack) {
  const auto host = openHost({5, 4});
  EXPECT_EQ(host->picture().value(), Picture(5, 4));
}

TEST(OsmesaHost, OnePixel) {
  const auto host = openHost({1, 1});
  EXPECT_TRUE(drawTriangle(*host));
  const Picture picture = host->picture().value();
  EXPECT_EQ(picture.width, 1);
  EXPECT_EQ(picture.pixel(0, 0)[3], 255);
}

TEST(OsmesaHost, NoPixelIsAHostThatDrawsNothing) {
  const auto host = openHost({0, 0});
  EXPECT_FALSE(host->beginDrawing());
  EXPECT_EQ(host->picture().value(), Picture());
  host->swap();
  ASSERT_TRUE(host->resize({30, 20}, 1.0));
  EXPECT_TRUE(drawTriangle(*host));
  EXPECT_EQ(host->picture().value(), triangle({30, 20}));
  ASSERT_TRUE(host->resize({0, 20}, 1.0));
  EXPECT_FALSE(host->beginDrawing());
}

TEST(OsmesaHost, VeryWide) {
  const Picture picture = triangle({16000, 100});
  ASSERT_EQ(picture.width, 16000);
  EXPECT_GT(picture.pixel(14700, 83)[1], 200);
}

TEST(OsmesaHost, TooLargeIsASentence) {
  OsmesaOptions options;
  options.size = {40000, 100};
  EXPECT_THAT(openOsmesaHost(options).error(),
              AllOf(HasSubstr("40000 × 100"), HasSubstr("at most 16384 × 16384")));
  options.size = {16000, 16000};
  EXPECT_THAT(openOsmesaHost(options).error(), HasSubstr("more than 67 million pixels"));
  options.size = {2147483647, 2147483647};
  EXPECT_THAT(openOsmesaHost(options).error(), HasSubstr("at most"));

  const auto host = openHost({30, 20});
  EXPECT_TRUE(drawTriangle(*host));
  const Picture before = host->picture().value();
  EXPECT_FALSE(host->resize({40000, 100}, 2.0));
  EXPECT_EQ(host->size(), (PixelSize{30, 20}));
  EXPECT_EQ(host->contentScale(), 1.0);
  EXPECT_EQ(host->picture().value(), before);
  EXPECT_TRUE(host->takeEvents().empty());
}

// A program that links to an OpenGL of its own would fight with the one that a host loads.
TEST(OsmesaHost, ProgramsLinkToNoOpenGl) {
  const auto result = runProcess({"readelf", "--dynamic", "--wide", VIDES_HOST_PROBE});
  ASSERT_EQ(result.status, 0) << result.errors;
  ASSERT_THAT(result.output, HasSubstr("[libc.so"));
  for (const char* library : {"libGL.", "libGLX", "libOpenGL", "libOSMesa", "libEGL", "libepoxy"}) {
    EXPECT_THAT(result.output, testing::Not(HasSubstr(library)));
  }
}

TEST(OsmesaHost, MissingLibraryIsASentence) {
  OsmesaOptions options;
  options.library = "libOSMesa.so.nowhere";
  EXPECT_THAT(openOsmesaHost(options).error(),
              AllOf(StartsWith("OSMesa is missing: "), HasSubstr("libOSMesa.so.nowhere")));
  options.library = "libm.so.6";
  EXPECT_THAT(openOsmesaHost(options).error(), HasSubstr("libm.so.6 is not an OSMesa"));
}

TEST(OsmesaHost, TooOldOpenGlIsASentence) {
  const auto result =
      runProcess({VIDES_HOST_PROBE, "osmesa", "64x48"}, {"MESA_GL_VERSION_OVERRIDE=2.1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, StartsWith("OpenGL 3.3 is needed; this is 2.1 ("));
  EXPECT_THAT(result.errors, HasSubstr("Mesa"));
}

TEST(OffscreenHost, EventsAreThosePushed) {
  const auto host = openHost({10, 10});
  host->push(PointerMoved{3.5, 4.25});
  ASSERT_TRUE(host->resize({20, 10}, 2.0));
  ASSERT_TRUE(host->resize({20, 10}, 2.0));  // nothing changed, nothing told
  host->push(CloseRequested{});
  EXPECT_THAT(host->takeEvents(),
              ElementsAre(InputEvent(PointerMoved{3.5, 4.25}), InputEvent(Resized{{20, 10}, 2.0}),
                          InputEvent(CloseRequested{})));
  EXPECT_TRUE(host->takeEvents().empty());
  EXPECT_EQ(host->contentScale(), 2.0);
}

TEST(OffscreenHost, TimeGoesByHand) {
  const auto host = openHost({10, 10});
  EXPECT_EQ(host->time(), 0.0);
  host->advanceTime(0.5);
  host->advanceTime(0.25);
  EXPECT_EQ(host->time(), 0.75);
}

// The bounds only keep a broken wait from hanging the test.
TEST(OffscreenHost, WaitsEndByEventsAndWake) {
  using std::chrono::steady_clock;
  constexpr std::chrono::seconds kLong(60);
  const auto start = steady_clock::now();
  const auto host = openHost({10, 10});
  host->push(Exposed{});
  host->waitForEvents(kLong);
  EXPECT_EQ(host->takeEvents().size(), 1u);
  host->wake();  // before the wait
  host->waitForEvents(kLong);
  std::thread other([&] { host->wake(); });  // before or during
  host->waitForEvents(kLong);
  other.join();
  EXPECT_LT(steady_clock::now() - start, kLong);

  const auto before = steady_clock::now();
  host->waitForEvents(std::chrono::milliseconds(20));
  EXPECT_GE(steady_clock::now() - before, std::chrono::milliseconds(20));
}

TEST(OffscreenHost, RemembersClipboardTitleCursorAndFullScreen) {
  const auto host = openHost({10, 10});
  EXPECT_EQ(host->clipboard(), "");
  host->setClipboard("Schlüssel « »");
  EXPECT_EQ(host->clipboard(), "Schlüssel « »");
  host->setTitle("pyramid ●");
  EXPECT_EQ(host->title(), "pyramid ●");
  host->setCursor(CursorShape::kHand);
  EXPECT_EQ(host->cursor(), CursorShape::kHand);
  host->setFullScreen(true);
  EXPECT_TRUE(host->fullScreen());
}

}  // namespace
}  // namespace vides
