// SPDX-License-Identifier: MIT
// Several editors in a thread, each with its host: every one draws into its own context and leaves
// Dear ImGui's as it found it.
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/drive/player.hpp"
#include "host/open_host.hpp"
#include "render/picture.hpp"

namespace vides {
namespace {

struct Stage {
  std::unique_ptr<OffscreenHost> host;
  std::unique_ptr<Player> player;

  Picture picture(int frames = 3) {
    for (int i = 0; i < frames; ++i) player->frame();
    return player->picture().value();
  }
};

Stage open(OffscreenKind kind) {
  OffscreenOptions options;
  options.size = {960, 600};
  Stage stage;
  auto host = openOffscreen(kind, options);
  EXPECT_TRUE(host) << host.error();
  stage.host = std::move(*host);
  auto player = Player::create(*stage.host);
  EXPECT_TRUE(player) << player.error();
  stage.player = std::move(*player);
  return stage;
}

// The first goes on drawing its own picture while others open, draw and end.
void checkBeside(OffscreenKind kind, OffscreenKind otherKind) {
  Stage one = open(kind);
  const Picture alone = one.picture();
  {
    Stage other = open(otherKind);
    EXPECT_EQ(one.picture(1).rgba, alone.rgba);
    ASSERT_TRUE(other.player->perform(Command("theme", "light")));
    const Picture light = other.picture();
    EXPECT_NE(light.rgba, alone.rgba);
    EXPECT_EQ(one.picture(1).rgba, alone.rgba);
    ASSERT_TRUE(one.player->perform(Command("insert-key")));
    EXPECT_EQ(other.picture(1).rgba, light.rgba);
    ASSERT_TRUE(one.player->perform(Command("undo")));
  }
  EXPECT_TRUE(one.player->picture().has_value());
  one.picture();
  EXPECT_EQ(one.player->editor().session().flight().keys.size(), 2u);
}

TEST(TwoEditors, Osmesa) { checkBeside(OffscreenKind::kOsmesa, OffscreenKind::kOsmesa); }
TEST(TwoEditors, Egl) { checkBeside(OffscreenKind::kEgl, OffscreenKind::kEgl); }
TEST(TwoEditors, OsmesaBesideEgl) { checkBeside(OffscreenKind::kOsmesa, OffscreenKind::kEgl); }
TEST(TwoEditors, EglBesideOsmesa) { checkBeside(OffscreenKind::kEgl, OffscreenKind::kOsmesa); }

// Whoever else uses Dear ImGui in the thread finds it as it was.
TEST(TwoEditors, LeavesDearImguisContextAlone) {
  ImGuiContext* const own = ImGui::CreateContext();
  ImGui::SetCurrentContext(own);
  {
    Stage stage = open(OffscreenKind::kOsmesa);
    EXPECT_EQ(ImGui::GetCurrentContext(), own);
    stage.player->frame();
    EXPECT_EQ(ImGui::GetCurrentContext(), own);
    stage.player->perform(Command("insert-key"));
    EXPECT_EQ(ImGui::GetCurrentContext(), own);
  }
  EXPECT_EQ(ImGui::GetCurrentContext(), own);
  ImGui::DestroyContext(own);
}

}  // namespace
}  // namespace vides
