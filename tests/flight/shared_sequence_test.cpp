// SPDX-License-Identifier: MIT
// A SharedSequence behaves as a vector does, its copies stay as they were, and they share.
#include "flight/shared_sequence.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include "support/property.hpp"

namespace vides {
namespace {

// Tells orders apart (an addition would not): a hash of the sequence of items. Beside it the number
// of items and their sum, by which they are found; an item of 0 adds nothing to it.
struct Trace {
  std::uint64_t count = 0;
  std::uint64_t hash = 0;
  std::uint64_t power = 1;  // of the base, to the count
  std::int64_t sum = 0;
  static Trace of(int item) { return {1, static_cast<std::uint64_t>(item) + 1, kBase, item}; }
  Trace operator+(const Trace& o) const {
    return {count + o.count, hash * o.power + o.hash, power * o.power, sum + o.sum};
  }
  std::int64_t index() const { return sum; }
  static constexpr bool addsUp() { return true; }
  static constexpr std::int64_t kIndexSlack = 0;
  bool operator==(const Trace&) const = default;
  static constexpr std::uint64_t kBase = 1'000'003;
};

using Sequence = SharedSequence<int, Trace>;

Trace traceOf(const std::vector<int>& items, std::size_t count) {
  Trace trace;
  for (std::size_t i = 0; i < count; ++i) trace = trace + Trace::of(items[i]);
  return trace;
}

std::vector<int> itemsOf(const Sequence& sequence) {
  std::vector<int> items;
  sequence.forEach([&](int item) { items.push_back(item); });
  return items;
}

std::size_t below(std::size_t n) { return *rc::gen::inRange<std::size_t>(0, n); }
int anyItem() { return *rc::gen::inRange(0, 5); }  // few, so that equal ones meet

std::vector<int> anyItems(std::size_t most) {
  std::vector<int> items(below(most + 1));
  for (int& item : items) item = anyItem();
  return items;
}

// The same edit of both.
void edit(Sequence& sequence, std::vector<int>& items) {
  const std::size_t size = items.size();
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  switch (below(4)) {
    case 0:
      if (size > 0) {
        const std::size_t i = below(size);
        sequence.set(i, items[i] = anyItem());
      }
      break;
    case 1: {
      const std::size_t i = below(size + 1);
      const int item = anyItem();
      sequence.insert(i, item);
      items.insert(at(i), item);
      break;
    }
    case 2:
      if (size > 0) {
        const std::size_t i = below(size);
        sequence.erase(i);
        items.erase(at(i));
      }
      break;
    default: {
      const std::size_t first = below(size + 1);
      const std::size_t count = below(std::min<std::size_t>(size - first, 90) + 1);
      const std::vector<int> other = anyItems(90);
      sequence.replace(first, count, other);
      items.erase(at(first), at(first + count));
      items.insert(at(first), other.begin(), other.end());
    }
  }
}

// Everything that can be asked.
void requireSame(const Sequence& sequence, const std::vector<int>& items) {
  RC_ASSERT(sequence.size() == items.size());
  RC_ASSERT(sequence.empty() == items.empty());
  RC_ASSERT(itemsOf(sequence) == items);
  RC_ASSERT(sequence.summary() == traceOf(items, items.size()));
  if (!items.empty()) {
    RC_ASSERT(sequence.front() == items.front());
    RC_ASSERT(sequence.back() == items.back());
    const std::size_t i = below(items.size());
    RC_ASSERT(sequence[i] == items[i]);
  }
  const std::size_t prefix = below(items.size() + 1);
  RC_ASSERT(sequence.summaryBefore(prefix) == traceOf(items, prefix));
  const std::size_t first = below(items.size() + 1);
  const std::size_t last = first + below(items.size() - first + 1);
  std::vector<int> part;
  sequence.forEach(first, last, [&](int item) { part.push_back(item); });
  RC_ASSERT(part == std::vector<int>(items.begin() + static_cast<std::ptrdiff_t>(first),
                                     items.begin() + static_cast<std::ptrdiff_t>(last)));
}

void requireFound(const Sequence& sequence, const std::vector<int>& items) {
  // The item with which the count reaches x, and what lies before it.
  const std::size_t x = below(items.size() + 2);
  const auto found = sequence.find([&](const Trace& t) { return t.count >= x; });
  if (items.empty() || x > items.size()) {
    RC_ASSERT(found.index == items.size());
    RC_ASSERT(found.item == nullptr);
  } else {
    const std::size_t index = x == 0 ? 0 : x - 1;
    RC_ASSERT(found.index == index);
    RC_ASSERT(*found.item == items[index]);
    RC_ASSERT(found.before == traceOf(items, index));
  }
}

void requireFoundByIndex(const Sequence& sequence, const std::vector<int>& items) {
  const std::int64_t total = traceOf(items, items.size()).sum;
  const auto value = *rc::gen::inRange<std::int64_t>(0, total + 2);
  const auto found = sequence.findIndex(value);
  const auto slow = sequence.find([&](const Trace& t) { return t.index() > value; });
  RC_ASSERT(found.index == slow.index);
  RC_ASSERT(found.before == slow.before);
  RC_ASSERT(found.item == slow.item);
  std::size_t index = 0;
  for (std::int64_t sum = 0; index < items.size(); ++index) {
    sum += items[index];
    if (sum > value) break;
  }
  RC_ASSERT(found.index == index);
}

TEST(SharedSequence, BehavesAsAVectorThroughEdits) {
  constexpr int kEdits = 40;
  test::holdsFor(400, [] {  // 16,000 edits
    std::vector<int> items = anyItems(300);
    Sequence sequence(items);
    requireSame(sequence, items);
    for (int i = 0; i < kEdits; ++i) {
      edit(sequence, items);
      requireSame(sequence, items);
      requireFound(sequence, items);
      requireFoundByIndex(sequence, items);
    }
  });
}

TEST(SharedSequence, CopiesStayAsTheyWere) {
  test::holdsFor(200, [] {
    std::vector<int> items = anyItems(200);
    Sequence sequence(items);
    std::vector<std::pair<Sequence, std::vector<int>>> copies;
    for (int i = 0; i < 20; ++i) {
      copies.emplace_back(sequence, items);
      edit(sequence, items);
    }
    for (const auto& [copy, then] : copies) RC_ASSERT(itemsOf(copy) == then);
  });
}

// What `changes` tells turns the one into the other, and what it leaves out is equal.
void requireChanges(const Sequence& from, const Sequence& to) {
  const std::vector<int> before = itemsOf(from);
  const std::vector<int> after = itemsOf(to);
  const auto changes = Sequence::changes(from, to);
  std::vector<int> made;
  std::size_t done = 0;  // of `before`
  for (const Sequence::Change& change : changes) {
    RC_ASSERT(done <= change.first && change.first <= change.oldLast);
    made.insert(made.end(), before.begin() + static_cast<std::ptrdiff_t>(done),
                before.begin() + static_cast<std::ptrdiff_t>(change.first));
    RC_ASSERT(made.size() == change.first);
    made.insert(made.end(), after.begin() + static_cast<std::ptrdiff_t>(change.first),
                after.begin() + static_cast<std::ptrdiff_t>(change.newLast));
    done = change.oldLast;
  }
  made.insert(made.end(), before.begin() + static_cast<std::ptrdiff_t>(done), before.end());
  RC_ASSERT(made == after);
  RC_ASSERT((from == to) == (before == after));
  if (before == after) RC_ASSERT(changes.empty());
}

TEST(SharedSequence, ChangesTellWhatDiffers) {
  test::holdsFor(1000, [] {
    std::vector<int> items = anyItems(250);
    Sequence from(items);
    Sequence to = from;
    for (std::size_t i = below(4); i > 0; --i) edit(to, items);
    requireChanges(from, to);
    requireChanges(from, Sequence(items));  // equal in part, but sharing nothing
  });
}

TEST(SharedSequence, OneSetIsOneChange) {
  std::vector<int> items(10'000);
  std::iota(items.begin(), items.end(), 0);
  const Sequence from(items);
  for (const std::size_t i : {0UL, 1UL, 31UL, 32UL, 5000UL, 9999UL}) {
    Sequence to = from;
    to.set(i, -1);
    const auto changes = Sequence::changes(from, to);
    ASSERT_EQ(changes.size(), 1U) << i;
    EXPECT_EQ(changes[0].first, i);
    EXPECT_EQ(changes[0].oldLast, i + 1);
    EXPECT_EQ(changes[0].newLast, i + 1);
  }
}

TEST(SharedSequence, FindsAreFewSteps) {
  std::vector<int> items(1'000'000);
  const Sequence sequence(items);
  int asked = 0;
  const auto found = sequence.find([&](const Trace& t) {
    ++asked;
    return t.count > 777'777;
  });
  EXPECT_EQ(found.index, 777'777U);
  EXPECT_LT(asked, 40);
}

}  // namespace
}  // namespace vides
