// SPDX-License-Identifier: MIT
// What went wrong, as a sentence for the user: `return Failure("…")` from a function whose result
// is a tl::expected<…, std::string>.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace vides {

using Failure = tl::unexpected<std::string>;

}  // namespace vides
