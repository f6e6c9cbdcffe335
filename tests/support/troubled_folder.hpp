// SPDX-License-Identifier: MIT
// A folder with files to open, save and import, whose disk can be made to fail: for random use of
// every command that reaches for files. Nothing outside it is touched.
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "edit/session.hpp"
#include "io/vid_writer.hpp"
#include "support/files.hpp"

namespace vides::test {

class TroubledFolder {
 public:
  TroubledFolder() {
    signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error then
    mend();
  }
  ~TroubledFolder() { allow(RLIM_INFINITY); }

  // Names for any number: good ones and bad ones.
  std::string name(std::size_t number) const {
    const std::vector<std::string> names = {
        (folder_ / "a.vid").string(),
        (folder_ / "b.vid").string(),
        (folder_ / "sub/c.vid").string(),
        (folder_ / "sub/deep/d.vid").string(),
        (folder_ / "sub/s.obj").string(),
        (folder_ / "s.obj").string(),
        (folder_ / "setup.json").string(),
        (folder_ / "frames.txt").string(),
        (folder_ / "broken.vid").string(),
        (folder_ / "p\xE4ne.vid").string(),
        (folder_ / "p\xE4ne.obj").string(),
        (folder_ / "two\nlines \x1B.vid").string(),
        (folder_ / std::string(300, 'n')).string(),
        (folder_ / "none/e.vid").string(),
        (folder_ / "loop").string(),
        folder_.path().string(),
        "",
        "/dev/full",
    };
    return names[number % names.size()];
  }

  // What happens to disks: folders go, are files, come again; nothing can be written any more.
  void trouble(std::size_t kind) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    switch (kind % 5) {
      case 0:
        fs::remove_all(folder_ / "sub", ignored);
        break;
      case 1:
        fs::remove_all(folder_ / "sub", ignored);
        writeAll(folder_ / "sub", "a file");
        break;
      case 2:
        allow(20);
        break;
      case 3:
        write("a.vid", "theirs");
        break;
      default:
        mend();
    }
  }

  void mend() {
    namespace fs = std::filesystem;
    allow(RLIM_INFINITY);
    std::error_code ignored;
    fs::remove_all(folder_ / "sub", ignored);
    fs::create_directories(folder_ / "sub/deep", ignored);
    fs::create_symlink(folder_ / "loop", folder_ / "loop", ignored);
    const std::string scene = "v -1 -1 -1\nv 1 1 1\nv 1 -1 1\nl 1 2\nf 1 2 3\n";
    for (const char* name : {"s.obj", "sub/s.obj", "p\xE4ne.obj"}) write(name, scene);
    for (const char* name : {"b.vid", "sub/c.vid"}) write(name, writeVid(newFlight()));
    write("broken.vid", "{\"format\": \"vides\"");
  }

 private:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary | std::ios::trunc) << text;
  }
  static void allow(rlim_t bytes) {
    struct rlimit limit {};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  TemporaryFolder folder_;
};

}  // namespace vides::test
