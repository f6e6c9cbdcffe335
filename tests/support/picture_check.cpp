// SPDX-License-Identifier: MIT
// Compares a picture with its baseline.
#include "support/picture_check.hpp"

#include <cstdlib>
#include <filesystem>

namespace vides::test {
namespace {

namespace fs = std::filesystem;

std::string written(const Picture& picture, const fs::path& file) {
  fs::create_directories(file.parent_path());
  const auto result = writePng(picture, file);
  return result ? file.string() : result.error();
}

testing::AssertionResult failure(const Picture& actual, const Picture& expected,
                                 const std::string& name, const PictureTolerance& tolerance,
                                 const std::string& sentence) {
  const fs::path folder = VIDES_TEST_PICTURES;
  return testing::AssertionFailure() << name << ": " << sentence << "\n  "
                                     << written(actual, folder / (name + ".actual.png")) << "\n  "
                                     << written(differencePicture(actual, expected, tolerance),
                                                folder / (name + ".difference.png"));
}

}  // namespace

testing::AssertionResult equalsPicture(const Picture& actual, const Picture& expected,
                                       const std::string& name, const PictureTolerance& tolerance) {
  const PictureDifference difference = comparePictures(actual, expected, tolerance);
  if (difference.equal) return testing::AssertionSuccess() << name << ": " << difference.sentence;
  return failure(actual, expected, name, tolerance, difference.sentence);
}

testing::AssertionResult equalsBaseline(const Picture& actual, const std::string& name,
                                        const PictureTolerance& tolerance) {
  const fs::path file = fs::path(VIDES_BASELINES) / (name + ".png");
  const char* const update = std::getenv("VIDES_UPDATE_BASELINES");
  if (update != nullptr && std::string_view(update) == "1") {
    return testing::AssertionFailure() << "baseline written: " << written(actual, file);
  }
  const auto baseline = readPng(file);
  if (!baseline) return failure(actual, Picture(), name, tolerance, baseline.error());
  return equalsPicture(actual, *baseline, name, tolerance);
}

}  // namespace vides::test
