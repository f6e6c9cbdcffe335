// SPDX-License-Identifier: MIT
// An exception in the middle of a display frame loses nothing: the work is kept, the user is told,
// the editor goes on; where it comes again and again the loop ends.
#include "app/window_loop.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "host/open_host.hpp"
#include "io/vid_reader.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

class WindowLoopTest : public testing::Test {
 protected:
  void SetUp() override {
    auto host = openOffscreen(OffscreenKind::kOsmesa, {});
    ASSERT_TRUE(host) << host.error();
    host_ = std::move(*host);
    EditorOptions options;
    options.makeCurrent = [this] { host_->makeCurrent(); };
    options.ran = [this](const Command& command) {
      if (failures_ == 0) return;
      --failures_;
      throw std::runtime_error(command.name + " met something");
    };
    auto editor = Editor::create(host_->gl(), std::move(options));
    ASSERT_TRUE(editor) << editor.error();
    editor_ = std::move(*editor);
    userFiles_.emplace(writer_, folder_ / "config", folder_ / "state");
    recovery_.emplace(writer_, folder_ / "recovery");
    loop_.emplace(*host_, *editor_, *userFiles_, *recovery_);
    step();
    step();
  }

  WindowLoop::State step() {
    host_->advanceTime(0.1);
    host_->push(Exposed{});
    return loop_->step();
  }
  WindowLoop::State key(KeyboardKey which) {
    host_->push(KeyChanged{which, true, false, {}});
    const WindowLoop::State state = step();
    host_->push(KeyChanged{which, false, false, {}});
    return state;
  }
  std::size_t keys() const { return editor_->session().flight().keys.size(); }
  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_ / "recovery", none)) {
      if (entry.path().extension() == ".vid") files.push_back(entry.path());
    }
    return files;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Editor> editor_;
  int failures_ = 0;
  BackgroundWriter writer_;
  std::optional<UserFiles> userFiles_;
  std::optional<RecoveryKeeper> recovery_;
  std::optional<WindowLoop> loop_;
};

TEST_F(WindowLoopTest, AnExceptionKeepsTheWorkTellsAndGoesOn) {
  failures_ = 1;
  testing::internal::CaptureStderr();
  EXPECT_EQ(key(KeyboardKey::kE), WindowLoop::State::kGoesOn);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "vides: something went wrong: append-key met something; what was unsaved is kept\n");
  const Session& session = editor_->session();
  EXPECT_EQ(session.output().text, Text("output.went-wrong", {"append-key met something"}));
  ASSERT_EQ(kept().size(), 1u);
  EXPECT_EQ(readVidFile(kept().front().string())->keys, session.flight().keys);
  // The next display frames are as always, and so is the next edit.
  const std::size_t before = keys();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(step(), WindowLoop::State::kGoesOn);
  EXPECT_EQ(key(KeyboardKey::kE), WindowLoop::State::kGoesOn);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(step(), WindowLoop::State::kGoesOn);
  EXPECT_EQ(keys(), before + 1);
  EXPECT_EQ(host_->picture()->height, 800);
}

TEST_F(WindowLoopTest, AnExceptionAgainAndAgainEndsItAndTheWorkIsKept) {
  EXPECT_EQ(key(KeyboardKey::kE), WindowLoop::State::kGoesOn);
  EXPECT_EQ(step(), WindowLoop::State::kGoesOn);
  failures_ = 100;
  testing::internal::CaptureStderr();
  WindowLoop::State state = WindowLoop::State::kGoesOn;
  int steps = 0;
  for (; state == WindowLoop::State::kGoesOn && steps < 20; ++steps) {
    host_->advanceTime(0.1);
    host_->push(KeyChanged{KeyboardKey::kE, true, false, {}});
    state = loop_->step();
  }
  EXPECT_EQ(state, WindowLoop::State::kGivenUp);
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_NE(told.find("offered at the next start"), std::string::npos) << told;
  ASSERT_EQ(kept().size(), 1u);
  EXPECT_EQ(readVidFile(kept().front().string())->keys, editor_->session().flight().keys);
}

TEST_F(WindowLoopTest, QuittingEndsIt) {
  host_->push(CloseRequested{});
  EXPECT_EQ(step(), WindowLoop::State::kQuit);
}

}  // namespace
}  // namespace vides
