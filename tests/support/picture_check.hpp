// SPDX-License-Identifier: MIT
// Compares a picture with its baseline under tests/baselines/.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "render/picture.hpp"

namespace vides::test {

// EXPECT_TRUE(equalsBaseline(picture, "name")): equal to tests/baselines/NAME.png within the
// tolerance. A failure says how many pixels differ and where, and writes NAME.actual.png and
// NAME.difference.png to the build folder's pictures/. With VIDES_UPDATE_BASELINES=1 in the
// environment the picture becomes the baseline instead, and the check fails to say so.
testing::AssertionResult equalsBaseline(const Picture& actual, const std::string& name,
                                        const PictureTolerance& tolerance = {});

// The same against a picture at hand.
testing::AssertionResult equalsPicture(const Picture& actual, const Picture& expected,
                                       const std::string& name,
                                       const PictureTolerance& tolerance = {});

}  // namespace vides::test
