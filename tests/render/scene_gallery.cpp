// SPDX-License-Identifier: MIT
// Writes pictures of the sample flights with their labels, for looking at: scene_gallery FOLDER.
#include <imgui.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "render/imgui_renderer.hpp"
#include "support/scene_painter.hpp"

namespace {

using namespace vides;

void require(const tl::expected<void, std::string>& result) {
  if (!result) throw std::runtime_error(result.error());
}

class Gallery {
 public:
  explicit Gallery(std::filesystem::path folder, PixelSize size, float scale)
      : folder_(std::move(folder)), size_(size), scale_(scale), painter_(size) {
    std::filesystem::create_directories(folder_);
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.Fonts->AddFontFromFileTTF("/usr/share/fonts/opentype/inter/Inter-Medium.otf", 13 * scale);
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    texts_ = std::make_unique<ImguiRenderer>(ImguiRenderer::create(painter_.host().gl()).value());
    texts_->announce(io);
    require(texts_->uploadFonts(*io.Fonts));
  }
  ~Gallery() { ImGui::DestroyContext(); }

  void write(const std::string& name, const DrawList& list) {
    painter_.host().beginDrawing();
    painter_.renderer().draw(list, size_.width, size_.height);
    ImGui::NewFrame();
    for (const DrawText& text : list.texts) {
      const Colour c = text.colour;
      ImGui::GetForegroundDrawList()->AddText(
          {static_cast<float>(text.pixel.x), static_cast<float>(text.pixel.y)},
          IM_COL32(c.red, c.green, c.blue, c.alpha), text.text.c_str());
    }
    ImGui::Render();
    texts_->draw(*ImGui::GetDrawData());
    painter_.host().swap();
    auto& host = dynamic_cast<OffscreenHost&>(painter_.host());
    require(writePng(host.picture().value(), folder_ / (name + ".png")));
    const auto& s = painter_.statistics();
    std::printf("%s: %zu elements, %zu draws, %zu bytes uploaded\n", name.c_str(), s.elements,
                s.drawCalls, s.uploadedBytes);
  }

  ViewportInput input(const std::string& name) {
    ViewportInput result = test::viewportInput(test::sample(name));
    result.rectangle = {0, 0, static_cast<double>(size_.width), static_cast<double>(size_.height)};
    result.contentScale = scale_;
    result.text.digitWidth = result.text.letterWidth = 8.0 * scale_;
    result.text.lineHeight = 16.0 * scale_;
    return result;
  }

 private:
  std::filesystem::path folder_;
  PixelSize size_;
  float scale_;
  test::ScenePainter painter_;
  std::unique_ptr<ImguiRenderer> texts_;
};

void writeFlights(Gallery& gallery) {
  struct View {
    const char* name;
    double turn, tilt;
  };
  constexpr View kViews[] = {{"iso", 32, 22}, {"front", 0, 0}, {"side", 90, 0}, {"top", 0, 90}};
  for (const char* flight : {"pyramid", "closed-orbit", "dolly"}) {
    ViewportScene scene;
    ViewportInput input = gallery.input(flight);
    for (const View& view : kViews) {
      for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
        input.view.turn = view.turn;
        input.view.tilt = view.tilt;
        input.view.type = type;
        const char* suffix = type == ProjectionType::Parallel ? "" : "_perspective";
        gallery.write(std::string(flight) + "_" + view.name + suffix, scene.build(input));
      }
    }
    CameraScene camera;
    const test::Sample sample = test::sample(flight);
    CameraInput seen;
    seen.picture = sample.flight.picture;
    seen.lens = sample.flight.lens;
    seen.scenes = sample.scenes;
    seen.rectangle = input.rectangle;
    seen.thirds = seen.safeFrames = true;
    for (const int part : {0, 1, 2, 3}) {
      const auto frame = input.evaluation.frame(input.evaluation.frameCount() * part / 3);
      seen.camera = frame.camera;
      gallery.write(std::string(flight) + "_camera" + std::to_string(part), camera.build(seen));
    }
  }
}

void writeStates(Gallery& gallery) {
  ViewportScene scene;
  ViewportInput input = gallery.input("pyramid");
  input.state.selected = {1, 2, 4};
  input.state.hovered = HandleId{HandleKind::kKey, 2, 0, Axis::X};
  gallery.write("hover", scene.build(input));
  input.state.drag = DragDisplay{input.evaluation.flight().keys[2].position, Axis::Y};
  gallery.write("drag", scene.build(input));
  input.state.drag.reset();
  input.view.size = 3.0;
  input.view.target = {0.55, 0.35, -0.75};
  gallery.write("near", scene.build(input));
  input.view.type = ProjectionType::Perspective;
  input.view.size = 8.0;
  gallery.write("inside", scene.build(input));
  input.view = {};
  input.theme = theme(ThemeKind::kLight);
  gallery.write("light", scene.build(input));
  input.theme = theme(ThemeKind::kHighContrast);
  gallery.write("high_contrast", scene.build(input));
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return 2;
  {
    Gallery gallery(arguments[1], {800, 600}, 1.0f);
    writeFlights(gallery);
    writeStates(gallery);
  }
  Gallery large(std::filesystem::path(arguments[1]) / "scale_2", {1600, 1200}, 2.0f);
  writeStates(large);
  return 0;
}
