// SPDX-License-Identifier: MIT
// Something to see at once, without a display: the sample flight's frames.
#pragma once

namespace vides {

// Writes them to out/ in the current folder and says what else there is to try. Returns the exit
// status.
int writeSampleFrames();

}  // namespace vides
