// SPDX-License-Identifier: MIT
// What the file chooser lists.
#include "edit/folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/files.hpp"

namespace vides {
namespace {

TEST(Filter, PatternsFitWholeNames) {
  EXPECT_TRUE(fitsFilter("flight.vid", "*.vid"));
  EXPECT_TRUE(fitsFilter("FLIGHT.VID", "*.vid"));
  EXPECT_TRUE(fitsFilter("flight.vid", "*.VID"));
  EXPECT_FALSE(fitsFilter("flight.vid.bak", "*.vid"));
  EXPECT_FALSE(fitsFilter("flightvid", "*.vid"));
  EXPECT_TRUE(fitsFilter("take7.vid", "take?.vid"));
  EXPECT_FALSE(fitsFilter("take17.vid", "take?.vid"));
  EXPECT_TRUE(fitsFilter("Gr\u00fc\u00dfe.vid", "gr*e.vid"));
}

TEST(Filter, OneOfSeveralIsEnough) {
  for (const char* filter : {"*.txt *.csv", "*.txt,*.csv", "*.txt; *.csv", " *.csv\t"}) {
    EXPECT_TRUE(fitsFilter("a.csv", filter)) << filter;
    EXPECT_FALSE(fitsFilter("a.json", filter)) << filter;
  }
}

TEST(Filter, AWordFitsWhereItOccursAndNothingFitsAll) {
  EXPECT_TRUE(fitsFilter("around the pyramid.vid", "pyra"));
  EXPECT_TRUE(fitsFilter("around the pyramid.vid", ".vid"));
  EXPECT_FALSE(fitsFilter("orbit.vid", "pyra"));
  EXPECT_TRUE(fitsFilter("anything", ""));
  EXPECT_TRUE(fitsFilter("anything", " ; "));
}

TEST(Filter, OtherSignsStandForThemselves) {
  EXPECT_TRUE(fitsFilter("a[1].vid", "a[1].vid"));
  EXPECT_FALSE(fitsFilter("a1.vid", "a[1].vid"));
  EXPECT_TRUE(fitsFilter("a\\*.vid", "a\\*.vid"));
  EXPECT_FALSE(fitsFilter("a*.vid", "a\\?.vid"));
}

TEST(Folder, FoldersFirstThenTheFilesThatFit) {
  const test::TemporaryFolder folder;
  for (const char* name : {"b.vid", "A.vid", "notes.txt", ".hidden.vid"}) {
    std::ofstream(folder.path() / name) << name;
  }
  std::filesystem::create_directory(folder.path() / "zoo");
  using Entries = std::vector<FolderEntry>;
  EXPECT_EQ(readFolder(folder.path(), "*.vid").value(),
            (Entries{{"zoo", true}, {"A.vid", false}, {"b.vid", false}}));
  EXPECT_EQ(readFolder(folder.path(), "notes").value(),
            (Entries{{"zoo", true}, {"notes.txt", false}}));
  EXPECT_EQ(readFolder(folder.path(), ".*").value(),
            (Entries{{"zoo", true}, {".hidden.vid", false}}));
  EXPECT_EQ(readFolder(folder.path(), "").value().size(), 4u);
  EXPECT_FALSE(readFolder(folder.path() / "nowhere", ""));
}

}  // namespace
}  // namespace vides
