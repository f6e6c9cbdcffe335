// SPDX-License-Identifier: MIT
// Every window and menu in both languages, in ordinary and extreme states: texts fit, widgets stand
// apart and on the screen, and each tells what it does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "app/drive/player.hpp"
#include "edit/command_table.hpp"
#include "edit/shortcuts.hpp"
#include "edit/texts.hpp"
#include "flight/utf8.hpp"
#include "host/open_host.hpp"
#include "io/vid_writer.hpp"
#include "panels/fonts.hpp"
#include "panels/menu_bar.hpp"
#include "panels/windows.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

// As long as a name may look, as far as numbers go, more keys than anybody counts.
Flight extremeFlight() {
  Flight flight = newFlight();
  flight.name = std::string(200, 'W');
  flight.lens = {36.0, 0.001, 99999.0};
  std::vector<KeyPointer> keys;
  for (int i = 0; i < 10000; ++i) {
    Key key;
    const double at = i / 5000.0 - 1.0;
    key.position = {-1.0, -at, at};
    key.shape = {KeyShape::kOwn, {-1.0, -1.0, -1.0}, {}};
    Orientation orientation;
    orientation.aim = {-999999.125, -1.0, 0.001};
    orientation.roll = -36000.0;
    orientation.zoom = 100.0;
    orientation.hold = i == 0 ? 3600.0 : 0.0;
    orientation.duration = i == 1 ? std::optional(3599.99) : std::nullopt;
    key.orientations.assign(i == 0 ? 10 : 1, orientation);
    keys.emplace_back(std::move(key));
  }
  flight.keys = KeyList(std::move(keys));
  return flight;
}

struct Case {
  const char* language;
  double scale;
  bool extreme;
  // A screen of 960 x 600 whatever the scale.
  bool tight = false;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.language << " at scale " << c.scale << (c.extreme ? ", extreme" : "")
       << (c.tight ? ", tight" : "");
}

class Interface : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    OffscreenOptions options;
    const double size = GetParam().tight ? 1.0 : GetParam().scale;
    options.size = {static_cast<int>(960 * size), static_cast<int>(600 * size)};
    options.contentScale = GetParam().scale;
    auto host = openOffscreen(OffscreenKind::kOsmesa, options);
    ASSERT_TRUE(host) << host.error();
    host_ = std::move(*host);
    auto player = Player::create(*host_);
    ASSERT_TRUE(player) << player.error();
    player_ = std::move(*player);
    player_->perform(Command("language", GetParam().language));
    std::string file = std::string(VIDES_SOURCE_DIR) + "/assets/flights/pyramid.vid";
    if (GetParam().extreme) {
      file = (folder_ / (std::string(200, 'M') + ".vid")).string();
      ASSERT_EQ(saveVid(extremeFlight(), file), std::nullopt);
    }
    ASSERT_TRUE(player_->perform(Command("open", file)));
    if (GetParam().extreme) {
      // What they look like takes time and is tried elsewhere.
      for (const char* element : {"keys", "numbers", "curve", "ghosts"}) {
        player_->perform(Command("show-element", element, "off"));
      }
    }
    ASSERT_TRUE(player_->perform(Command("make-current", 0, GetParam().extreme ? 9 : 0)));
  }

  // Shows everything there is, one after the other, and calls `check` with its name.
  void forEachState(const std::function<void(const std::string&)>& check) {
    settle();
    check("nothing open");
    for (const std::string& window : windowNames()) {
      if (!hasWindow(window)) continue;
      player_->perform(Command("show-window", window));
      settle();
      check(window);
      const auto shown = widgets().widgets();
      for (const auto& [id, widget] : shown) {
        if (!id.starts_with(window + "/page_")) continue;
        ASSERT_TRUE(player_->clickWidget(id));
        settle();
        check(id);
      }
      player_->perform(Command("close-window", window));
    }
    for (const Menu& menu : menus()) {
      ASSERT_TRUE(player_->clickWidget(menu.id));
      settle();
      check(menu.id);
      ASSERT_TRUE(player_->clickWidget(menu.id));  // it closes
    }
    // The questions.
    Session& session = player_->editor().session();
    player_->perform(Command("set-name", "other"));
    player_->perform(Command("new"));
    settle();
    EXPECT_TRUE(session.question());
    check("question: unsaved");
    player_->perform(Command("answer", "cancel"));
    session.offerRecovery(newFlight(), std::string(200, 'M') + ".vid", "2026-11-22 08:15");
    settle();
    check("question: recover");
    player_->perform(Command("answer", "later"));
  }

  static std::vector<std::string> windowNames() {
    return findCommand("show-window")->arguments.front().choices;
  }
  const WidgetRegistry& widgets() const { return player_->editor().widgets(); }
  void settle() {
    player_->frame();
    player_->frame();
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> player_;
};

bool isOperated(const Widget& widget) {
  switch (widget.kind) {
    case WidgetKind::kButton:
    case WidgetKind::kToggle:
    case WidgetKind::kSlider:
    case WidgetKind::kField:
    case WidgetKind::kEntry:
    case WidgetKind::kChoice:
      return true;
    default:
      return false;
  }
}

std::string areaOf(const std::string& id) { return id.substr(0, id.find('/')); }

void expectTextsFit(const WidgetRegistry& widgets, const std::string& state) {
  EXPECT_GT(widgets.texts().size(), 20u) << state;
  for (const DrawnText& text : widgets.texts()) {
    EXPECT_LE(text.width, text.box + 0.5f) << '"' << text.text << "\", " << state;
  }
}

// What is operated lies on the screen, if that is given, and on nothing else of its kind and area;
// `below` are those that a window may stand over.
void expectApart(const WidgetRegistry& widgets, const std::optional<Rect>& screen,
                 const std::string& state, const std::set<std::string>& below = {}) {
  std::vector<const Widget*> operated;
  for (const auto& [id, widget] : widgets.widgets()) {
    const bool counts = !screen || !widget.visible.empty();
    if (isOperated(widget) && counts) operated.push_back(&widget);
  }
  for (const Widget* a : operated) {
    if (screen) {
      EXPECT_EQ(a->rect.intersect(*screen).width, a->rect.width) << a->id << ", " << state;
    }
    for (const Widget* b : operated) {
      if (a->id >= b->id || areaOf(a->id) != areaOf(b->id)) continue;
      if (below.contains(a->id) != below.contains(b->id)) continue;
      // A choice holds its entries.
      if (a->kind == WidgetKind::kChoice && b->id.starts_with(a->id + "_")) continue;
      // What a small window scrolls goes on under its buttons.
      const Rect& one = screen ? a->rect : a->visible;
      const Rect& other = screen ? b->rect : b->visible;
      EXPECT_TRUE(one.inset(0.5f).intersect(other.inset(0.5f)).empty())
          << a->id << " and " << b->id << ", " << state;
    }
  }
}

// A label that says by itself what a click does: words, not abbreviations and signs. Choices with
// such a name (a theme, an element that is shown) need no more either.
bool saysItAll(const Widget& widget) {
  std::size_t letters = 0;
  for (std::string_view rest = widget.label; !rest.empty();) {
    const std::size_t length = std::max<std::size_t>(1, utf8Length(rest));
    const char c = rest.front();
    const bool letter = length > 1 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter && rest.substr(0, length) != "…") ++letters;
    if (c == '+' || c == '#' || (c >= '0' && c <= '9') || rest.starts_with("−") ||
        rest.starts_with("«") || rest.starts_with("»")) {
      return false;
    }
    rest.remove_prefix(length);
  }
  return letters >= 4;
}

// Numbers and names of formats to choose from, where a label says of what; OK, as everywhere.
bool isPlain(const Widget& widget) {
  if (widget.label == "OK" || widget.label == "VUP") return true;
  for (const char* family :
       {"position/insert_", "settings/scale_", "shape/preset_", "frames/format_"}) {
    if (widget.id.starts_with(family)) return true;
  }
  return false;
}

// Where windows over the editor stand: those with a ground of their own, but for menus.
std::vector<Rect> windowPlaces(const Editor& editor) {
  std::vector<Rect> places;
  for (const ImGuiWindow* window : editor.context()->Windows) {
    const std::string_view name = window->Name;
    constexpr ImGuiWindowFlags kOther =
        ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip;
    if (!window->Active || (window->Flags & kOther) != 0 || !name.starts_with("###")) continue;
    if (name == "###window" || name == "###signs" || name.ends_with("/shade")) continue;
    places.push_back({window->Pos.x, window->Pos.y, window->Size.x, window->Size.y});
  }
  return places;
}

// Windows keep off the edges and the menu bar.
void expectMargins(const Editor& editor, float width, float height, float margin,
                   const std::string& state) {
  const float top = editor.widgets().find("menu/file")->rect.bottom();
  for (const Rect& place : windowPlaces(editor)) {
    EXPECT_GE(place.x, margin) << state;
    EXPECT_GE(place.y, top + margin) << state;
    EXPECT_LE(place.right(), width - margin) << state;
    EXPECT_LE(place.bottom(), height - margin) << state;
  }
}

// The buttons that end a window's business are seen without scrolling.
void expectButtonsInSight(const WidgetRegistry& widgets, const std::string& state) {
  for (const auto& [id, widget] : widgets.widgets()) {
    const std::string_view name = std::string_view(id).substr(id.find('/') + 1);
    const bool ends = name == "ok" || name == "cancel" || name == "close" || name == "save" ||
                      name == "write" || name == "insert_cancel" || id.starts_with("question/");
    if (!ends || widget.kind != WidgetKind::kButton) continue;
    EXPECT_NEAR(widget.visible.width, widget.rect.width, 0.01f) << id << ", " << state;
    EXPECT_NEAR(widget.visible.height, widget.rect.height, 0.01f) << id << ", " << state;
  }
}

using Reachable = Interface;
TEST_P(Reachable, OnASmallScreen) {
  std::set<std::string> below;  // what the windows stand over
  forEachState([&](const std::string& state) {
    expectTextsFit(widgets(), state);
    expectApart(widgets(), std::nullopt, state, below);
    expectMargins(player_->editor(), 960.0f, 600.0f, 8.0f, state);
    expectButtonsInSight(widgets(), state);
    const Rect screen{0.0f, 0.0f, 960.0f, 600.0f};
    std::vector<std::string> ids;
    for (const auto& [id, widget] : widgets().widgets()) {
      const bool operated = isOperated(widget) || widget.kind == WidgetKind::kMenu ||
                            widget.kind == WidgetKind::kMenuItem;
      if (operated && !below.contains(id)) ids.push_back(id);
    }
    if (below.empty()) below.insert(ids.begin(), ids.end());
    EXPECT_FALSE(ids.empty()) << state;
    for (const std::string& id : ids) {
      const auto found = player_->bringIntoSight(id);
      ASSERT_TRUE(found) << found.error() << ", " << state;
      const Rect& seen = found->visible;
      EXPECT_EQ(seen.intersect(screen), seen) << id << ", " << state;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, Reachable,
                         testing::Values(Case{"en", 1.5, false, true}, Case{"de", 1.5, false, true},
                                         Case{"en", 2, false, true}, Case{"de", 2, false, true}),
                         [](const auto& each) {
                           return std::string(each.param.language) +
                                  std::to_string(static_cast<int>(each.param.scale * 10));
                         });

// What a small viewport shows is worth more than three sliders over it; a larger one has them.
TEST(InterfaceSliders, AreThereWhereThereIsRoom) {
  const auto shown = [](double scale, const char* hidden) {
    OffscreenOptions options;
    options.size = {960, 600};
    options.contentScale = scale;
    auto host = openOffscreen(OffscreenKind::kOsmesa, options).value();
    auto player = Player::create(*host).value();
    Layout layout;
    if (std::string_view(hidden) == "timeline") layout.timelineShown = false;
    player->editor().setLayout(layout);
    player->frame();
    player->frame();
    int count = 0;
    for (const char* id : {"view/size", "view/turn", "view/tilt"}) {
      const Widget* slider = player->editor().widgets().find(id);
      if (slider != nullptr) ++count;
    }
    return count;
  };
  EXPECT_EQ(shown(1.0, ""), 3);
  EXPECT_EQ(shown(1.5, ""), 3);
  EXPECT_EQ(shown(2.0, ""), 0);
  EXPECT_EQ(shown(2.0, "timeline"), 3);
}

TEST_P(Interface, FitsStandsApartAndTellsWhatItDoes) {
  const auto scale = static_cast<float>(GetParam().scale);
  std::set<std::string> bare;
  forEachState([&](const std::string& state) {
    expectTextsFit(widgets(), state);
    expectApart(widgets(), Rect{0.0f, 0.0f, 960.0f * scale, 600.0f * scale}, state);
    expectMargins(player_->editor(), 960.0f * scale, 600.0f * scale, 8.0f * scale, state);
    expectButtonsInSight(widgets(), state);
    for (const auto& [id, widget] : widgets().widgets()) {
      if (!isOperated(widget) || !widget.tip.empty()) continue;
      if (!saysItAll(widget) && !isPlain(widget)) bare.insert(id);
    }
  });
  EXPECT_THAT(bare, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, Interface,
                         testing::Values(Case{"en", 1, false}, Case{"de", 1, false},
                                         Case{"en", 2, false}, Case{"de", 2, false},
                                         Case{"en", 1, true}, Case{"de", 1, true}),
                         [](const auto& each) {
                           return std::string(each.param.language) +
                                  std::to_string(static_cast<int>(each.param.scale)) +
                                  (each.param.extreme ? "extreme" : "");
                         });

// --- The tables ---

// What a command is called in a menu, it is called elsewhere.
TEST(InterfaceTexts, OneThingHasOneName) {
  for (const Language language : {Language::kEnglish, Language::kGerman}) {
    const Texts texts(language);
    for (const Menu& menu : menus()) {
      for (const MenuEntry& entry : menu.entries) {
        const auto command = parseCommand(entry.command);
        if (!command || command->name == "show-window") continue;
        // "language en" and such are settings: a menu names their value.
        const Text title = titleOf(*command, texts);
        if (title.key == "command." + command->name && !command->arguments.empty()) continue;
        EXPECT_EQ(texts.words(title.key), texts.words(entry.id)) << entry.id;
      }
    }
  }
}

// Where there is no next key its row is empty, and nothing else moves.
TEST(PositionPanel, TheRowOfTheNextKeyIsEmptyAtTheLastOfAnOpenFlight) {
  OffscreenOptions options;
  options.size = {1280, 800};
  auto host = openOffscreen(OffscreenKind::kOsmesa, options);
  ASSERT_TRUE(host);
  auto player = Player::create(**host);
  ASSERT_TRUE(player);
  const auto find = [&](const char* id) {
    (*player)->frame();
    return (*player)->editor().widgets().find(id);
  };
  EXPECT_NE(find("position/next_bias"), nullptr);
  const float y = find("position/change")->rect.y;
  (*player)->perform(Command("select-key", 1));
  EXPECT_EQ(find("position/next_bias"), nullptr);
  EXPECT_EQ(find("position/change")->rect.y, y);
  (*player)->perform(Command("set-closed", "on"));
  EXPECT_NE(find("position/next_bias"), nullptr);
}

TEST(InterfaceTexts, TooltipsTellTheKeys) {
  OffscreenOptions options;
  options.size = {1280, 800};
  auto host = openOffscreen(OffscreenKind::kOsmesa, options);
  ASSERT_TRUE(host);
  auto player = Player::create(**host);
  ASSERT_TRUE(player);
  (*player)->frame();
  const auto tip = [&](const char* id) { return (*player)->editor().widgets().find(id)->tip; };
  EXPECT_THAT(tip("position/insert"), testing::Not(testing::EndsWith(")")));
  EXPECT_THAT(tip("timeline/insert"), testing::EndsWith("(I)"));
  EXPECT_THAT(tip("position/insert_many"), testing::EndsWith("(Shift+I)"));
  EXPECT_THAT(tip("orientation/next"), testing::EndsWith("(Ctrl+Page Down)"));
  EXPECT_THAT(tip("timeline/play"), testing::EndsWith("(Space)"));
  EXPECT_THAT(tip("camera/use_view"), testing::EndsWith("(U)"));
  EXPECT_THAT(tip("speed/rate"), testing::Not(testing::EndsWith(")")));
  // A greyed one tells why it is.
  EXPECT_EQ(tip("speed/rate"), "The duration already follows the rate");
  (*player)->perform(Command("set-duration", 3.0));
  (*player)->frame();
  EXPECT_NE(tip("speed/rate"), "The duration already follows the rate");
  (*player)->perform(Command("language", "de"));
  (*player)->frame();
  EXPECT_THAT(tip("orientation/next"), testing::EndsWith("(Strg+Bild ab)"));
}

TEST(InterfaceTexts, EveryCharacterHasAGlyph) {
  const FontSet set = buildFonts(1.0);
  const Fonts& fonts = set.fonts;
  if (fonts.plain) GTEST_SKIP() << "Inter is not there";
  std::set<std::string> missing;
  for (const Language language : {Language::kEnglish, Language::kGerman}) {
    for (const auto& [key, words] : builtInTexts(language)) {
      const char* at = words.data();
      const char* const end = at + words.size();
      while (at < end) {
        unsigned int c = 0;
        const int length = ImTextCharFromUtf8(&c, at, end);
        for (ImFont* font : {fonts.regular, fonts.semibold, fonts.small}) {
          if (font->FindGlyphNoFallback(static_cast<ImWchar>(c)) == nullptr) {
            missing.insert(key + ": " + std::string(at, static_cast<std::size_t>(length)));
          }
        }
        at += length;
      }
    }
  }
  EXPECT_THAT(missing, testing::IsEmpty());
}

// What the sources name, wholly or as the beginning or end of a name that is put together.
class Sources {
 public:
  Sources() {
    const auto top = std::filesystem::path(VIDES_SOURCE_DIR) / "src";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") {
        text_ += test::readAll(entry.path());
      }
    }
  }
  bool names(const std::string& key) const {
    if (has('"' + key + '"')) return true;
    for (std::size_t i = 1; i < key.size(); ++i) {
      if (std::string_view("./_-").find(key[i]) == std::string_view::npos) continue;
      const std::string before = key.substr(0, i), after = key.substr(i + 1);
      if (has('"' + key.substr(0, i + 1) + '"') || has('"' + key.substr(i) + '"')) return true;
      if (has('"' + before + '"') && has('"' + after + '"')) return true;
    }
    return false;
  }

 private:
  bool has(const std::string& literal) const { return text_.find(literal) != text_.npos; }
  std::string text_;
};

TEST(InterfaceTexts, NoneIsLeftOver) {
  const Sources sources;
  std::set<std::string> unused;
  for (const auto& [key, words] : builtInTexts(Language::kEnglish)) {
    std::string name = key.substr(0, key.find('#'));
    if (name.starts_with("command.")) {
      const std::string command = name.substr(8, name.find('.', 8) - 8);
      if (findCommand(command) == nullptr) unused.insert(key);
      continue;
    }
    if (name.starts_with("tip/")) name = name.substr(4);
    if (name.starts_with("step.") && findCommand(name.substr(5)) != nullptr) continue;
    if (!sources.names(name)) unused.insert(key);
  }
  EXPECT_THAT(unused, testing::IsEmpty());
}

}  // namespace
}  // namespace vides
