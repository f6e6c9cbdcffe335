// SPDX-License-Identifier: MIT
// Frame, time, legend.
#include "panels/timeline_readout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "edit/time_text.hpp"
#include "panels/quantities.hpp"

namespace vides {
namespace {

constexpr float kInset = 6.0f;  // of a number in its field

// What the row gives up, one after the other, until all fits.
enum GivenUp {
  kNothing,
  kUnitsName,  // "units/s" for "cube units/s"
  kFrameRate,
  kFrameWord,  // its short form
  kValues,
  kNoFrameWord,
  kTime,
  kFrameCount,
  kLegend
};

// A text, right-aligned in the room that it keeps at least; or a field in its place.
struct Piece {
  enum class Field { kNone, kFrame, kTime };
  std::string words;
  ColourRole colour = ColourRole::kTextSecondary;
  Weight weight = Weight::kRegular;
  float room = 0.0f;
  Field field = Field::kNone;
};

float widthOf(const Ui& ui, const Piece& piece) {
  return std::max(piece.room, ui.textWidth(piece.words, piece.weight));
}

float widthOf(const Ui& ui, const std::vector<Piece>& pieces) {
  float all = 0.0f;
  for (const Piece& piece : pieces) all += widthOf(ui, piece);
  return all;
}

void draw(Ui& ui, const Rect& row, float x, const std::vector<Piece>& pieces,
          const std::function<void(const Piece&, const Rect&)>& field = {}) {
  for (const Piece& piece : pieces) {
    const Rect box{x, row.y, widthOf(ui, piece), row.height};
    if (piece.field != Piece::Field::kNone) {
      // Fields stand on whole pixels, so that their edges are sharp.
      field(piece, {std::round(x), row.y, std::floor(box.width), row.height});
    } else {
      ui.text(box, piece.words,
              {.colour = piece.colour, .weight = piece.weight, .align = Align::kRight});
    }
    x = box.right();
  }
}

void frameField(Ui& ui, const Rect& box, const Session& session, Actions& actions) {
  const auto typed = ui.field("timeline/frame", box, static_cast<double>(session.frame()),
                              {.decimals = 0, .weight = Weight::kSemibold});
  actions.typed(
      typed, [](double frame) { return Command("go-to-frame", std::max(0.0, std::round(frame))); });
}

void timeField(Ui& ui, const Rect& box, const std::string& words, const Session& session,
               Actions& actions) {
  const auto typed = ui.textField("timeline/time", box, words);
  if (!typed) return;
  if (const auto seconds = parseTime(*typed)) {
    const double frame = std::round(*seconds * session.flight().frameRate);
    actions.run(Command("go-to-frame", std::min(frame, 9e15)));
  } else {
    actions.refusal = Text("refusal.no-time", {*typed});
  }
}

std::vector<Piece> frameAndTime(const Ui& ui, const Session& session, int givenUp) {
  const double fps = session.flight().frameRate;
  const std::int64_t frames = session.evaluation().frameCount();
  const std::string last = grouped(ui, frames - 1);
  const float inset = 2.0f * ui.px(kInset);
  std::string word;
  if (givenUp < kFrameWord) word = ui.words("frame_title") + " ";
  if (givenUp == kFrameWord) word = ui.words("frame_title#short") + " ";
  std::vector<Piece> pieces;
  pieces.push_back({.words = word});
  pieces.push_back({.words = {},
                    .room = ui.textWidth(last, Weight::kSemibold) + inset,
                    .field = Piece::Field::kFrame});
  if (givenUp < kFrameCount)
    pieces.push_back({fmt::format(" {} {}", ui.words("of"), frameNumbers(ui, 0, frames - 1))});
  const std::string point = "  \u00b7  ";
  if (givenUp < kTime) {
    const double span = static_cast<double>(frames) / fps;
    const double time = static_cast<double>(session.frame()) / fps;
    pieces.push_back({"  "});
    const std::string now = paddedTime(ui, time, span, 2);
    pieces.push_back(
        {.words = now, .room = ui.textWidth(now) + inset, .field = Piece::Field::kTime});
  }
  if (givenUp < kFrameRate) {
    pieces.push_back({point + frameRateText(ui, fps)});
  }
  return pieces;
}

// A curve of the strip: a line in its colour before its name and its value.
struct Curve {
  const char* id;
  ColourRole role;
  double value, most;
  int decimals;
  std::string unit;
};

std::vector<Piece> piecesOf(const Ui& ui, const Curve& curve, int givenUp) {
  const auto small = [](std::string words, ColourRole colour, float room = 0.0f) {
    return Piece{std::move(words), colour, Weight::kSmall, room};
  };
  std::vector<Piece> pieces = {small(ui.words(curve.id), ColourRole::kTextSecondary)};
  if (givenUp >= kValues) return pieces;
  const std::string most = grouped(ui, curve.most, curve.decimals);
  pieces.push_back(small(grouped(ui, curve.value, curve.decimals), ColourRole::kText,
                         ui.textWidth(most, Weight::kSmall)));
  pieces[1].room = widthOf(ui, pieces[1]) + ui.px(5);
  pieces.push_back(small(withUnit("", curve.unit), ColourRole::kTextSecondary));
  return pieces;
}

std::vector<Curve> curves(const Ui& ui, const Session& session, const FlightGraphs& graphs,
                          int givenUp) {
  const LengthUnit unit = lengthUnit(ui, session);
  const FlightGraphs::Rates now = graphs.ratesAt(session.frame()), most = graphs.most();
  const std::string& name = givenUp < kUnitsName ? unit.whole : unit.brief;
  const double top = most.speed * unit.perCube;
  return {{"timeline/speed", ColourRole::kCurve, now.speed * unit.perCube, top, decimalsFor(top),
           name + "/s"},
          {"timeline/turn_rate", ColourRole::kAim, now.turn, most.turn, 1, "\u00b0/s"}};
}

// The width that the legend takes; draws it so that it ends at the row's right end.
struct Legend {
  static constexpr float kLine = 16.0f, kGap = 6.0f, kApart = 20.0f;
  std::vector<Curve> shown;
  int givenUp;

  float width(const Ui& ui) const {
    float all = 0.0f;
    for (const Curve& curve : shown) {
      all += (all > 0.0f ? ui.px(kApart) : 0.0f) + ui.px(kLine + kGap) +
             widthOf(ui, piecesOf(ui, curve, givenUp));
    }
    return all;
  }
  void draw(Ui& ui, const Rect& row) const {
    float x = row.right() - width(ui);
    const float y = std::round(row.centreY());
    for (const Curve& curve : shown) {
      const std::vector<Piece> pieces = piecesOf(ui, curve, givenUp);
      const float words = x + ui.px(kLine + kGap);
      ImGui::GetWindowDrawList()->AddLine({x, y}, {x + ui.px(kLine), y}, ui.colour(curve.role),
                                          2.0f * ui.scale());
      vides::draw(ui, row, words, pieces);
      std::string told;
      for (std::size_t i = 1; i < pieces.size(); ++i) told += pieces[i].words;
      const float past = words + widthOf(ui, pieces);
      ui.shows(curve.id, {x, row.y, past - x, row.height}, told);
      x = past + ui.px(kApart);
    }
  }
};

}  // namespace

void timelineReadout(Ui& ui, const Rect& row, const Session& session, const FlightGraphs& graphs,
                     Actions& actions) {
  const auto field = [&](const Piece& piece, const Rect& box) {
    if (piece.field == Piece::Field::kFrame) return frameField(ui, box, session, actions);
    timeField(ui, box, piece.words, session, actions);
  };
  for (int givenUp = kNothing; givenUp <= kLegend; ++givenUp) {
    const std::vector<Piece> left = frameAndTime(ui, session, givenUp);
    Legend legend{{}, givenUp};
    if (givenUp < kLegend) legend.shown = curves(ui, session, graphs, givenUp);
    const float right = legend.width(ui);
    const float gap = legend.shown.empty() ? 0.0f : ui.px(16);
    if (givenUp < kLegend && widthOf(ui, left) + gap + right > row.width) continue;
    draw(ui, row, row.x, left, field);
    legend.draw(ui, row);
    return;
  }
}

}  // namespace vides
