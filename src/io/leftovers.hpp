// SPDX-License-Identifier: MIT
// The temporary files of savers: what they are called, which of them are at work, and clearing away
// what those left that were killed.
#pragma once

#include <string>

namespace vides {

// ".vides-" and 16 random digits of sixteen; empty with errno set where there is no chance.
std::string temporaryName();

// Tells others that its saver is alive, for as long as the file stays open.
void lockTemporary(int file);
// The same of one that has a name already. False where somebody is just clearing it away, or has:
// then another one is needed.
bool lockNamedTemporary(int file);

// Removes the temporary files in an open folder whose savers are dead, however they died, and none
// of a saver at work. What can't be removed, or a folder that can't be listed, stays as it is.
void clearLeftovers(int folder) noexcept;

}  // namespace vides
