// SPDX-License-Identifier: MIT
// What the file chooser lists.
#include "edit/folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

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

// Folders with a slash behind them.
std::vector<std::string> namesIn(const std::filesystem::path& folder, std::string_view filter,
                                 const FolderOrder& order = {}) {
  std::vector<std::string> names;
  const auto entries = readFolder(folder, filter, order).value();
  for (const FolderEntry& entry : entries) {
    names.push_back(entry.name + (entry.folder ? "/" : ""));
  }
  return names;
}

// Changed so many seconds after the epoch.
void setChanged(const std::filesystem::path& file, std::time_t seconds) {
  const timespec times[2] = {{seconds, 0}, {seconds, 0}};
  ASSERT_EQ(utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
}

TEST(Folder, SortsByNameSizeAndDate) {
  using By = FolderOrder::By;
  const test::TemporaryFolder folder;
  const struct {
    const char* name;
    std::size_t bytes;
    std::time_t changed;
  } files[] = {{"b", 30, 5000}, {"A", 10, 7000}, {"c", 20, 6000}, {"d", 20, 4000}};
  for (const auto& file : files) {
    std::ofstream(folder.path() / file.name) << std::string(file.bytes, 'x');
    setChanged(folder.path() / file.name, file.changed);
  }
  for (const char* name : {"old", "new"}) std::filesystem::create_directory(folder.path() / name);
  setChanged(folder.path() / "old", 1000);
  setChanged(folder.path() / "new", 2000);
  const auto sorted = [&](By by, bool descending) {
    std::string all;
    for (const std::string& name : namesIn(folder.path(), "", {by, descending})) all += name + " ";
    return all;
  };
  EXPECT_EQ(sorted(By::kName, false), "new/ old/ A b c d ");
  EXPECT_EQ(sorted(By::kName, true), "old/ new/ d c b A ");
  EXPECT_EQ(sorted(By::kSize, false), "new/ old/ A c d b ");
  EXPECT_EQ(sorted(By::kSize, true), "new/ old/ b d c A ");
  EXPECT_EQ(sorted(By::kDate, false), "old/ new/ d b c A ");
  EXPECT_EQ(sorted(By::kDate, true), "new/ old/ A c b d ");
  const FolderEntry first = readFolder(folder.path(), "A").value().back();
  EXPECT_EQ(first.bytes, 10u);
  EXPECT_EQ(first.changed, 7000);
}

TEST(Folder, ALinkToNothingIsListed) {
  const test::TemporaryFolder folder;
  std::filesystem::create_symlink("nowhere", folder.path() / "link");
  const auto entries = readFolder(folder.path(), "").value();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_FALSE(entries[0].folder);
  EXPECT_FALSE(entries[0].changed);
}

TEST(Folder, FoldersFirstThenTheFilesThatFit) {
  const test::TemporaryFolder folder;
  for (const char* name : {"b.vid", "A.vid", "notes.txt", ".hidden.vid"}) {
    std::ofstream(folder.path() / name) << name;
  }
  std::filesystem::create_directory(folder.path() / "zoo");
  using Names = std::vector<std::string>;
  EXPECT_EQ(namesIn(folder.path(), "*.vid"), (Names{"zoo/", "A.vid", "b.vid"}));
  EXPECT_EQ(namesIn(folder.path(), "notes"), (Names{"zoo/", "notes.txt"}));
  EXPECT_EQ(namesIn(folder.path(), ".*"), (Names{"zoo/", ".hidden.vid"}));
  EXPECT_EQ(readFolder(folder.path(), "").value().size(), 4u);
  EXPECT_FALSE(readFolder(folder.path() / "nowhere", ""));
}

}  // namespace
}  // namespace vides
