// SPDX-License-Identifier: MIT
// Puts problems into words.
#pragma once

#include <string>
#include <string_view>

#include "flight/problem.hpp"

namespace vides {

// Another language is one more table in problem_text.cpp.
enum class Language { kEnglish, kGerman };

// "expected a number from 1 to 100, found 250": without file and place, without a full stop.
// Control characters are shown as escapes.
std::string problemText(const Problem& problem, Language language = Language::kEnglish);

// FILE: POINTER: MESSAGE, of syntax errors FILE:LINE:COLUMN: MESSAGE, and FILE: MESSAGE for what
// concerns the file as a whole. One line, whatever the file's name (flight/printable.hpp).
std::string problemLine(std::string_view file, const Problem& problem,
                        Language language = Language::kEnglish);

}  // namespace vides
