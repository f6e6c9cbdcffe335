// SPDX-License-Identifier: MIT
// A shared library found while the program runs, so that the program starts without it, too.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "render/failure.hpp"

namespace vides {

// Stays loaded until the program ends: drivers keep threads and addresses of their own.
class Library {
 public:
  // `name` as the dynamic linker knows it ("libEGL.so.1"). The error is the linker's sentence.
  static tl::expected<Library, std::string> open(const std::string& name);

  // The address of a function as the type of `function`; false where the library lacks it.
  template <typename Function>
  bool find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(address(name));
    return function != nullptr;
  }

 private:
  explicit Library(void* handle) : handle_(handle) {}
  void* address(const char* name) const;

  void* handle_;
};

}  // namespace vides
