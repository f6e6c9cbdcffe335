// SPDX-License-Identifier: MIT
// Scripts of `vides drive` as values: lines of words, with points that later lines may use.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "math/vector.hpp"

namespace vides {

struct ScriptWord {
  std::string text;
  bool quoted = false;
};

struct ScriptLine {
  std::size_t number = 0;  // from 1
  std::vector<ScriptWord> words;
  std::string rest;  // the line as written behind its first word, without the comment
};

// The lines that say something; they end with CR, LF or CRLF. `#` begins a comment, except in
// double quotes, where \" and \\ are the characters themselves. A script that isn't UTF-8, or has a
// NUL, is no script. Error: "LINE: what is wrong".
tl::expected<std::vector<ScriptLine>, std::string> readScript(std::string_view text);

// Points kept by `point $NAME where …`.
using ScriptPoints = std::map<std::string, Vec2, std::less<>>;

// A number: "1.5", or "$NAME.x", "$NAME.y" with "+N" or "-N" after it. Error: a sentence.
tl::expected<double, std::string> scriptNumber(std::string_view word, const ScriptPoints& points);

}  // namespace vides
