// SPDX-License-Identifier: MIT
// Runs scripts of `vides drive`: views, places on screen, values of the flight, files, pictures.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/drive/runner.hpp"
#include "edit/command.hpp"
#include "io/vid_writer.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {
namespace {

using Json = nlohmann::json;

std::string shownPlace(const Vec2& at) { return fmt::format("{:.6f} {:.6f}", at.x, at.y); }

tl::expected<Json, std::string> valueAt(const std::string& text, const std::string& pointer) {
  const Json document = Json::parse(text);
  try {
    const Json::json_pointer place(pointer);
    if (!document.contains(place)) {
      return Failure(fmt::format("expected a value at {}, found none", pointer));
    }
    return document.at(place);
  } catch (const Json::exception&) {
    return Failure(fmt::format("expected a JSON pointer, found '{}'", pointer));
  }
}

}  // namespace

ScriptRunner::Result ScriptRunner::must(const vides::Command& command, std::string_view what) {
  if (player_.perform(command)) return {};
  return Failure(fmt::format("expected {}, found: {}", what,
                             player_.editor().words(player_.editor().session().output().text)));
}

tl::expected<Vec2, std::string> ScriptRunner::placeInWidget(Words words) const {
  const std::string& id = words[1].text;
  const Widget* widget = player_.editor().widgets().find(id);
  if (widget == nullptr) {
    return Failure(fmt::format("expected a widget {} on screen, found none", id));
  }
  Vec2 share(0.5);
  if (words.size() == 3) return Failure("expected widget ID or widget ID U V");
  if (words.size() == 4) {
    const auto given = numbers(words.subspan(2));
    if (!given) return Failure(given.error());
    share = {(*given)[0], (*given)[1]};
  }
  const Rect& rect = widget->rect;
  return Vec2(static_cast<double>(rect.x) + share.x * static_cast<double>(rect.width),
              static_cast<double>(rect.y) + share.y * static_cast<double>(rect.height));
}

tl::expected<Vec2, std::string> ScriptRunner::place(Words words) const {
  if (words[0].text == "widget") return placeInWidget(words);
  const Session& session = player_.editor().session();
  const Rect rect = player_.editor().viewport();
  // A small one may be scrolled out of sight.
  const Widget* const area = player_.editor().widgets().find("view/picture");
  const Rect seen = area == nullptr ? rect : area->visible;
  const PixelRectangle pixels{static_cast<double>(rect.x), static_cast<double>(rect.y),
                              static_cast<double>(rect.width), static_cast<double>(rect.height)};
  if (rect.empty()) return Failure("expected a viewport, found none on screen");
  const ViewProjection view = viewProjection(session.view().view, pixels);
  const std::string& what = words[0].text;
  const bool curve = what == "curve";
  if (!curve && what != "key" && what != "aim" && what != "up") {
    return Failure(fmt::format("expected key, aim, up, curve or widget, found '{}'", what));
  }
  if (words.size() != (what == "key" ? 2u : 3u)) {
    return Failure("expected key I, aim I J, up I J or curve I U");
  }
  const auto first = index(words[1]);
  if (!first) return Failure(first.error());
  std::optional<Vec2> at;
  if (curve) {
    const auto fraction = scriptNumber(words[2].text, points_);
    if (!fraction) return Failure(fraction.error());
    if (*fraction < 0.0 || *fraction > 1.0) {
      return Failure(fmt::format("expected a fraction from 0 to 1, found {}", *fraction));
    }
    const auto sections = session.evaluation().sectionCount();
    if (static_cast<std::int64_t>(*first) >= sections) {
      return Failure(fmt::format("expected a section below {}, found {}", sections, *first));
    }
    const Section section = session.evaluation().section(static_cast<std::int64_t>(*first));
    const Vec3 point = section.kind == SectionKind::kMove
                           ? session.evaluation().piecePoint(section.from.key, *fraction)
                           : session.flight().keys[section.from.key].position;
    at = view.project(point);
  } else {
    const KeyList& keys = session.flight().keys;
    if (*first >= keys.size()) {
      return Failure(fmt::format("expected a key below {}, found {}", keys.size(), *first));
    }
    const Key& key = keys[*first];
    std::size_t orientation = 0;
    if (words.size() > 2) {
      const auto second = index(words[2]);
      if (!second) return Failure(second.error());
      orientation = *second;
      if (orientation >= key.orientations.size()) {
        return Failure(fmt::format("expected an orientation below {}, found {}",
                                   key.orientations.size(), orientation));
      }
    }
    const OrientationPlace chosen{*first, orientation};
    if (what == "key") at = view.project(key.position);
    if (what == "aim") at = view.project(aimPoint(key, key.orientations[orientation]));
    if (what == "up") {
      at = view.project(
          upTip(view, session.evaluation().cameraAt(chosen), player_.editor().contentScale()));
    }
  }
  const bool inside = at && seen.contains(static_cast<float>(at->x), static_cast<float>(at->y));
  if (inside) return *at;
  return Failure(fmt::format("expected {} {} inside the viewport, found it at {}", what, *first,
                             at ? shownPlace(*at) : "no place, behind the viewer"));
}

ScriptRunner::Result ScriptRunner::where(Words words, const ScriptLine&) {
  const auto at = place(words);
  if (!at) return Failure(at.error());
  print_(shownPlace(*at));
  return {};
}

ScriptRunner::Result ScriptRunner::point(Words words, const ScriptLine&) {
  const std::string& name = words[0].text;
  if (name.size() < 2 || name[0] != '$' || name.find('.') != std::string::npos) {
    return Failure(fmt::format("expected $NAME, found '{}'", name));
  }
  if (words[1].text != "where") {
    return Failure(fmt::format("expected where, found '{}'", words[1].text));
  }
  const auto at = place(words.subspan(2));
  if (!at) return Failure(at.error());
  points_[name.substr(1)] = *at;
  return {};
}

ScriptRunner::Result ScriptRunner::view(Words words, const ScriptLine&) {
  if (words.size() == 1) {
    const auto command = parseCommand("view " + words[0].text);
    if (!command) return Failure(player_.editor().words(command.error()));
    return must(*command, "the view");
  }
  const auto values = numbers(words);
  if (!values) return Failure(values.error());
  if (values->size() != 3) return Failure("expected view VIEW or view TURN TILT SIZE");
  return must(vides::Command("set-view", (*values)[0], (*values)[1], (*values)[2]), "the view");
}

ScriptRunner::Result ScriptRunner::perspective(Words words, const ScriptLine&) {
  const std::string& state = words[0].text;
  if (state != "on" && state != "off") {
    return Failure(fmt::format("expected on or off, found '{}'", state));
  }
  return must(vides::Command("perspective", state), "the projection");
}

ScriptRunner::Result ScriptRunner::frameAt(Words words, const ScriptLine&) {
  const auto number = index(words[0]);
  if (!number) return Failure(number.error());
  return must(vides::Command("go-to-frame", *number), "the playhead there");
}

ScriptRunner::Result ScriptRunner::print(Words words, const ScriptLine&) {
  const auto value = valueAt(writeVid(player_.editor().session().flight()), words[0].text);
  if (!value) return Failure(value.error());
  print_(value->is_string() ? value->get<std::string>() : value->dump());
  return {};
}

ScriptRunner::Result ScriptRunner::expect(Words words, const ScriptLine&) {
  return expectIn(writeVid(player_.editor().session().flight()), words);
}

ScriptRunner::Result ScriptRunner::expectSetup(Words words, const ScriptLine&) {
  return expectIn(writeSetup(player_.editor().session().setup()), words);
}

ScriptRunner::Result ScriptRunner::expectIn(const std::string& document, Words words) const {
  const std::string& pointer = words[0].text;
  const auto value = valueAt(document, pointer);
  if (!value) return Failure(value.error());
  double tolerance = 0.0;
  if (words.size() > 2) {
    const auto given = scriptNumber(words[2].text, points_);
    if (!given || *given < 0.0) {
      return Failure(fmt::format("expected a tolerance from 0, found '{}'", words[2].text));
    }
    tolerance = *given;
  }
  bool same = false;
  if (value->is_number() && !words[1].quoted) {
    const auto wanted = scriptNumber(words[1].text, points_);
    if (!wanted) return Failure(wanted.error());
    same = std::abs(value->get<double>() - *wanted) <= tolerance;
  } else if (value->is_string()) {
    same = value->get<std::string>() == words[1].text;
  } else {
    same = *value == Json::parse(words[1].text, nullptr, false);
  }
  if (same) return {};
  return Failure(fmt::format("expected {} = {}{}, found {}", pointer, words[1].text,
                             tolerance > 0.0 ? fmt::format(" within {}", tolerance) : "",
                             value->dump()));
}

ScriptRunner::Result ScriptRunner::expectOutput(Words words, const ScriptLine&) {
  Editor& editor = player_.editor();
  const std::string said = editor.words(editor.session().output().text);
  if (said.find(words[0].text) != std::string::npos) return {};
  return Failure(
      fmt::format("expected the output line to contain \"{}\", found \"{}\"", words[0].text, said));
}

ScriptRunner::Result ScriptRunner::expectWidget(Words words, const ScriptLine&) {
  const Widget* widget = player_.editor().widgets().find(words[0].text);
  if (widget == nullptr) {
    return Failure(fmt::format("expected a widget {} on screen, found none", words[0].text));
  }
  const std::string shown = widget->enabled ? widget->value : "greyed";
  if (shown == words[1].text) return {};
  return Failure(
      fmt::format("expected {} to show \"{}\", found \"{}\"", widget->id, words[1].text, shown));
}

ScriptRunner::Result ScriptRunner::expectTitle(Words words, const ScriptLine&) {
  if (player_.title().find(words[0].text) != std::string::npos) return {};
  return Failure(fmt::format("expected the title to contain \"{}\", found \"{}\"", words[0].text,
                             player_.title()));
}

ScriptRunner::Result ScriptRunner::save(Words words, const ScriptLine&) {
  return must(vides::Command("save-as", words[0].text), "to save " + words[0].text);
}

ScriptRunner::Result ScriptRunner::open(Words words, const ScriptLine&) {
  return must(vides::Command("open", words[0].text), "to open " + words[0].text);
}

ScriptRunner::Result ScriptRunner::undo(Words, const ScriptLine&) {
  return must(vides::Command("undo"), "a step to undo");
}

ScriptRunner::Result ScriptRunner::redo(Words, const ScriptLine&) {
  return must(vides::Command("redo"), "a step to redo");
}

ScriptRunner::Result ScriptRunner::screenshot(Words words, const ScriptLine&) {
  const auto picture = player_.picture();
  if (!picture) return Failure(picture.error());
  return writePng(*picture, words[0].text);
}

}  // namespace vides
