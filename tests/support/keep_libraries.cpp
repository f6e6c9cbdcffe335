// SPDX-License-Identifier: MIT
// For the program under the address sanitizer: libraries that are closed stay in memory, so that
// the leaks of OpenGL's drivers carry their names at the end and leaks.supp can tell them from
// ours.
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept { return 0; }
