// SPDX-License-Identifier: MIT
// The temporary files of this process, for a signal handler to remove.
//
// The one piece of state that belongs to the process and not to an object: a signal handler can
// reach nothing else.
#pragma once

#include <string_view>

namespace vides {

// Remembers a name in an open folder, which must stay open until it is forgotten. Returns a slot,
// or -1 where too many are remembered or the name is too long: such a file is not removed.
int rememberTemporaryFile(int folder, std::string_view name) noexcept;
void forgetTemporaryFile(int slot) noexcept;

// Removes them all. Async-signal-safe: for the handlers of SIGINT and SIGTERM.
void removeTemporaryFiles() noexcept;

// Lets SIGINT, SIGTERM and SIGHUP remove the temporary files and then do what they would do
// without us. For main(); signals that are ignored stay ignored.
void removeTemporaryFilesOnSignals();

}  // namespace vides
