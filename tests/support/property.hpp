// SPDX-License-Identifier: MIT
// Properties over random input as tests: so many cases as are asked for, not rapidcheck's hundred.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

namespace vides::test {

// Seeds from all 64 bits, in every case (rapidcheck's integers begin small). They don't shrink: let
// the size of what is made from them shrink.
inline rc::Gen<std::uint64_t> seeds() {
  return rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

// Fails the running test with the smallest counterexample that is found. RC_PARAMS in the
// environment, rapidcheck's own way to repeat a case, goes before `cases`.
template <class Property>
void holdsFor(int cases, Property&& property) {
  rc::detail::TestMetadata metadata;
  metadata.id = testing::UnitTest::GetInstance()->current_test_info()->name();
  rc::detail::TestParams params;
  params.maxSuccess = cases;
  params.seed = 20240229;  // the same cases on every run
  const bool own = std::getenv("RC_PARAMS") == nullptr;
  const rc::detail::TestResult result =
      own ? rc::detail::checkTestable(std::forward<Property>(property), metadata, params)
          : rc::detail::checkTestable(std::forward<Property>(property), metadata);
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << message.str();
}

}  // namespace vides::test
