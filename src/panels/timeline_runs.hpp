// SPDX-License-Identifier: MIT
// What the timeline draws from left to right, however many there are: what touches and looks the
// same becomes one shape.
#pragma once

#include <limits>
#include <optional>

#include "evaluate/section.hpp"
#include "panels/ui.hpp"

namespace vides {

// Bars of sections; narrow ones of a kind, which touch each other, as one.
class BarRuns {
 public:
  explicit BarRuns(Ui& ui) : ui_(ui) {}
  void add(const Rect& bar, SectionKind kind, bool narrow, bool hovered);
  // Draws what is left; call it after the last one.
  void end();

 private:
  Ui& ui_;
  std::optional<Rect> run_;
  SectionKind kind_ = SectionKind::kMove;
};

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
