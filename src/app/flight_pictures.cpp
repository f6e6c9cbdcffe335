// SPDX-License-Identifier: MIT
// The viewport's and the camera's picture inside the window.
#include "app/flight_pictures.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "scene/in_view.hpp"

namespace vides {
namespace {

constexpr int kRimOpacity = 200;  // of 255

using Scenes = std::vector<PlacedScene>;

PixelRectangle pixels(const Rect& rect) {
  return {static_cast<double>(rect.x), static_cast<double>(rect.y),
          static_cast<double>(std::max(1.0f, rect.width)),
          static_cast<double>(std::max(1.0f, rect.height))};
}

CameraInput cameraInput(const Session& session, const Scenes& scenes, const Rect& rect,
                        const Theme& theme, float scale) {
  CameraInput input;
  input.camera = session.camera();
  input.picture = session.flight().picture;
  input.lens = session.flight().lens;
  input.space = session.flight().space;
  if (session.display().shown.scene) input.scenes = scenes;
  input.rectangle = pixels(rect);
  input.contentScale = static_cast<double>(scale);
  input.lines = session.display().sizes.lines;
  input.thirds = session.display().thirds;
  input.safeFrames = session.display().safeFrames;
  input.theme = theme;
  return input;
}

ViewportInput viewportInput(const Ui& ui, const Session& session, const Scenes& scenes,
                            const Rect& rect, const Theme& theme) {
  ViewportInput input;
  input.evaluation = session.evaluation();
  input.scenes = scenes;
  input.view = session.view().view;
  input.rectangle = pixels(rect);
  input.contentScale = static_cast<double>(ui.scale());
  input.text.aim = ui.words("view/aim");
  input.text.aimWidth = static_cast<double>(ui.textWidth(input.text.aim));
  input.text.upWidth = static_cast<double>(ui.textWidth(input.text.up));
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

void addTexts(const Ui& ui, ImDrawList& list, const DrawList& picture) {
  for (const DrawText& text : picture.texts) {
    const ImFont* font = ui.font(text.strong ? Weight::kSemibold : Weight::kRegular);
    const Colour& c = text.colour;
    const ImVec2 at(std::round(static_cast<float>(text.pixel.x)),
                    std::round(static_cast<float>(text.pixel.y)));
    if (text.haloed) {
      const Colour ground = mix(picture.groundTop, picture.groundBottom, 0.5);
      const ImU32 rim = IM_COL32(ground.red, ground.green, ground.blue, kRimOpacity);
      const float wide = std::max(1.0f, std::round(1.5f * ui.scale()));
      for (const ImVec2& way : {ImVec2(-1, -1), ImVec2(1, -1), ImVec2(-1, 1), ImVec2(1, 1),
                                ImVec2(0, -1), ImVec2(0, 1), ImVec2(-1, 0), ImVec2(1, 0)}) {
        list.AddText(font, font->FontSize, {at.x + wide * way.x, at.y + wide * way.y}, rim,
                     text.text.c_str());
      }
    }
    list.AddText(font, font->FontSize, at, IM_COL32(c.red, c.green, c.blue, c.alpha),
                 text.text.c_str());
  }
}

// In the middle of a picture that has room for it.
void addNote(const Ui& ui, ImDrawList& list, const Rect& rect, const std::string& words) {
  const float width = ui.textWidth(words);
  if (width + ui.px(8) > rect.width) return;
  const ImFont* font = ui.font(Weight::kRegular);
  list.AddText(
      font, font->FontSize,
      {std::round(rect.centreX() - width / 2), std::round(rect.centreY() - font->FontSize / 2)},
      ui.colour(ColourRole::kTextSecondary), words.c_str());
}

}  // namespace

tl::expected<std::unique_ptr<FlightPictures>, std::string> FlightPictures::create(const Gl& gl) {
  auto renderer = SceneRenderer::create(gl);
  if (!renderer) return Failure(renderer.error());
  return std::unique_ptr<FlightPictures>(new FlightPictures(std::move(*renderer)));
}

void FlightPictures::begin() {
  flightRect_ = filmRect_ = {};
  flightList_ = filmList_ = nullptr;
}

std::optional<HandleId> FlightPictures::handleUnder(const Vec2& pixel, std::size_t currentKey,
                                                    double contentScale) const {
  if (flightList_ == nullptr) return std::nullopt;
  return handleAt(*flightList_, pixel, currentKey, contentScale);
}

std::optional<CurveHit> FlightPictures::curveUnder(const Vec2& pixel, double reach) const {
  if (flightList_ == nullptr) return std::nullopt;
  return flightScene_.nearestOnCurve(pixel, reach);
}

void FlightPictures::add(bool film, const Ui& ui, ImDrawList& list, const Rect& rect,
                         const Session& session, const Scenes& scenes, const ViewportState& state) {
  if (rect.empty()) return;
  const Theme& theme = ui.theme();
  const DrawList* picture = nullptr;
  bool nothing = false;
  if (film) {
    filmRect_ = rect;
    picture = filmList_ = &filmScene_.build(cameraInput(session, scenes, rect, theme, ui.scale()));
    nothing = !anythingInView(*filmList_);
  } else {
    flightRect_ = rect;
    ViewportInput input = viewportInput(ui, session, scenes, rect, theme);
    input.state = state;
    picture = flightList_ = &flightScene_.build(input);
  }
  list.PushClipRect({rect.x, rect.y}, {rect.right(), rect.bottom()}, true);
  list.AddCallback(film ? &draw<&FlightPictures::filmList_> : &draw<&FlightPictures::flightList_>,
                   this);
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
  addTexts(ui, list, *picture);
  // A black picture may also be a fault: it is none.
  if (nothing) addNote(ui, list, rect, ui.words("camera/nothing"));
  list.PopClipRect();
}

void FlightPictures::viewport(const Ui& ui, ImDrawList& list, const Rect& rect,
                              const Session& session, const Scenes& scenes,
                              const ViewportState& state) {
  add(session.view().swapped, ui, list, rect, session, scenes, state);
}

void FlightPictures::camera(const Ui& ui, ImDrawList& list, const Rect& rect,
                            const Session& session, const Scenes& scenes,
                            const ViewportState& state) {
  add(!session.view().swapped, ui, list, rect, session, scenes, state);
}

void FlightPictures::prepare(int width, int height) {
  width_ = width;
  height_ = height;
}

// A column that is scrolled shows only part of the picture.
template <const DrawList* FlightPictures::*kPicture>
void FlightPictures::draw(const ImDrawList*, const ImDrawCmd* command) {
  auto& self = *static_cast<FlightPictures*>(command->UserCallbackData);
  if (self.*kPicture == nullptr) return;
  const ImVec4& clip = command->ClipRect;
  const PixelRectangle seen{clip.x, clip.y, std::max(0.0f, clip.z - clip.x),
                            std::max(0.0f, clip.w - clip.y)};
  self.renderer_.draw(*(self.*kPicture), self.width_, self.height_, seen);
}

}  // namespace vides
