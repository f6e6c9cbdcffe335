// SPDX-License-Identifier: MIT
// Places in words.
#include "edit/place_text.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vides {

std::vector<std::string_view> tokensOf(std::string_view pointer) {
  std::vector<std::string_view> tokens;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    tokens.push_back(pointer.substr(1, end - 1));
    pointer.remove_prefix(end);
  }
  return tokens;
}

std::optional<std::size_t> indexIn(std::string_view token) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  if (error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return index;
}

namespace {

// "position x", "speed 4", "zoom": a member, and which of its numbers.
std::optional<Text> memberOf(const std::vector<std::string_view>& tokens, std::size_t from) {
  constexpr std::string_view kPoints[] = {"position", "aim"};
  constexpr std::string_view kNumbers[] = {"roll", "zoom", "hold", "duration"};
  if (from + 1 == tokens.size()) {
    for (const std::string_view name : kNumbers) {
      if (tokens[from] == name) return Text("place." + std::string(name));
    }
    for (const std::string_view name : kPoints) {
      if (tokens[from] == name) return Text("place." + std::string(name), {""});
    }
    return std::nullopt;
  }
  if (from + 2 != tokens.size()) return std::nullopt;
  const std::optional<std::size_t> index = indexIn(tokens[from + 1]);
  for (const std::string_view name : kPoints) {
    if (tokens[from] == name && index && *index < 3) {
      return Text("place." + std::string(name), {std::string(" ") + "xyz"[*index]});
    }
  }
  if (tokens[from] == "speed" && index) return Text("place.speed", {*index + 1});
  for (const std::string_view name : {"tension", "continuity", "bias"}) {
    if (tokens[from] == "shape" && tokens[from + 1] == name) {
      return Text("place." + std::string(name));
    }
  }
  return std::nullopt;
}

std::optional<Text> placeOf(std::string_view pointer) {
  const std::vector<std::string_view> tokens = tokensOf(pointer);
  if (tokens.size() < 3 || tokens[0] != "keys") return std::nullopt;
  const std::optional<std::size_t> key = indexIn(tokens[1]);
  if (!key) return std::nullopt;
  if (tokens[2] != "orientations") {
    const std::optional<Text> member = memberOf(tokens, 2);
    return member ? std::optional(Text("place.key", {*key + 1, *member})) : std::nullopt;
  }
  const std::optional<std::size_t> orientation =
      tokens.size() > 4 ? indexIn(tokens[3]) : std::nullopt;
  const std::optional<Text> member = orientation ? memberOf(tokens, 4) : std::nullopt;
  if (!member) return std::nullopt;
  return Text("place.orientation", {*key + 1, *orientation + 1, *member});
}

}  // namespace

Text refusalOf(const Problem& problem) {
  const std::optional<Text> place = placeOf(problem.pointer);
  if (!place) return Text("refusal.problem", {problem});
  Problem there = problem;
  there.pointer.clear();
  return Text("refusal.at", {*place, there});
}

}  // namespace vides
