// SPDX-License-Identifier: MIT
// EGL without a surface: the same pictures as OSMesa within its tolerance, and refusals in
// sentences.
#include "host/egl_host.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/osmesa_host.hpp"
#include "support/picture_check.hpp"
#include "support/process.hpp"
#include "support/triangle.hpp"

// What EGL's drivers keep until the process ends cannot be told apart from a leak of ours.
extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() { return 1; }

namespace vides {
namespace {

using test::drawTriangle;
using test::runProcess;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::unique_ptr<OffscreenHost> openHost(PixelSize size) {
  EglOptions options;
  options.samples = 4;
  options.size = size;
  auto host = openEglHost(options);
  EXPECT_TRUE(host) << host.error();
  return host ? std::move(*host) : nullptr;
}

Picture triangle(PixelSize size) {
  const auto host = openHost(size);
  EXPECT_TRUE(drawTriangle(*host));
  return host->picture().value();
}

class EglHost : public testing::Test {
 protected:
  void SetUp() override {
    EglOptions options;
    options.size = {16, 16};
    if (const auto host = openEglHost(options); !host) GTEST_SKIP() << host.error();
  }
};

constexpr PictureTolerance kTolerance{.share = kEglShare};

TEST_F(EglHost, EqualsOsmesasBaseline) {
  EXPECT_TRUE(test::equalsBaseline(triangle({200, 100}), "host_triangle", kTolerance));
}

// The tolerance must not be so wide that it accepts what is drawn one pixel away.
TEST_F(EglHost, BaselineIsSensitive) {
  const Picture picture = triangle({200, 100});
  Picture moved(200, 100);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) {
      const auto from = picture.pixel((x + 199) % 200, y);
      std::copy(from.begin(), from.end(), moved.pixel(x, y).begin());
    }
  }
  EXPECT_FALSE(comparePictures(moved, picture, kTolerance).equal);
}

TEST_F(EglHost, BesideOsmesaInOneProcess) {
  const auto egl = openHost({60, 40});
  EXPECT_TRUE(drawTriangle(*egl));
  const Picture alone = egl->picture().value();
  OsmesaOptions options;
  options.size = {60, 40};
  options.samples = 4;
  // Each must draw with its own context: two more here, so that names of objects differ.
  const auto plain = openOsmesaHost({{.size = {80, 60}}}).value();
  const auto osmesa = openOsmesaHost(options).value();
  EXPECT_TRUE(drawTriangle(*egl));
  EXPECT_TRUE(egl->picture().value() == alone);
  EXPECT_TRUE(drawTriangle(*plain));
  EXPECT_TRUE(drawTriangle(*osmesa));
  EXPECT_TRUE(drawTriangle(*egl));
  EXPECT_TRUE(egl->picture().value() == alone);
  EXPECT_TRUE(test::equalsPicture(egl->picture().value(), osmesa->picture().value(),
                                  "egl_beside_osmesa", kTolerance));
}

TEST_F(EglHost, TwoAtOnceAndOneAfterTheOther) {
  const auto first = openHost({40, 30});
  openHost({80, 60}).reset();
  EXPECT_TRUE(drawTriangle(*first));
  EXPECT_EQ(first->picture().value(), triangle({40, 30}));
}

// Other code that uses the library tells nobody.
TEST_F(EglHost, DrawsAfterOtherCodeHasTakenItsContextAway) {
  const auto host = openHost({40, 30});
  void* const library = dlopen("libEGL.so.1", RTLD_NOW);
  using CurrentDisplay = void* (*)();
  using MakeCurrent = unsigned (*)(void*, void*, void*, void*);
  const auto display = reinterpret_cast<CurrentDisplay>(dlsym(library, "eglGetCurrentDisplay"))();
  const auto makeCurrent = reinterpret_cast<MakeCurrent>(dlsym(library, "eglMakeCurrent"));
  makeCurrent(display, nullptr, nullptr, nullptr);
  EXPECT_TRUE(drawTriangle(*host));
  makeCurrent(display, nullptr, nullptr, nullptr);
  EXPECT_EQ(host->picture().value(), triangle({40, 30}));
  dlclose(library);
}

TEST_F(EglHost, SizesAtTheEdge) {
  EXPECT_EQ(triangle({1, 1}).pixel(0, 0)[3], 255);
  EXPECT_EQ(triangle({16000, 100}).width, 16000);
  EXPECT_FALSE(openHost({0, 0})->beginDrawing());
  EglOptions options;
  options.samples = 4;
  options.size = {40000, 100};
  EXPECT_THAT(openEglHost(options).error(), AllOf(HasSubstr("40000 × 100"), HasSubstr("at most")));
}

TEST(EglMissing, LibraryIsASentence) {
  EglOptions options;
  options.samples = 4;
  options.library = "libEGL.so.nowhere";
  EXPECT_THAT(openEglHost(options).error(),
              AllOf(StartsWith("EGL is missing: "), HasSubstr("libEGL.so.nowhere")));
  options.library = "libm.so.6";
  EXPECT_EQ(openEglHost(options).error(), "libm.so.6 is not EGL 1.4");
}

TEST_F(EglHost, TooOldOpenGlIsASentence) {
  const auto result =
      runProcess({VIDES_HOST_PROBE, "egl", "64x48"}, {"MESA_GL_VERSION_OVERRIDE=2.1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, StartsWith("OpenGL 3.3 is needed; this is 2.1 ("));
}

}  // namespace
}  // namespace vides
