// SPDX-License-Identifier: MIT
// A screen in memory for tests that open a real window.
#include "support/screen.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace vides::test {

Screen::Screen() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) std::abort();
  server_ = fork();
  if (server_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // also when the test crashes
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    close(ends[0]);
    const std::string descriptor = std::to_string(ends[1]);
    // The server chooses a free display and writes its number once it is ready.
    execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x800x24",
           "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  std::string display = ":";
  for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) display += c;
  close(ends[0]);
  if (display == ":") {
    std::fputs("Xvfb cannot be started\n", stderr);
    std::abort();
  }
  setenv("DISPLAY", display.c_str(), 1);
}

Screen::~Screen() {
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
  unsetenv("DISPLAY");
}

}  // namespace vides::test
