// SPDX-License-Identifier: MIT
// A shared library found while the program runs.
#include "host/library.hpp"

#include <dlfcn.h>

namespace vides {

tl::expected<Library, std::string> Library::open(const std::string& name) {
  void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) {
    const char* reason = dlerror();
    return Failure(reason == nullptr ? name + ": cannot be loaded" : std::string(reason));
  }
  return Library(handle);
}

void* Library::address(const char* name) const { return dlsym(handle_, name); }

}  // namespace vides
