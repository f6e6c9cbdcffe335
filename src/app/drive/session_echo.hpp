// SPDX-License-Identifier: MIT
// What goes wrong in the editor while a script runs, told outside: with the script's line.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/drive/player.hpp"

namespace vides {

class SessionEcho {
 public:
  // Lines go to `tell` without the line's end. What has been said until now isn't told.
  SessionEcho(Player& player, std::string_view script,
              std::function<void(const std::string&)> tell);

  // After a line of the script: `SCRIPT:LINE: TEXT` for everything that the session refused or that
  // failed, once each; what was left out of a scene that has come, `SCRIPT:LINE: FILE: remark:
  // TEXT`. What `failure`, the line's own, tells already isn't told twice.
  void afterLine(std::size_t line, std::string_view failure);

 private:
  void tellRemarks(const std::string& place);

  Player& player_;
  std::string script_;
  std::function<void(const std::string&)> tell_;
  std::vector<SharedReading> known_;  // scenes whose remarks have been told
};

}  // namespace vides
