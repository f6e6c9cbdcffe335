// SPDX-License-Identifier: MIT
// Whose OpenGL context this thread draws with: OpenGL's own state is one a thread, and so is this.
#include "host/current_context.hpp"

namespace vides {
namespace {

const void*& current() {
  thread_local const void* context = nullptr;
  return context;
}

}  // namespace

bool isCurrentContext(const void* context) { return current() == context; }
void setCurrentContext(const void* context) { current() = context; }

}  // namespace vides
