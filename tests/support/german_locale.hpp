// SPDX-License-Identifier: MIT
// The locale de_DE.UTF-8, in which numbers have a comma, for as long as it lives.
#pragma once

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <locale>
#include <string>

namespace vides::test {

// Of the whole process, for C and C++. It is compiled into the build folder (tests/CMakeLists.txt).
class GermanLocale {
 public:
  GermanLocale() : before_(std::setlocale(LC_ALL, nullptr)) {
    setenv("LOCPATH", VIDES_TEST_LOCPATH, 1);
    // A test in the wrong locale would pass for nothing.
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) ADD_FAILURE() << "no German locale";
    EXPECT_STREQ(std::localeconv()->decimal_point, ",");
    std::locale::global(std::locale("de_DE.UTF-8"));
  }
  ~GermanLocale() {
    std::locale::global(std::locale::classic());
    std::setlocale(LC_ALL, before_.c_str());
    unsetenv("LOCPATH");
  }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;

 private:
  std::string before_;
};

}  // namespace vides::test
