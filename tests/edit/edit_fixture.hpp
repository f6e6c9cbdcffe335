// SPDX-License-Identifier: MIT
// Flights and helpers that the tests of the editor share.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>

#include "edit/session.hpp"
#include "io/vid_writer.hpp"

namespace vides {

// In failures: a flight is told by what it has, not by its bytes.
inline void PrintTo(const Flight& flight, std::ostream* out) {
  *out << "a flight of " << flight.keys.size() << " keys and " << flight.keys.orientations()
       << " orientations";
}

// Runs a command that must not be refused.
inline void run(Session& session, const std::string& line) {
  EXPECT_TRUE(session.execute(line)) << line << ": " << session.output().text.key;
}

// Runs one that must be, for the reason that the text of that key gives.
inline void refused(Session& session, const std::string& line, const std::string& key) {
  const Flight before = session.flight();
  const std::size_t steps = session.history().steps();
  EXPECT_FALSE(session.execute(line)) << line;
  EXPECT_EQ(session.output().text.key, key) << line;
  EXPECT_EQ(session.flight(), before) << line;
  EXPECT_EQ(session.history().steps(), steps) << line;
}

// An open flight of five keys, the second with three orientations.
inline void makeFive(Session& session) {
  run(session, "select-key 0");
  run(session, "insert-keys 3");
  run(session, "move-key 1 -0.3 -0.4 0.2");
  run(session, "move-key 2 0.1 0.7 -0.6");
  run(session, "move-key 3 0.6 -0.2 -0.1");
  run(session, "select-key 1");
  run(session, "insert-orientation");
  run(session, "set-aim 0.5 0.5 -0.5");
  run(session, "insert-orientation");
  run(session, "set-roll 40");
}

inline std::string fileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void writeFile(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// A folder of its own for each test, removed afterwards.
class FolderTest : public testing::Test {
 protected:
  FolderTest() {
    std::string name = (std::filesystem::temp_directory_path() / "vides_edit_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FolderTest() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::filesystem::path folder_;
};

}  // namespace vides
