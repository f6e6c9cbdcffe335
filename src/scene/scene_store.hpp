// SPDX-License-Identifier: MIT
// The scene files of a flight: each is read once, for the measure of an import and for every
// picture, and stays known for undo and redo.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scene/scene_reading.hpp"

namespace vides {

class SceneStore {
 public:
  // `waits`: every scene is read to its end at once, as scripts and pictures want it. Else small
  // ones only; large ones come when they are ready.
  explicit SceneStore(bool waits) : waits_(waits) {}

  // Reads a file anew, or finds what was read of it, if it is as it was then.
  SharedReading read(const std::filesystem::path& file);

  // The scenes of a flight as far as they have been read. `files` as sceneFilePath() gives them;
  // those that are new are begun, a few at a time, and those that are named no more are given up.
  // What was read stays so, whatever happens to the file, until another `document` than the last
  // one asks for it: then what has changed, and what couldn't be read, is read again.
  std::vector<SharedDrawable> scenes(const std::vector<std::filesystem::path>& files,
                                     std::int64_t document);
  // What is known of one of those files: its reading, null while it waits for its turn.
  SharedReading readingOf(const std::filesystem::path& file) const;
  // Reads a file again, however it is, when scenes() asks for it next.
  void readAgain(const std::filesystem::path& file);
  // Those files that are on the disk in another way than they were read, or are there no more.
  std::vector<std::filesystem::path> changedOnDisk() const;
  // Of those scenes, the ones that turned out not to be readable; each is told once.
  std::vector<SharedReading> takeRefused();
  // Of those scenes, the ones whose report has notes; each is told once. An import, which read()
  // reads for, tells them itself.
  std::vector<SharedReading> takeNoted();

  // Those at work.
  std::vector<SharedReading> reading() const;
  void cancel();

 private:
  // How a file was when it was read.
  struct Stamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
    bool operator==(const Stamp&) const = default;
  };
  struct Known {
    std::filesystem::path file;
    Stamp stamp;
    SharedReading reading;  // null: waits for its turn
    bool told = false;
  };
  static Stamp stampOf(const std::filesystem::path& file);
  Known* find(const std::filesystem::path& file);
  void setFiles(const std::vector<std::filesystem::path>& files, std::int64_t document);
  void start();

  bool waits_;
  std::vector<Known> known_;  // least recently used first
  std::vector<std::filesystem::path> files_;
  std::int64_t document_ = -1;
  std::vector<SharedReading> refused_, noted_;
};

}  // namespace vides
