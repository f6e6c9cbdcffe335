// SPDX-License-Identifier: MIT
// Output → Frames…: its settings by command, the written file, what is refused and asked.
#include "edit/frame_output.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "edit/edit_fixture.hpp"
#include "edit/frame_job.hpp"
#include "support/files.hpp"

namespace vides {
namespace {

namespace fs = std::filesystem;

std::string contents(const std::string& file) { return test::readAll(file); }

// What the writer gives for these options.
std::string written(const Session& session, const FrameOptions& options) {
  std::string text;
  writeFrames(session.evaluation(), options, [&](std::string_view piece) {
    text += piece;
    return true;
  });
  return text;
}

TEST(FrameOutput, TheFileStandsBesideTheFlight) {
  FrameOutput output;
  EXPECT_EQ(frameFile(output, "/a/b/flight.vid", "untitled"), "/a/b/flight.txt");
  output.options.format = frameFormat("chan");
  EXPECT_EQ(frameFile(output, "/a/b/flight.vid", "untitled"), "/a/b/flight.chan");
  EXPECT_EQ(frameFile(output, "", "untitled"), (fs::current_path() / "untitled.chan").string());
  output.file = "other.x";
  EXPECT_EQ(frameFile(output, "/a/b/flight.vid", "untitled"), "/a/b/other.x");
  output.file = "other";
  EXPECT_EQ(frameFile(output, "/a/b/flight.vid", "untitled"), "/a/b/other.chan");
  output.file = "/c/other.x";
  EXPECT_EQ(frameFile(output, "/a/b/flight.vid", "untitled"), "/c/other.x");
}

TEST(FrameOutput, AnotherFormatHasAnotherEnding) {
  EXPECT_EQ(withEndingOf("/a/b.csv", *frameFormat("json")), "/a/b.json");
  EXPECT_EQ(withEndingOf("b.txt", *frameFormat("chan")), "b.chan");
  EXPECT_EQ(withEndingOf("b.frames", *frameFormat("chan")), "b.frames");
  EXPECT_EQ(withEndingOf("", *frameFormat("chan")), "");
  EXPECT_EQ(withEndingOf(".csv", *frameFormat("chan")), ".csv");
}

TEST(FrameOutput, CountsWhatItTakes) {
  FrameOptions options;
  EXPECT_EQ(frameCountOf(options, 101), 101);
  EXPECT_TRUE(takesAll(options, 101));
  options.first = 10;
  options.last = 20;
  EXPECT_EQ(frameCountOf(options, 101), 10);
  EXPECT_EQ(frameCountOf(options, 15), 5);
  EXPECT_EQ(frameCountOf(options, 5), 0);
  EXPECT_FALSE(takesAll(options, 101));
}

TEST(FrameOutput, CommandsSetIt) {
  Session session;  // 101 frames
  run(session, "frames-format csv");
  run(session, "frames-file out.csv");
  run(session, "frames-range 5 20");
  run(session, "frames-first-number -3");
  EXPECT_EQ(spaceOf(session.frameOutput().options), FrameSpace::kCube);
  run(session, "frames-format chan");
  EXPECT_EQ(session.frameOutput().file, "out.chan");
  EXPECT_EQ(spaceOf(session.frameOutput().options), FrameSpace::kWorld);
  run(session, "frames-space cube");
  EXPECT_EQ(spaceOf(session.frameOutput().options), FrameSpace::kCube);
  EXPECT_EQ(session.frameOutput().options.first, 5);
  EXPECT_EQ(session.frameOutput().options.last, 20);
  EXPECT_EQ(session.frameOutput().options.firstNumber, -3);
  EXPECT_FALSE(session.execute("frames-range 20 20"));
  EXPECT_EQ(session.output().text.key, "refusal.frame-range");
  EXPECT_FALSE(session.execute("frames-range 101 200"));
  EXPECT_FALSE(session.execute("frames-first-number 1.5"));
  EXPECT_EQ(session.frameOutput().options.last, 20);
  run(session, "frames-range 5 1000");
  EXPECT_EQ(frameCountOf(session.frameOutput().options, 101), 96);
  run(session, "frames-range");
  EXPECT_TRUE(takesAll(session.frameOutput().options, 101));
  EXPECT_FALSE(session.undoName());  // none of it is the flight's
  // The next flight begins with all of its frames and a file of its own.
  run(session, "frames-range 5 20");
  run(session, "new");
  EXPECT_TRUE(takesAll(session.frameOutput().options, 101));
  EXPECT_EQ(session.frameOutput().file, "");
  EXPECT_EQ(session.frameOutput().options.format, frameFormat("chan"));
}

TEST(FrameOutput, WritesWhatTheWriterGives) {
  const test::TemporaryFolder folder;
  Session session;
  run(session, "set-space 1 2 3 4");
  for (const char* format : {"vides", "csv", "json", "chan"}) {
    for (const char* space : {"cube", "world"}) {
      const std::string file = folder.path().string() + "/" + format + "." + space;
      run(session, std::string("frames-format ") + format);
      run(session, std::string("frames-space ") + space);
      run(session, "frames-range 3 77");
      run(session, "frames-file \"" + file + "\"");
      run(session, "write-frames");
      // The flight may change meanwhile: it is the one of the moment that is written.
      const std::string wanted = written(session, session.frameOutput().options);
      run(session, "set-zoom 50");
      session.finishFrames();
      EXPECT_EQ(session.output().text.key, "output.frames-written");
      EXPECT_EQ(contents(file), wanted) << file;
      run(session, "undo");
    }
  }
  EXPECT_EQ(session.frameJob(), nullptr);
}

TEST(FrameOutput, AsksBeforeItOverwrites) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path().string() + "/frames.txt";
  std::ofstream(file) << "precious";
  Session session;
  run(session, "frames-file \"" + file + "\"");
  run(session, "write-frames");
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::kFramesExist);
  run(session, "answer cancel");
  EXPECT_EQ(contents(file), "precious");
  run(session, "write-frames");
  run(session, "answer overwrite");
  session.finishFrames();
  EXPECT_EQ(contents(file), written(session, {}));
  // What it wrote itself it may write again.
  run(session, "write-frames");
  EXPECT_FALSE(session.question());
  session.finishFrames();
}

TEST(FrameOutput, NeverGoesOverTheFlightOrIntoWhatIsNoFile) {
  const test::TemporaryFolder folder;
  const std::string flight = folder.path().string() + "/a.vid";
  Session session;
  run(session, "save-as \"" + flight + "\"");
  const std::string before = contents(flight);
  fs::create_symlink(flight, folder.path().string() + "/link.txt");
  ASSERT_EQ(mkfifo((folder.path().string() + "/pipe").c_str(), 0600), 0);
  for (const char* name : {"a.vid", "link.txt"}) {
    run(session, std::string("frames-file ") + name);
    EXPECT_FALSE(session.execute("write-frames"));
    EXPECT_EQ(session.output().text.key, "refusal.frames-over-flight");
  }
  for (const char* name : {".", "pipe"}) {
    run(session, std::string("frames-file ") + name);
    EXPECT_FALSE(session.execute("write-frames"));
    EXPECT_EQ(session.output().text.key, "refusal.no-file");
  }
  EXPECT_EQ(contents(flight), before);
}

TEST(FrameOutput, AFailureIsToldAndLeavesNothing) {
  const test::TemporaryFolder folder;
  Session session;
  run(session, "show-window frames");
  run(session, "frames-file \"" + folder.path().string() + "/missing/frames.txt\"");
  run(session, "write-frames");
  session.finishFrames();
  EXPECT_EQ(session.output().kind, MessageKind::kError);
  EXPECT_EQ(session.output().text.key, "output.frames-failed");
  EXPECT_TRUE(session.windowOpen("frames"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

// 500 million frames: minutes, if nobody cancels it.
void makeEndless(Session& session) {
  run(session, "set-duration 50000");
  run(session, "set-frame-rate 1000");
}

TEST(FrameOutput, CancelledTheOldFileStays) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path().string() + "/frames.txt";
  std::ofstream(file) << "precious";
  Session session;
  makeEndless(session);
  run(session, "frames-file \"" + file + "\"");
  run(session, "write-frames");
  run(session, "answer overwrite");
  ASSERT_NE(session.frameJob(), nullptr);
  EXPECT_FALSE(session.execute("write-frames"));  // one at a time
  EXPECT_FALSE(session.frameJob()->end());
  run(session, "cancel-frames");
  session.finishFrames();
  EXPECT_EQ(session.output().text.key, "output.frames-cancelled");
  EXPECT_EQ(contents(file), "precious");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
  EXPECT_FALSE(session.execute("cancel-frames"));
}

// Also while nothing is written yet: angles of a .chan go on from the first frame.
TEST(FrameOutput, CancelsOnTheWayToTheFirstFrame) {
  const test::TemporaryFolder folder;
  Session session;
  makeEndless(session);
  run(session, "frames-format chan");
  run(session, "frames-range 49999990 50000000");
  run(session, "frames-file \"" + folder.path().string() + "/frames.chan\"");
  run(session, "write-frames");
  run(session, "cancel-frames");
  session.finishFrames();
  EXPECT_EQ(session.output().text.key, "output.frames-cancelled");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FrameOutput, QuittingMeanwhileAsks) {
  const test::TemporaryFolder folder;
  {
    Session session;
    makeEndless(session);
    run(session, "save-as \"" + folder.path().string() + "/a.vid\"");
    run(session, "write-frames");
    run(session, "quit");
    ASSERT_TRUE(session.question());
    EXPECT_EQ(session.question()->kind, Question::Kind::kWritingFrames);
    run(session, "answer cancel");
    EXPECT_FALSE(session.quitRequested());
    run(session, "quit");
    run(session, "answer stop");
    EXPECT_TRUE(session.quitRequested());
    EXPECT_EQ(session.frameJob(), nullptr);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
  {
    // Without asking (the program ends another way) nothing is left behind, either.
    Session session;
    run(session, "open \"" + folder.path().string() + "/a.vid\"");
    run(session, "write-frames");
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

// What was asked while it wrote goes on when it is written.
TEST(FrameOutput, QuittingGoesOnWhenItIsWritten) {
  const test::TemporaryFolder folder;
  Session session;
  run(session, "save-as \"" + folder.path().string() + "/a.vid\"");
  run(session, "write-frames");
  run(session, "quit");
  session.finishFrames();
  EXPECT_TRUE(session.quitRequested());
  EXPECT_EQ(contents(folder.path().string() + "/a.txt"), written(session, {}));
}

}  // namespace
}  // namespace vides
