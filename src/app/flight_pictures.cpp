// SPDX-License-Identifier: MIT
// The viewport's and the camera's picture inside the window.
#include "app/flight_pictures.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "render/imgui_renderer.hpp"
#include "scene/obj_reader.hpp"

namespace vides {
namespace {

PixelRectangle pixels(const Rect& rect) {
  return {static_cast<double>(rect.x), static_cast<double>(rect.y),
          static_cast<double>(std::max(1.0f, rect.width)),
          static_cast<double>(std::max(1.0f, rect.height))};
}

CameraInput cameraInput(const Session& session, const SharedScene& scene, const Rect& rect,
                        const Theme& theme, float scale) {
  CameraInput input;
  input.camera = session.camera();
  input.picture = session.flight().picture;
  input.lens = session.flight().lens;
  input.space = session.flight().space;
  input.scene = session.display().shown.scene ? scene : nullptr;
  input.rectangle = pixels(rect);
  input.contentScale = static_cast<double>(scale);
  input.lines = session.display().sizes.lines;
  input.thirds = session.display().thirds;
  input.safeFrames = session.display().safeFrames;
  input.theme = theme;
  return input;
}

ViewportInput viewportInput(const Ui& ui, const Session& session, const SharedScene& scene,
                            const Rect& rect, const Theme& theme) {
  ViewportInput input;
  input.evaluation = session.evaluation();
  input.scene = scene;
  input.view = session.view().view;
  input.rectangle = pixels(rect);
  input.contentScale = static_cast<double>(ui.scale());
  input.text.aim = ui.words("view/aim");
  input.text.digitWidth = static_cast<double>(ui.textWidth("0"));
  input.text.letterWidth = static_cast<double>(ui.textWidth("n"));
  input.text.lineHeight = static_cast<double>(ui.font(Weight::kRegular)->FontSize);
  input.shown = session.display().shown;
  // Who shapes the curve sees what the numbers do.
  input.shown.tangents = input.shown.tangents || session.windowOpen("shape");
  input.sizes = session.display().sizes;
  input.gridStep = session.display().gridStep;
  input.theme = theme;
  return input;
}

}  // namespace

SharedScene SceneCache::of(const Flight& flight, const std::string& flightPath,
                           const std::function<void(const std::string&)>& refused) {
  if (files_ == flight.scene && path_ == flightPath) return scene_;
  files_ = flight.scene;
  path_ = flightPath;
  scene_ = nullptr;
  SceneGeometry all;
  const auto folder = std::filesystem::path(flightPath).parent_path();
  for (const SceneFile& file : files_) {
    const ReadScene read = readSceneFile(sceneFilePath(folder, file.file));
    if (read) {
      appendScene(all, *read);
    } else {
      refused(problemLine(file.file, read.error()));
    }
  }
  if (all.empty()) return scene_;
  finishScene(all);
  scene_ = std::make_shared<const SceneGeometry>(std::move(all));
  return scene_;
}

tl::expected<std::unique_ptr<FlightPictures>, std::string> FlightPictures::create(const Gl& gl) {
  auto renderer = SceneRenderer::create(gl);
  if (!renderer) return Failure(renderer.error());
  return std::unique_ptr<FlightPictures>(new FlightPictures(gl, std::move(*renderer)));
}

void FlightPictures::begin() {
  flightRect_ = filmRect_ = {};
  flightList_ = viewportList_ = columnList_ = nullptr;
}

std::optional<HandleId> FlightPictures::handleUnder(const Vec2& pixel, std::size_t currentKey,
                                                    double contentScale) const {
  if (flightList_ == nullptr) return std::nullopt;
  return handleAt(*flightList_, pixel - flightCorner_, currentKey, contentScale);
}

std::optional<CurveHit> FlightPictures::curveUnder(const Vec2& pixel, double reach) const {
  if (flightList_ == nullptr) return std::nullopt;
  return flightScene_.nearestOnCurve(pixel - flightCorner_, reach);
}

const DrawList& FlightPictures::make(bool film, const Ui& ui, const Rect& rect, const Vec2& corner,
                                     const Session& session, const SharedScene& scene,
                                     const ViewportState& state) {
  const Theme& theme = ui.theme();
  const Rect inWindow{rect.x + static_cast<float>(corner.x), rect.y + static_cast<float>(corner.y),
                      rect.width, rect.height};
  (film ? filmRect_ : flightRect_) = inWindow;
  if (film) return filmScene_.build(cameraInput(session, scene, rect, theme, ui.scale()));
  flightCorner_ = corner;
  ViewportInput input = viewportInput(ui, session, scene, rect, theme);
  input.state = state;
  flightList_ = &flightScene_.build(input);
  return *flightList_;
}

void FlightPictures::texts(const Ui& ui, ImDrawList& list, const DrawList& picture,
                           const Rect& clip, const Vec2& offset) const {
  list.PushClipRect({clip.x, clip.y}, {clip.right(), clip.bottom()}, true);
  for (const DrawText& text : picture.texts) {
    const ImFont* font = ui.font(text.strong ? Weight::kSemibold : Weight::kRegular);
    const Colour& c = text.colour;
    const Vec2 at = text.pixel + offset;
    list.AddText(font, font->FontSize,
                 {std::round(static_cast<float>(at.x)), std::round(static_cast<float>(at.y))},
                 IM_COL32(c.red, c.green, c.blue, c.alpha), text.text.c_str());
  }
  list.PopClipRect();
}

void FlightPictures::viewport(const Ui& ui, ImDrawList& list, const Rect& rect,
                              const Session& session, const SharedScene& scene,
                              const ViewportState& state) {
  if (rect.empty()) return;
  viewportList_ = &make(session.view().swapped, ui, rect, Vec2(0.0), session, scene, state);
  list.AddCallback(&drawViewport, this);
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
  texts(ui, list, *viewportList_, rect, Vec2(0.0));
}

void FlightPictures::camera(const Ui& ui, ImDrawList& list, const Rect& rect,
                            const Session& session, const SharedScene& scene,
                            const ViewportState& state) {
  if (rect.empty()) return;
  const Rect inside{0.0f, 0.0f, rect.width, rect.height};
  const int width = static_cast<int>(rect.width);
  const int height = static_cast<int>(rect.height);
  if (!column_ || column_.width() != width || column_.height() != height) {
    auto made = Framebuffer::create(*gl_, width, height, 0);
    if (!made) return;  // no memory for it: the column stays empty
    column_ = std::move(*made);
  }
  const Vec2 corner(rect.x, rect.y);
  columnList_ = &make(!session.view().swapped, ui, inside, corner, session, scene, state);
  // OpenGL's pictures begin at the bottom.
  list.AddImage(imguiTexture(column_.texture().id()), {rect.x, rect.y},
                {rect.right(), rect.bottom()}, {0.0f, 1.0f}, {1.0f, 0.0f});
  texts(ui, list, *columnList_, rect, corner);
}

void FlightPictures::prepare(GLuint target, int width, int height) {
  width_ = width;
  height_ = height;
  if (columnList_ == nullptr) return;
  column_.bind();
  renderer_.draw(*columnList_, column_.width(), column_.height());
  column_.resolve();
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target);
  gl_->Viewport(0, 0, width, height);
}

void FlightPictures::drawViewport(const ImDrawList*, const ImDrawCmd* command) {
  auto& self = *static_cast<FlightPictures*>(command->UserCallbackData);
  if (self.viewportList_) self.renderer_.draw(*self.viewportList_, self.width_, self.height_);
}

}  // namespace vides
