// SPDX-License-Identifier: MIT
// Tells what came of the scenes of a flight.
#include "app/flight_scenes.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "app/messages.hpp"
#include "edit/scene_texts.hpp"
#include "edit/texts.hpp"

namespace vides {

bool tellScenes(Editor& editor, const std::string& flight) {
  Session& session = editor.session();
  session.scenes();
  const Texts english(Language::kEnglish);
  const std::vector<SharedReading> readings = session.sceneReadings();
  bool all = true;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const SceneReading::Result* const result = readings[i] ? readings[i]->result() : nullptr;
    if (result == nullptr) continue;
    const std::string place = fmt::format("{}: /scene/{}/file: ", flight, i);
    if (!*result) {
      all = false;
      const std::string& file = session.flight().scene[i].file;
      tellLine(place + english.tell(sceneProblemText(file, result->error())));
      continue;
    }
    for (const SceneNote& note : (**result)->report().notes) {
      tellLine(fmt::format("{}remark: {}", place, english.tell(sceneNoteText(note))));
    }
  }
  return all;
}

}  // namespace vides
