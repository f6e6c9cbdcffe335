// SPDX-License-Identifier: MIT
// The panels' words in the user's language.
#pragma once

#include <string>
#include <string_view>

#include "edit/text.hpp"
#include "io/problem_text.hpp"

namespace vides {

// Empty where the table has no such key.
std::string panelWords(std::string_view key, Language language);
std::string tellText(const Text& text, Language language);

}  // namespace vides
