// SPDX-License-Identifier: MIT
// Framebuffers of one's own beside the host's: what is drawn there is read back and can be shown.
#include "render/framebuffer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/offscreen.hpp"

namespace vides {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class FramebufferTest : public testing::TestWithParam<int> {
 protected:
  // Fills a rectangle, counted from the lower left corner.
  void fill(int x, int y, int width, int height, float red, float green, float blue) {
    const Gl& gl = host_->gl();
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(x, y, width, height);
    gl.ClearColor(red, green, blue, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  std::unique_ptr<OffscreenHost> host_ = test::openForTest({8, 8});
};

// 7 pixels make rows of 28 bytes, 5 rows have a middle one.
TEST_P(FramebufferTest, ReadsTopRowFirst) {
  auto framebuffer = Framebuffer::create(host_->gl(), 7, 5, GetParam()).value();
  framebuffer.bind();
  fill(0, 0, 7, 5, 0, 0, 0);
  fill(0, 0, 7, 1, 1, 0, 0);  // bottom
  fill(0, 4, 7, 1, 0, 1, 0);  // top
  fill(6, 2, 1, 1, 0, 0, 1);  // right, middle
  framebuffer.resolve();      // must not be cut by the scissor
  const Picture picture = framebuffer.read().value();
  ASSERT_EQ(picture.width, 7);
  ASSERT_EQ(picture.height, 5);
  EXPECT_THAT(picture.pixel(3, 0), ElementsAre(0, 255, 0, 255));
  EXPECT_THAT(picture.pixel(3, 4), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(picture.pixel(6, 2), ElementsAre(0, 0, 255, 255));
  EXPECT_THAT(picture.pixel(5, 2), ElementsAre(0, 0, 0, 255));
  EXPECT_THAT(picture.pixel(3, 1), ElementsAre(0, 0, 0, 255));
}

TEST_P(FramebufferTest, LeavesTheHostAlone) {
  const Gl& gl = host_->gl();
  auto framebuffer = Framebuffer::create(gl, 16, 16, GetParam()).value();
  framebuffer.bind();
  fill(0, 0, 16, 16, 1, 1, 1);
  framebuffer.resolve();
  ASSERT_TRUE(host_->beginDrawing());
  host_->swap();
  EXPECT_EQ(host_->picture().value(), Picture(8, 8));
  EXPECT_THAT(framebuffer.read().value().pixel(9, 9), ElementsAre(255, 255, 255, 255));
  EXPECT_TRUE(checkGl(gl, "framebuffers"));
}

TEST_P(FramebufferTest, SamplesAreThoseThereAre) {
  const auto framebuffer = Framebuffer::create(host_->gl(), 4, 4, GetParam()).value();
  EXPECT_EQ(framebuffer.samples(), GetParam() < 2 ? 0 : 4);
}

TEST_P(FramebufferTest, RefusesSizes) {
  const Gl& gl = host_->gl();
  EXPECT_THAT(Framebuffer::create(gl, 0, 10, GetParam()).error(), HasSubstr("0 × 10"));
  EXPECT_THAT(Framebuffer::create(gl, 10, -1, GetParam()).error(), HasSubstr("10 × -1"));
  EXPECT_THAT(Framebuffer::create(gl, 10, 16385, GetParam()).error(),
              HasSubstr("at most 16384 × 16384"));
  EXPECT_TRUE(checkGl(gl, "refusals"));
}

INSTANTIATE_TEST_SUITE_P(Samples, FramebufferTest, testing::Values(0, 1, 4, 64));

}  // namespace
}  // namespace vides
