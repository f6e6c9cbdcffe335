// SPDX-License-Identifier: MIT
// The rows of Output → Frames… and the progress of the writing.
#include "panels/frames_window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "edit/frame_job.hpp"
#include "panels/form.hpp"
#include "panels/left_panels.hpp"

namespace vides {
namespace {

void format(Form& form, const FrameOptions& options, Actions& actions) {
  Ui& ui = form.ui();
  std::vector<std::string_view> names;
  for (const FrameFormat* format : frameFormats()) names.push_back(format->name);
  const std::string_view now = options.format->name;
  if (const auto chosen = choice(ui, "frames/format", form.row("frames/format"), names, now)) {
    actions.run(Command("frames-format", *chosen));
  }
  form.note(ui.words("frames/about_" + std::string(now)));
}

void range(Form& form, const Session& session, Actions& actions) {
  Ui& ui = form.ui();
  const FrameOptions& options = session.frameOutput().options;
  const std::int64_t frames = session.evaluation().frameCount();
  const auto boxes = split(ui, form.row("frames/range"), 3);
  const bool all = takesAll(options, frames);
  if (ui.button("frames/all", boxes[0], {.on = all, .toggle = true}) && !all) {
    actions.run(Command("frames-range"));
  }
  const std::int64_t last = std::min(options.last, frames) - 1;
  actions.typed(
      ui.field("frames/first", boxes[1], static_cast<double>(options.first),
               {.decimals = 0, .prefix = ui.words("frames/from"), .weight = Weight::kSemibold}),
      [&](double value) { return Command("frames-range", value, last + 1); });
  actions.typed(
      ui.field("frames/last", boxes[2], static_cast<double>(last),
               {.decimals = 0, .prefix = ui.words("frames/to"), .weight = Weight::kSemibold}),
      [&](double value) { return Command("frames-range", options.first, value + 1.0); });
}

void numbering(Form& form, const FrameOptions& options, Actions& actions) {
  Ui& ui = form.ui();
  const auto boxes = split(ui, form.row("frames/first_number"), 3);
  std::string numbered;
  for (const FrameFormat* format : frameFormats()) {
    if (format->numbered) numbered.append(numbered.empty() ? "" : ", ").append(format->name);
  }
  actions.typed(
      ui.field("frames/first_number", boxes[0], static_cast<double>(options.firstNumber),
               {.decimals = 0, .enabled = options.format->numbered, .weight = Weight::kSemibold}),
      [](double value) { return Command("frames-first-number", value); });
  ui.text({boxes[1].x + ui.px(4), boxes[1].y, boxes[2].right() - boxes[1].x - ui.px(4),
           boxes[1].height},
          ui.tell(Text("frames.only_numbered", {numbered})),
          {.colour = ColourRole::kTextSecondary});
}

void place(Form& form, const Session& session, Actions& actions) {
  Ui& ui = form.ui();
  constexpr std::array<std::string_view, 2> kSpaces = {"cube", "world"};
  const bool world = spaceOf(session.frameOutput().options) == FrameSpace::kWorld;
  if (const auto chosen =
          choice(ui, "frames/space", form.row("frames/space"), kSpaces, kSpaces[world ? 1 : 0])) {
    actions.run(Command("frames-space", *chosen));
  }
  const Rect row = form.row("frames/file");
  const float button = ui.px(92);
  const Rect field{row.x, row.y, row.width - button - ui.px(4), row.height};
  if (const auto file = ui.textField("frames/file", field, session.framesFile(), true)) {
    actions.run(Command("frames-file", *file));
  }
  commandButton(ui, "frames/choose", {row.right() - button, row.y, button, row.height},
                "show-window chooser-frames", session, actions);
}

// "777 frames · 31.08 s · 25 fps".
std::string amount(const Ui& ui, const Session& session) {
  const std::int64_t frames =
      frameCountOf(session.frameOutput().options, session.evaluation().frameCount());
  const double rate = session.flight().frameRate;
  return ui.tell(Text("frames.amount", {frames})) + " \u00b7 " +
         ui.number(static_cast<double>(frames) / rate, 2) + " s \u00b7 " +
         ui.number(rate, neededDecimals(rate)) + " " + ui.words("frames_per_second");
}

void progress(Ui& ui, const Rect& box, const FrameJob& job) {
  const float thick = ui.px(6);
  const Rect track{box.x, std::round(box.centreY() - thick / 2), box.width - ui.px(60), thick};
  const std::string words = progressBar(ui, track, job.share());
  ui.text({track.right(), box.y, ui.px(60), box.height}, words, {.align = Align::kRight});
  ui.shows("frames/progress", box, words);
}

void buttons(Ui& ui, const Rect& row, const Session& session, Actions& actions) {
  const std::vector<Rect> places = lastButtons(ui, row, 2);
  const Rect& cancel = places[0];
  const Rect& ok = places[1];
  const Rect rest{row.x, row.y, cancel.x - row.x - ui.px(12), row.height};
  const FrameJob* const job = session.frameJob();
  if (job != nullptr) progress(ui, rest, *job);
  if (ui.button("frames/cancel", cancel, ButtonStyle{})) {
    actions.run(job != nullptr ? Command("cancel-frames") : Command("close-window", "frames"));
  }
  commandButton(ui, "frames/write", ok, "write-frames", session, actions);
}

}  // namespace

void framesWindow(Ui& ui, const Session& session, WindowPlace& windowPlace, Actions& actions) {
  const FloatingFrame frame{"frames", 520.0f, 300.0f, ui.words("frames/heading"), {}, {}, 480.0f};
  const bool open = floatingFrame(
      ui, frame, windowPlace,
      [&](const Rect& room) {
        const FrameOptions& options = session.frameOutput().options;
        Form form(ui, room, 128.0f);
        format(form, options, actions);
        range(form, session, actions);
        numbering(form, options, actions);
        place(form, session, actions);
        form.note(amount(ui, session));
      },
      [&](const Rect& row) { buttons(ui, row, session, actions); });
  if (!open) actions.run(Command("close-window", "frames"));
}

}  // namespace vides
