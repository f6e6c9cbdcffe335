// SPDX-License-Identifier: MIT
// Dear ImGui's draw lists become the right pixels: clipping, textures, blending, many vertices.
#include "render/imgui_renderer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <optional>

#include "support/offscreen.hpp"
#include "support/picture_check.hpp"

namespace vides {
namespace {

using testing::ElementsAre;

// A host, a context of ImGui and what draws it.
class Ui {
 public:
  explicit Ui(PixelSize size, OffscreenKind kind = OffscreenKind::kOsmesa, int samples = 0)
      : host_(test::openForTest(size, kind, samples)),
        context_(ImGui::CreateContext()),
        renderer_(ImguiRenderer::create(host_->gl()).value()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    ImguiRenderer::announce(io);
    EXPECT_TRUE(renderer_->uploadFonts(*io.Fonts));
  }
  Ui(const Ui&) = delete;
  Ui& operator=(const Ui&) = delete;
  ~Ui() { ImGui::DestroyContext(context_); }

  const Gl& gl() const { return host_->gl(); }
  OffscreenHost& host() { return *host_; }
  ImguiRenderer& renderer() { return *renderer_; }

  // One display frame at that scale, on black.
  Picture draw(const std::function<void()>& content, float scale = 1.0f) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    const PixelSize size = host_->size();
    io.DisplaySize = {static_cast<float>(size.width) / scale,
                      static_cast<float>(size.height) / scale};
    io.DisplayFramebufferScale = {scale, scale};
    io.DeltaTime = 1.0f / 60.0f;
    ImGui::NewFrame();
    content();
    ImGui::Render();
    host_->beginDrawing();
    gl().ClearColor(0, 0, 0, 1);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    renderer_->draw(*ImGui::GetDrawData());
    host_->swap();
    EXPECT_TRUE(checkGl(gl(), "drawing"));
    return host_->picture().value();
  }

 private:
  std::unique_ptr<OffscreenHost> host_;
  ImGuiContext* context_;
  std::optional<ImguiRenderer> renderer_;
};

constexpr ImU32 kRed = IM_COL32(255, 0, 0, 255);

// That exactly the pixels left ≤ x < right, top ≤ y < bottom are red, all others black.
void expectRed(const Picture& picture, int left, int top, int right, int bottom) {
  int wrong = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool inside = x >= left && x < right && y >= top && y < bottom;
      if (picture.pixel(x, y)[0] != (inside ? 255 : 0)) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(ImguiRenderer, ClipsInPixelsAtAnyScale) {
  const auto content = [] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.PushClipRect({10, 4}, {30, 16});
    list.AddRectFilled({0, 0}, {60, 40}, kRed);
    list.PopClipRect();
  };
  Ui ui({60, 40});
  expectRed(ui.draw(content), 10, 4, 30, 16);
  expectRed(ui.draw(content, 2.0f), 20, 8, 60, 32);
  expectRed(ui.draw(content, 0.75f), 8, 3, 23, 12);
  expectRed(ui.draw(content, 1.5f), 15, 6, 45, 24);
}

TEST(ImguiRenderer, ClipsAtTheEdges) {
  Ui ui({60, 40});
  const auto clipped = [&](ImVec2 from, ImVec2 to) {
    return ui.draw([&] {
      ImDrawList& list = *ImGui::GetForegroundDrawList();
      list.PushClipRect(from, to);
      list.AddRectFilled({-100, -100}, {200, 200}, kRed);
      list.PopClipRect();
    });
  };
  expectRed(clipped({-50, -50}, {20, 10}), 0, 0, 20, 10);
  expectRed(clipped({50, 30}, {500, 500}), 50, 30, 60, 40);
  expectRed(clipped({70, 10}, {90, 20}), 0, 0, 0, 0);
  expectRed(clipped({20, 10}, {20, 30}), 0, 0, 0, 0);
}

TEST(ImguiRenderer, DrawsWhereTheDisplayBegins) {
  Ui ui({60, 40});
  ui.draw([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.PushClipRectFullScreen();
    list.AddRectFilled({10, 4}, {30, 16}, kRed);
    list.PopClipRect();
  });
  ImDrawData data = *ImGui::GetDrawData();
  data.DisplayPos = {5, 3};
  ui.host().beginDrawing();
  ui.gl().Clear(GL_COLOR_BUFFER_BIT);
  ui.renderer().draw(data);
  ui.host().swap();
  expectRed(ui.host().picture().value(), 5, 1, 25, 13);
}

TEST(ImguiRenderer, ManyTextures) {
  Ui ui({80, 20});
  // 16 textures of one pixel, each of its own colour.
  std::array<Texture, 16> textures;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const std::array<std::uint8_t, 4> pixel = {static_cast<std::uint8_t>(i * 16), 77,
                                               static_cast<std::uint8_t>(255 - i), 255};
    textures[i] = Texture::create(ui.gl(), 1, 1, pixel, TextureFilter::kNearest).value();
  }
  const Picture picture = ui.draw([&] {
    for (std::size_t i = 0; i < textures.size(); ++i) {
      const auto x = static_cast<float>(i) * 5;
      ImGui::GetForegroundDrawList()->AddImage(imguiTexture(textures[i].id()), {x, 0}, {x + 5, 20});
    }
  });
  for (int i = 0; i < 16; ++i) {
    EXPECT_THAT(picture.pixel(i * 5 + 2, 10), ElementsAre(i * 16, 77, 255 - i, 255)) << i;
  }
}

TEST(ImguiRenderer, TexturesStandUpright) {
  Ui ui({4, 4});
  // clang-format off
  const std::array<std::uint8_t, 16> pixels = {10, 0, 0, 255,  20, 0, 0, 255,
                                               30, 0, 0, 255,  40, 0, 0, 255};
  // clang-format on
  auto texture = Texture::create(ui.gl(), 2, 2, pixels, TextureFilter::kNearest).value();
  const auto content = [&] {
    ImGui::GetForegroundDrawList()->AddImage(imguiTexture(texture.id()), {0, 0}, {4, 4});
  };
  const Picture picture = ui.draw(content);
  EXPECT_EQ(picture.pixel(0, 0)[0], 10);
  EXPECT_EQ(picture.pixel(3, 0)[0], 20);
  EXPECT_EQ(picture.pixel(0, 3)[0], 30);
  EXPECT_EQ(picture.pixel(3, 3)[0], 40);
  texture.update(std::array<std::uint8_t, 16>{90, 0, 0, 255});
  EXPECT_EQ(ui.draw(content).pixel(0, 0)[0], 90);
}

// Half of 255 over 100 in plain sRGB numbers: 100 + (255 − 100) · 128 / 255.
TEST(ImguiRenderer, BlendsPlainNumbers) {
  Ui ui({8, 8});
  const Picture picture = ui.draw([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({0, 0}, {8, 8}, IM_COL32(100, 100, 100, 255));
    list.AddRectFilled({0, 0}, {8, 8}, IM_COL32(255, 255, 255, 128));
  });
  EXPECT_NEAR(picture.pixel(4, 4)[0], 178, 1);
  EXPECT_EQ(picture.pixel(4, 4)[3], 255);
}

// 40,000 rectangles of one pixel, each of its own colour, in one list: 160,000 vertices.
TEST(ImguiRenderer, MoreVerticesThanAnIndexCanName) {
  Ui ui({200, 200}, OffscreenKind::kOsmesa, 0);
  const auto colour = [](int x, int y) { return IM_COL32(x + 20, y + 20, (x * y) % 251, 255); };
  const Picture picture = ui.draw([&] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        const ImVec2 corner(static_cast<float>(x), static_cast<float>(y));
        list.AddRectFilled(corner, {corner.x + 1, corner.y + 1}, colour(x, y));
      }
    }
  });
  unsigned int greatest = 0;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
      greatest = std::max(greatest, command.VtxOffset);
    }
  }
  EXPECT_GT(greatest, 65535u);
  int wrong = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const auto p = picture.pixel(x, y);
      if (IM_COL32(p[0], p[1], p[2], p[3]) != colour(x, y)) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(ImguiRenderer, CallbacksComeInOrderAndStateIsRestored) {
  Ui ui({20, 20});
  struct Spoiler {
    const Gl* gl;
    int calls;
  } spoiler{&ui.gl(), 0};
  const Picture picture = ui.draw([&] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({0, 0}, {10, 20}, kRed);
    list.AddCallback(
        [](const ImDrawList*, const ImDrawCmd* command) {
          auto& data = *static_cast<Spoiler*>(command->UserCallbackData);
          data.calls++;
          data.gl->UseProgram(0);
          data.gl->BindVertexArray(0);
          data.gl->Viewport(0, 0, 1, 1);
          data.gl->Disable(GL_BLEND);
        },
        &spoiler);
    list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
    list.AddRectFilled({10, 0}, {20, 20}, kRed);
  });
  EXPECT_EQ(spoiler.calls, 1);
  expectRed(picture, 0, 0, 20, 20);
}

TEST(ImguiRenderer, NeedsNoStateAndLeavesNone) {
  Ui ui({20, 20});
  const Gl& gl = ui.gl();
  for (const GLenum state : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_PRIMITIVE_RESTART}) {
    gl.Enable(state);
  }
  gl.CullFace(GL_FRONT_AND_BACK);
  gl.DepthFunc(GL_NEVER);
  gl.StencilFunc(GL_NEVER, 0, 0xFF);
  gl.PrimitiveRestartIndex(1);
  gl.ActiveTexture(GL_TEXTURE0 + 3);
  const Picture picture = ui.draw([] {
    ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {10, 20}, kRed);
  });
  expectRed(picture, 0, 0, 10, 20);
  for (const GLenum state :
       {GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CLIP_DISTANCE0}) {
    EXPECT_EQ(gl.IsEnabled(state), GL_FALSE) << state;
  }
}

// As a minimised window makes it.
TEST(ImguiRenderer, NothingToDrawOn) {
  Ui ui({0, 0});
  EXPECT_EQ(ui.draw([] { ImGui::ShowDemoWindow(); }), Picture());
}

// A window with a texture beside the fonts' and a clipped part; another full of widgets over it.
void interfaceAt(float x, const Texture& texture) {
  ImGui::SetNextWindowPos({x, 10});
  ImGui::SetNextWindowSize({220, 280});
  ImGui::Begin("Schlüssel", nullptr, ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextUnformatted("x = 0.25  y = -1.00");
  float value = 0.4f;
  ImGui::SliderFloat("tension", &value, 0, 1);
  ImGui::Button("Pos +");
  ImGui::Image(imguiTexture(texture.id()), {80, 40});
  ImGui::BeginChild("clipped", {150, 40}, true);
  for (int i = 0; i < 10; ++i) ImGui::Text("line %d, too long for its place to be seen whole", i);
  ImGui::EndChild();
  ImGui::End();
  ImGui::SetNextWindowPos({200, 30});
  ImGui::SetNextWindowSize({240, 250});
  ImGui::Begin("style", nullptr, ImGuiWindowFlags_NoSavedSettings);
  ImGui::ShowStyleEditor();
  ImGui::End();
}

Picture drawInterface(float x, OffscreenKind kind = OffscreenKind::kOsmesa, float scale = 1.0f) {
  Ui ui({static_cast<int>(450 * scale), static_cast<int>(300 * scale)}, kind);
  const std::array<std::uint8_t, 8> pixels = {255, 160, 0, 255, 0, 90, 200, 255};
  const auto texture = Texture::create(ui.gl(), 2, 1, pixels).value();
  Picture picture;
  // The first display frames find sizes out.
  for (int i = 0; i < 3; ++i) picture = ui.draw([&] { interfaceAt(x, texture); }, scale);
  return picture;
}

TEST(ImguiRenderer, InterfaceEqualsItsBaseline) {
  const Picture picture = drawInterface(10);
  EXPECT_TRUE(test::equalsBaseline(picture, "imgui_window"));
  EXPECT_EQ(picture, drawInterface(10)) << "each run the same";
  EXPECT_FALSE(comparePictures(drawInterface(11), picture).equal) << "one pixel aside";
}

TEST(ImguiRenderer, InterfaceAtScaleTwoEqualsItsBaseline) {
  EXPECT_TRUE(test::equalsBaseline(drawInterface(10, OffscreenKind::kOsmesa, 2.0f),
                                   "imgui_window_scale_2"));
}

TEST(ImguiRenderer, InterfaceThroughEgl) {
  if (!test::hasEgl()) GTEST_SKIP() << "no EGL here";
  constexpr PictureTolerance kTolerance{.share = kEglShare};
  const Picture picture = drawInterface(10, OffscreenKind::kEgl);
  EXPECT_TRUE(test::equalsBaseline(picture, "imgui_window", kTolerance));
  EXPECT_FALSE(comparePictures(drawInterface(11, OffscreenKind::kEgl), picture, kTolerance).equal)
      << "one pixel aside";
  EXPECT_TRUE(test::equalsBaseline(drawInterface(10, OffscreenKind::kEgl, 2.0f),
                                   "imgui_window_scale_2", kTolerance));
}

TEST(ImguiRenderer, FontsMayChange) {
  const auto text = [] {
    ImGui::GetForegroundDrawList()->AddText({4, 4}, IM_COL32_WHITE, "Key 3 of 7");
  };
  const auto useFont = [](Ui& ui, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    ImFontConfig config;
    config.SizePixels = size;
    atlas.AddFontDefault(&config);
    EXPECT_TRUE(ui.renderer().uploadFonts(atlas));
  };
  Ui changing({200, 40});
  const Picture small = changing.draw(text);
  useFont(changing, 26);
  const Picture large = changing.draw(text);
  EXPECT_FALSE(comparePictures(small, large).equal);
  useFont(changing, 13);
  EXPECT_EQ(changing.draw(text), small);

  Ui fresh({200, 40});
  useFont(fresh, 26);
  EXPECT_EQ(fresh.draw(text), large);
}

TEST(ImguiRenderer, TwoContextsEachWithItsHost) {
  Ui first({60, 40});
  Ui second({40, 30});
  const auto content = [] { ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {9, 9}, kRed); };
  expectRed(first.draw(content), 0, 0, 9, 9);
  expectRed(second.draw(content), 0, 0, 9, 9);
  expectRed(first.draw(content), 0, 0, 9, 9);
}

}  // namespace
}  // namespace vides
