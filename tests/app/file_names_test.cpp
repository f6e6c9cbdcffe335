// SPDX-License-Identifier: MIT
// Names in the chooser: told apart, with another font's letters where one has them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "app/drive/player.hpp"
#include "host/open_host.hpp"
#include "panels/installed_font.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

class FileNames : public testing::Test {
 protected:
  void SetUp() override {
    auto host = openOffscreen(OffscreenKind::kOsmesa, {});
    ASSERT_TRUE(host) << host.error();
    host_ = std::move(*host);
    auto player = Player::create(*host_);
    ASSERT_TRUE(player) << player.error();
    player_ = std::move(*player);
  }
  // What the chooser's list has of a folder with these files.
  std::vector<std::string> shown(const std::vector<std::string>& names) {
    for (const std::string& name : names) test::writeAll(folder_.path() / name, "{}");
    EXPECT_TRUE(player_->perform(Command("save-as", (folder_ / "z.vid").string())));
    EXPECT_TRUE(player_->perform(Command("open")));
    for (int i = 0; i < 5; ++i) player_->frame();
    std::vector<std::string> texts;
    for (const auto& text : player_->editor().widgets().texts()) texts.push_back(text.text);
    return texts;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> player_;
};

TEST_F(FileNames, EachIsToldFromEveryOther) {
  const auto texts =
      shown({"a\\x1B.vid", "a\x1B.vid", "pl\xE4ne.vid", "pl\u00E4ne.vid", "two\nlines.vid",
             "\U0001F600.vid", "a .vid", "a\u00A0.vid", "x##y.vid"});
  for (const char* wanted :
       {"a\\\\x1B.vid", "a\\x1B.vid", "pl\\xE4ne.vid", "pl\u00E4ne.vid", "two\\x0Alines.vid",
        "\\u{1f600}.vid", "a .vid", "a\\u{a0}.vid", "x##y.vid"}) {
    EXPECT_THAT(texts, testing::Contains(wanted));
  }
}

TEST_F(FileNames, LettersComeFromAnotherFontWhereOneHasThem) {
  constexpr char32_t kUmbrella = 0x2602;
  const bool installed = !installedFontsFor({kUmbrella}).empty();
  const auto texts = shown({"\u2602.vid"});
  EXPECT_THAT(texts, testing::Contains(installed ? "\u2602.vid" : "\\u{2602}.vid"));
}

}  // namespace
}  // namespace vides
