// SPDX-License-Identifier: MIT
// What the window keeps from one run to the next: the setup, the recently opened files.
#include <gmock/gmock.h>
#include <signal.h>

#include "app/window_fixture.hpp"
#include "edit/recent_files.hpp"
#include "edit/setup.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

class KeptTest : public WindowTest {
 protected:
  std::string setupFile() const { return (folder_ / "config/vides/setup.json").string(); }
  std::string recentFile() const { return (folder_ / "state/vides/recent.json").string(); }
  void begin() override {}
};

TEST_F(KeptTest, TheSetupIsThereAgain) {
  startProgram({file("window").string()});
  EXPECT_FALSE(std::filesystem::exists(setupFile()));  // as built in
  clickBoth("menu/settings");
  clickBoth("menu/settings/german");
  // Without waiting for the end.
  ASSERT_TRUE(waitUntil([&] { return readSetupFile(setupFile()).has_value(); }));
  vides::Setup wanted;
  wanted.display.language = Language::kGerman;
  EXPECT_EQ(readSetupFile(setupFile()).value(), wanted);
  xdotool("key 1");            // the view from the front is kept at the end only
  ASSERT_TRUE(fallsAsleep());  // it has glided there
  closeProgram();
  wanted.turn = wanted.tilt = 0.0;
  EXPECT_EQ(readSetupFile(setupFile()).value(), wanted);
  EXPECT_EQ(readRecentFilesFile(recentFile()), std::vector{file("window").string()});

  // As another theme shows best.
  wanted.display.theme = ThemeKind::kLight;
  ASSERT_EQ(saveSetup(wanted, setupFile()), std::nullopt);
  startProgram({});
  twin_->editor().session().setSetup(wanted);
  ASSERT_TRUE(twin_->editor().session().beginWithSample(file("twin").string()));
  expectOnScreen("window_with_setup");
  const auto written = std::filesystem::last_write_time(setupFile());
  closeProgram();
  EXPECT_EQ(std::filesystem::last_write_time(setupFile()), written);  // nothing was changed
}

TEST_F(KeptTest, ABrokenSetupIsReplacedAndKept) {
  std::filesystem::create_directories(folder_ / "config/vides");
  test::writeAll(setupFile(),
                 "{\"format\": \"vides-setup\", \"version\": 1, \"theme\": \"beige\"}");
  startProgram({file("window").string()});
  // The message stands where the flight's name was: the twin says so too.
  twin_->editor().session().say(
      MessageKind::kError,
      Text("output.setup-replaced", {setupFile(), readSetupFile(setupFile()).error().front()}));
  expectOnScreen("window_with_broken_setup");
  clickBoth("menu/settings");
  clickBoth("menu/settings/german");
  closeProgram();
  EXPECT_EQ(readSetupFile(setupFile())->display.language, Language::kGerman);
  EXPECT_THAT(test::readAll(setupFile() + ".broken"), testing::HasSubstr("beige"));
}

class RecoveryTest : public KeptTest {
 protected:
  std::vector<std::filesystem::path> kept() const {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder_ / "state/vides/recovery", none)) {
      if (entry.path().extension() == ".vid") files.push_back(entry.path());
    }
    return files;
  }
  void kill() {
    ASSERT_EQ(::kill(program_->id(), SIGKILL), 0);
    ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
    program_.reset();
  }
  // An edit in both, and how long it took until it was kept.
  double editAndWait() {
    twin_->tap(KeyboardKey::kO, {});
    xdotool("key o");
    const auto start = std::filesystem::file_time_type::clock::now();
    EXPECT_TRUE(waitUntil([&] {
      return kept().size() == 1 &&
             readVidFile(kept().front().string())->keys == twin_->editor().session().flight().keys;
    }));
    if (kept().empty()) return 1e9;
    const auto written = std::filesystem::last_write_time(kept().front());
    return std::chrono::duration<double>(written - start).count();
  }
};

TEST_F(RecoveryTest, KilledItGivesTheWorkBack) {
  startProgram({file("window").string()});
  EXPECT_THAT(kept(), testing::IsEmpty());
  const std::string before = test::readAll(file("window"));
  EXPECT_LT(editAndWait(), 5.0);
  kill();
  EXPECT_EQ(test::readAll(file("window")), before);

  // Refused for now it is offered again, taken it is there, saved it is gone.
  startProgram({});
  Session& twin = twin_->editor().session();
  const Flight work = twin.flight();
  twin.offerRecovery(work, file("window").string(), "2026-11-22 08:15");
  clickBoth("question/later");
  EXPECT_EQ(kept().size(), 1u);
  closeProgram();
  EXPECT_EQ(kept().size(), 1u);
  startProgram({});
  twin.offerRecovery(work, file("window").string(), "2026-11-22 08:15");
  clickBoth("question/recover");
  EXPECT_EQ(kept().size(), 1u);
  xdotool("key ctrl+s");
  EXPECT_TRUE(waitUntil([&] { return test::readAll(file("window")) == writeVid(work); }));
  EXPECT_TRUE(waitUntil([&] { return kept().empty(); }));
  closeProgram();

  // Discarded it is gone at once.
  startProgram({file("window").string()});
  EXPECT_LT(editAndWait(), 5.0);
  kill();
  startProgram({});
  twin.offerRecovery(work, file("window").string(), "2026-11-22 08:15");
  clickBoth("question/forget");
  EXPECT_TRUE(waitUntil([&] { return kept().empty(); }));
  closeProgram();
}

// Its X server ends: so must the program, but not what was done in it.
TEST_F(RecoveryTest, ALostDisplayLosesNothing) {
  const auto loseDisplay = [&] {
    peer_.reset();
    screen_.reset();
    ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
    EXPECT_EQ(program_->ended(), 1);
    program_.reset();
    screen_.emplace();
    peer_.emplace();
  };
  startProgram({file("window").string()});
  const std::string before = test::readAll(file("window"));
  loseDisplay();
  EXPECT_EQ(errors(), "vides: the display is gone\n");
  EXPECT_THAT(kept(), testing::IsEmpty());

  // An edit that is on the disk already, and one that isn't: the window's name tells of it at once.
  startProgram({file("window").string()});
  EXPECT_LT(editAndWait(), 5.0);
  twin_->tap(KeyboardKey::kZ, {.control = true});
  xdotool("key ctrl+z");
  EXPECT_TRUE(waitUntil([&] { return kept().empty(); }));
  twin_->tap(KeyboardKey::kE, {});
  xdotool("key e");
  ASSERT_TRUE(waitUntil([&] {
    return xdotool("getwindowname " + std::to_string(window_)).find('*') != std::string::npos;
  }));
  loseDisplay();
  EXPECT_EQ(errors(),
            "vides: the display is gone; what was unsaved is offered at the next start\n");
  ASSERT_EQ(kept().size(), 1u);
  Session& twin = twin_->editor().session();
  EXPECT_EQ(readVidFile(kept().front().string())->keys, twin.flight().keys);
  EXPECT_EQ(test::readAll(file("window")), before);

  startProgram({});
  const Flight work = twin.flight();
  twin.offerRecovery(work, file("window").string(), "2026-11-22 08:15");
  clickBoth("question/recover");
  loseDisplay();  // it is this editor's now
  EXPECT_EQ(kept().size(), 1u);
  startProgram({});
  twin.offerRecovery(work, file("window").string(), "2026-11-22 08:15");
  clickBoth("question/recover");
  xdotool("key ctrl+s");
  EXPECT_TRUE(waitUntil([&] { return test::readAll(file("window")) == writeVid(work); }));
  closeProgram();
}

// Who logs out, or presses Ctrl-C where it was started, is asked nothing.
TEST_F(RecoveryTest, ASignalLosesNothing) {
  for (const auto& [signal, name] :
       {std::pair(SIGTERM, "SIGTERM"), std::pair(SIGHUP, "SIGHUP"), std::pair(SIGINT, "SIGINT")}) {
    SCOPED_TRACE(name);
    const auto end = [&, number = signal] {
      ASSERT_EQ(::kill(program_->id(), number), 0);
      ASSERT_TRUE(waitUntil([&] { return program_->ended().has_value(); }));
      EXPECT_EQ(program_->ended(), 128 + number);  // it says what ended it
      program_.reset();
    };
    startProgram({file("window").string()});
    const std::string before = test::readAll(file("window"));
    end();
    EXPECT_EQ(errors(), std::string("vides: ended by ") + name + "\n");
    EXPECT_THAT(kept(), testing::IsEmpty());

    // An edit of this moment: it is told of by the window's name, and not yet on the disk.
    startProgram({file("window").string()});
    twin_->tap(KeyboardKey::kE, {});
    xdotool("key e");
    ASSERT_TRUE(waitUntil([&] {
      return xdotool("getwindowname " + std::to_string(window_)).find('*') != std::string::npos;
    }));
    end();
    EXPECT_EQ(errors(), std::string("vides: ended by ") + name +
                            "; what was unsaved is offered at the next start\n");
    ASSERT_EQ(kept().size(), 1u);
    Session& twin = twin_->editor().session();
    EXPECT_EQ(readVidFile(kept().front().string())->keys, twin.flight().keys);
    EXPECT_EQ(test::readAll(file("window")), before);
    std::filesystem::remove_all(folder_ / "state/vides/recovery");
    twin_->tap(KeyboardKey::kZ, {.control = true});
  }
}

// What is ignored stays so: nohup's programs outlive their terminal.
TEST_F(RecoveryTest, AnIgnoredSignalEndsNothing) {
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;
  ASSERT_EQ(sigaction(SIGHUP, &ignore, &before), 0);
  startProgram({file("window").string()});
  ASSERT_EQ(sigaction(SIGHUP, &before, nullptr), 0);
  ASSERT_EQ(::kill(program_->id(), SIGHUP), 0);
  twin_->tap(KeyboardKey::kE, {});
  xdotool("key e");  // it still works
  ASSERT_TRUE(waitUntil([&] {
    return xdotool("getwindowname " + std::to_string(window_)).find('*') != std::string::npos;
  }));
  EXPECT_FALSE(program_->ended());
  kill();
}

TEST_F(RecoveryTest, AnotherEditorLeavesIt) {
  startProgram({file("window").string()});
  EXPECT_LT(editAndWait(), 5.0);
  {
    test::RunningProcess other({VIDES_PROGRAM}, environment());
    unsigned long window = 0;
    ASSERT_TRUE(waitUntil([&] {
      const std::string id = xdotool("search --all --onlyvisible --pid " +
                                     std::to_string(other.id()) + " --class ^vides$");
      if (!id.empty()) window = std::stoul(id);
      return window != 0;
    }));
    ASSERT_TRUE(waitUntil([&] { return sleeps(other.id()) > 0; }));
    // Had it asked, it would not end before the answer.
    peer_->requestClose(window);
    ASSERT_TRUE(waitUntil([&] { return other.ended().has_value(); }));
    EXPECT_EQ(other.ended(), 0);
  }
  EXPECT_EQ(kept().size(), 1u);
  // Undone nothing is unsaved: nothing is kept.
  xdotool("key ctrl+z");
  EXPECT_TRUE(waitUntil([&] { return kept().empty(); }));
  closeProgram();
}

}  // namespace
}  // namespace vides
