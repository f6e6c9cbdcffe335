// SPDX-License-Identifier: MIT
// The table of OpenGL functions: filled by whichever loader, or refused in a sentence.
#include "render/gl_functions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "render/gl_objects.hpp"
#include "support/offscreen.hpp"

namespace vides {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A driver in a few lines: loaders take plain function addresses, so what it says is chosen by
// type.
struct Driver33 {
  static constexpr const char* kVersion = "3.3 (Core Profile) Test 1.0";
};
struct Driver21 {
  static constexpr const char* kVersion = "2.1 Test 1.0";
};
struct Driver32 {
  static constexpr const char* kVersion = "3.2 Test 1.0";
};
struct DriverEs {
  static constexpr const char* kVersion = "OpenGL ES 3.2 Test";
};
struct NoContext {
  static constexpr const char* kVersion = nullptr;
};
template <typename Driver>
const GLubyte* APIENTRY stringOf(GLenum name) {
  const char* text = name == GL_VERSION ? Driver::kVersion : "a test";
  return reinterpret_cast<const GLubyte*>(text);
}
void APIENTRY integersOf(GLenum name, GLint* values) {
  *values = 4096;
  if (name == GL_MAX_VIEWPORT_DIMS) values[1] = 1024;
}
void APIENTRY nothing() {}

// Everything but the functions whose names are in `lacking`.
template <typename Driver>
tl::expected<Gl, std::string> load(const std::string& lacking = "") {
  return loadGl([&](const char* name) -> GlFunction {
    if (lacking.find(std::string(name) + ";") != std::string::npos) return nullptr;
    if (std::strcmp(name, "glGetString") == 0) {
      return reinterpret_cast<GlFunction>(&stringOf<Driver>);
    }
    if (std::strcmp(name, "glGetIntegerv") == 0) return reinterpret_cast<GlFunction>(&integersOf);
    return &nothing;
  });
}

TEST(LoadGl, Fills) {
  const auto gl = load<Driver33>();
  ASSERT_TRUE(gl) << gl.error();
  EXPECT_EQ(gl->limits.major, 3);
  EXPECT_EQ(gl->limits.minor, 3);
  EXPECT_EQ(gl->limits.maxWidth, 4096);
  EXPECT_EQ(gl->limits.maxHeight, 1024);
  EXPECT_EQ(gl->limits.renderer, "a test");
}

TEST(LoadGl, RefusesInSentences) {
  EXPECT_EQ(load<Driver21>().error(), "OpenGL 3.3 is needed; this is 2.1 (Test 1.0, a test)");
  EXPECT_EQ(load<Driver32>().error(), "OpenGL 3.3 is needed; this is 3.2 (Test 1.0, a test)");
  EXPECT_EQ(load<DriverEs>().error(), "OpenGL 3.3 is needed; this is OpenGL ES 3.2 Test");
  EXPECT_EQ(load<NoContext>().error(), "OpenGL has no current context");
  EXPECT_EQ(load<Driver33>("glGetString;").error(), "no OpenGL was found");
  EXPECT_THAT(load<Driver33>("glBindSampler;glViewport;").error(),
              HasSubstr("lacks glBindSampler, glViewport"));
  // What is too old says so, whatever it lacks.
  EXPECT_THAT(load<Driver21>("glBindSampler;glGetIntegerv;").error(), HasSubstr("this is 2.1"));
}

class GlObjects : public testing::Test {
 protected:
  std::unique_ptr<OffscreenHost> host_ = test::openForTest({8, 8});
};

TEST_F(GlObjects, ErrorsAreToldOnce) {
  const Gl& gl = host_->gl();
  EXPECT_TRUE(checkGl(gl, "before"));
  gl.Enable(0xFFFF);
  EXPECT_EQ(checkGl(gl, "enabling").error(), "enabling: OpenGL reports an invalid enumerant");
  EXPECT_TRUE(checkGl(gl, "after"));
}

TEST_F(GlObjects, ShaderErrorsNameTheShader) {
  const std::string good = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
  EXPECT_THAT(ShaderProgram::build(host_->gl(), "odd", "nonsense", good).error(),
              AllOf(HasSubstr("shader odd, vertices"), HasSubstr("error")));
  EXPECT_THAT(ShaderProgram::build(host_->gl(), "odd", good, "nonsense").error(),
              HasSubstr("shader odd, fragments"));
  const std::string gives =
      "#version 330 core\nout vec2 it;\nvoid main() { it = vec2(0.0); gl_Position = vec4(0.0); }\n";
  const std::string wants =
      "#version 330 core\nin vec4 it;\nout vec4 c;\nvoid main() { c = it; }\n";
  EXPECT_THAT(ShaderProgram::build(host_->gl(), "odd", gives, wants).error(),
              HasSubstr("shader odd: "));
}

TEST_F(GlObjects, BuffersHoldWhatIsPutThere) {
  const Gl& gl = host_->gl();
  Buffer buffer(gl, GL_ARRAY_BUFFER);
  const std::array<std::uint8_t, 6> all = {1, 2, 3, 4, 5, 6};
  const std::array<std::uint8_t, 2> part = {9, 8};
  buffer.upload(std::as_bytes(std::span(all)), GL_STATIC_DRAW);
  buffer.update(3, std::as_bytes(std::span(part)));
  std::array<std::uint8_t, 6> read{};
  gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, 6, read.data());
  EXPECT_THAT(read, testing::ElementsAre(1, 2, 3, 9, 8, 6));
  EXPECT_EQ(buffer.size(), 6u);
  Buffer moved = std::move(buffer);
  EXPECT_NE(moved.id(), 0u);
  EXPECT_EQ(buffer.id(), 0u);
}

TEST_F(GlObjects, TextureSizesAreChecked) {
  EXPECT_THAT(Texture::create(host_->gl(), 0, 5, {}).error(), HasSubstr("0 × 5"));
  EXPECT_THAT(Texture::create(host_->gl(), 5, 1 << 20, {}).error(), HasSubstr("1048576"));
  EXPECT_TRUE(Texture::create(host_->gl(), 5, 7, {}));
}

}  // namespace
}  // namespace vides
