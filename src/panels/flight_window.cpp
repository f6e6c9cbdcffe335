// SPDX-License-Identifier: MIT
// The fields of File → Flight…, each with its command.
#include "panels/flight_window.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "panels/form.hpp"

namespace vides {
namespace {

struct Number {
  const char* id;
  double value;
  std::string prefix;
  std::string suffix;
};

// A number whose decimals are those that it needs and that fit.
Ui::Typed numberField(Ui& ui, const Rect& box, const Number& number) {
  FieldStyle style{.decimals = neededDecimals(number.value),
                   .prefix = number.prefix,
                   .suffix = number.suffix,
                   .weight = Weight::kSemibold};
  const auto width = [&] {
    return ui.textWidth(ui.number(number.value, style.decimals) + style.suffix, style.weight) +
           ui.textWidth(style.prefix) + ui.px(10);
  };
  while (style.decimals > 0 && width() > box.width) --style.decimals;
  return ui.field(number.id, box, number.value, style);
}

void nameAndTime(Form& form, const Flight& flight, Actions& actions) {
  Ui& ui = form.ui();
  if (const auto name = ui.textField("flight/name", form.row("flight/name"), flight.name)) {
    actions.run(Command("set-name", *name));
  }
  const Rect row = split(ui, form.row("flight/frame_rate"), 2)[0];
  actions.typed(
      numberField(ui, row,
                  {"flight/frame_rate", flight.frameRate, "", " " + ui.words("frames_per_second")}),
      [](double value) { return Command("set-frame-rate", value); });
}

void picture(Form& form, const Flight& flight, Actions& actions) {
  Ui& ui = form.ui();
  const auto boxes = split(ui, form.row("flight/picture"), 2);
  const PictureFormat& format = flight.picture;
  actions.typed(numberField(ui, boxes[0],
                            {"flight/picture_width", static_cast<double>(format.width),
                             ui.words("flight/width"), " px"}),
                [&](double value) { return Command("set-picture", value, format.height); });
  actions.typed(numberField(ui, boxes[1],
                            {"flight/picture_height", static_cast<double>(format.height),
                             ui.words("flight/height"), " px"}),
                [&](double value) { return Command("set-picture", format.width, value); });
}

void lens(Form& form, const Flight& flight, Actions& actions) {
  Ui& ui = form.ui();
  const Lens& now = flight.lens;
  const auto change = [&](const Rect& box, const Number& number, double Lens::*part) {
    actions.typed(numberField(ui, box, number), [&](double value) {
      Lens lens = now;
      lens.*part = value;
      return Command("set-lens", lens.sensorWidth, lens.focalLengthAtZoom1,
                     lens.focalLengthAtZoom100);
    });
  };
  const Rect sensor = split(ui, form.row("flight/sensor_width"), 2)[0];
  change(sensor, {"flight/sensor_width", now.sensorWidth, "", " mm"}, &Lens::sensorWidth);
  const auto boxes = split(ui, form.row("flight/focal"), 2);
  change(boxes[0],
         {"flight/focal_1", now.focalLengthAtZoom1, ui.words("flight/zoom") + " 1", " mm"},
         &Lens::focalLengthAtZoom1);
  change(boxes[1],
         {"flight/focal_100", now.focalLengthAtZoom100, ui.words("flight/zoom") + " 100", " mm"},
         &Lens::focalLengthAtZoom100);
}

void rates(Form& form, const Flight& flight, Actions& actions) {
  Ui& ui = form.ui();
  const Rates& now = flight.rates;
  const struct {
    const char* id;
    const char* kind;
    double Rates::*part;
  } all[] = {{"flight/rate_move", "kind/move", &Rates::move},
             {"flight/rate_pan", "kind/pan", &Rates::pan},
             {"flight/rate_roll", "kind/roll", &Rates::roll},
             {"flight/rate_zoom", "kind/zoom", &Rates::zoom}};
  std::vector<Rect> boxes = split(ui, form.row("flight/rates"), 2);
  for (const Rect& box : split(ui, form.row("flight/rates_unit"), 2)) boxes.push_back(box);
  for (std::size_t i = 0; i < std::size(all); ++i) {
    const auto typed = numberField(
        ui, boxes[i],
        {all[i].id, now.*all[i].part, ui.words(all[i].kind), " " + ui.words("frames_short")});
    actions.typed(typed, [&](double value) {
      Rates rates = now;
      rates.*all[i].part = value;
      return Command("set-rates", rates.move, rates.pan, rates.roll, rates.zoom);
    });
  }
}

void course(Form& form, const Flight& flight, Actions& actions) {
  Ui& ui = form.ui();
  constexpr std::array<std::string_view, 2> kSwitch = {"off", "on"};
  if (const auto chosen = choice(ui, "flight/closed", form.row("flight/course"), kSwitch,
                                 kSwitch[flight.closed ? 1 : 0])) {
    actions.run(Command("set-closed", *chosen));
  }
  std::vector<std::string_view> names;
  for (const OrientationMethod* method : orientationMethods()) names.push_back(method->name);
  if (const auto chosen = choice(ui, "flight/orientation_curve", form.row("flight/between"), names,
                                 flight.orientationCurve->name)) {
    actions.run(Command("set-orientation-curve", *chosen));
  }
}

void space(Form& form, const Session& session, Actions& actions) {
  Ui& ui = form.ui();
  const Space& now = session.flight().space;
  const auto boxes = split(ui, form.row("flight/center"), 3);
  constexpr const char* kIds[] = {"flight/center_x", "flight/center_y", "flight/center_z"};
  constexpr const char* kAxes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto typed = numberField(ui, boxes[static_cast<std::size_t>(axis)],
                                   {kIds[axis], now.center[axis], kAxes[axis], ""});
    actions.typed(typed, [&](double value) {
      Vec3 center = now.center;
      center[axis] = value;
      return Command("set-space", center, now.halfSize);
    });
  }
  const Rect half = split(ui, form.row("flight/half_size"), 2)[0];
  actions.typed(numberField(ui, half, {"flight/half_size", now.halfSize, "", ""}),
                [&](double value) { return Command("set-space", now.center, value); });
  constexpr std::array<std::string_view, 2> kUnits = {"cube", "scene"};
  const bool scene = session.display().units == Units::kScene;
  if (const auto chosen =
          choice(ui, "flight/units", form.row("flight/units"), kUnits, kUnits[scene ? 1 : 0])) {
    actions.run(Command("units", *chosen));
  }
}

}  // namespace

void flightWindow(Ui& ui, const Session& session, WindowPlace& place, Actions& actions) {
  const FloatingFrame frame{"flight", 460.0f, 416.0f, ui.words("flight/heading")};
  const bool open = floatingFrame(ui, frame, place, [&](const Rect& room) {
    const Flight& flight = session.flight();
    Form form(ui, room, 136.0f);
    nameAndTime(form, flight, actions);
    picture(form, flight, actions);
    form.gap(8);
    lens(form, flight, actions);
    form.gap(8);
    rates(form, flight, actions);
    form.gap(8);
    course(form, flight, actions);
    form.gap(8);
    space(form, session, actions);
  });
  if (!open) actions.run(Command("close-window", "flight"));
}

}  // namespace vides
