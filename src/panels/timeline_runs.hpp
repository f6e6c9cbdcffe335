// SPDX-License-Identifier: MIT
// What the timeline draws from left to right, however many there are: what touches and looks the
// same becomes one shape.
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "evaluate/section.hpp"
#include "panels/ui.hpp"

namespace vides {

// Bars of sections; narrow ones of a kind, which grow together, as one.
class BarRuns {
 public:
  explicit BarRuns(Ui& ui) : ui_(ui) {}
  // `apart`: how much of the gap between it and the one before is seen, from 0 (they touch) to 1.
  void add(const Rect& bar, SectionKind kind, float apart, bool hovered);
  // Draws what is left; call it after the last one.
  void end();

 private:
  Ui& ui_;
  std::optional<Rect> run_;
  std::vector<std::pair<float, float>> joints_;  // of the run: x, apart
  SectionKind kind_ = SectionKind::kMove;
};

// What a section does, as a sign in the middle of its bar; nothing where the bar is too narrow.
void kindGlyph(Ui& ui, const Rect& bar, SectionKind kind);

// Marks of keys and orientations, smaller where they would touch; equal ones that lie one over the
// other, as one long one.
class MarkRuns {
 public:
  // `y` is their middle.
  MarkRuns(Ui& ui, float y) : ui_(ui), y_(y) {}
  void add(float x, bool isKey, bool ringed, ColourRole role);
  // Draws what is left; call it after the last one.
  void end();

 private:
  struct Run {
    float from, to;
    bool isKey, ringed;
    ColourRole role;
    float gap;  // to the mark before, pixels
  };
  void draw(const Run& run, float gapBehind);
  Ui& ui_;
  float y_;
  std::optional<Run> run_;
};

}  // namespace vides
