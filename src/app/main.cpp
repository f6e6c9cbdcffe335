// SPDX-License-Identifier: MIT
// The program's entry.
#include "app/cli.hpp"
#include "io/temporary_files.hpp"

int main(int argc, char** argv) {
  vides::removeTemporaryFilesOnSignals();
  return vides::runCommandLine(argc, argv);
}
