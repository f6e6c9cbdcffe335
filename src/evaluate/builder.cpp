// SPDX-License-Identifier: MIT
// The evaluator's three stages over all records, or over those that an edit reaches.
#include "evaluate/builder.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <span>
#include <vector>

#include "evaluate/chain.hpp"
#include "evaluate/record_slab.hpp"

namespace vides {
namespace {

using FreshRecord = std::shared_ptr<KeyRecord>;
using Places = std::vector<OrientationPlace>;

// Stages 2 and 3 of one section.
void setSpeedAt(const Chain& chain, const OrientationPlace& place, SectionRecord& s) {
  setSpeed(s, chain.speedBefore(place), chain.speedAfter(place));
}

void setPathAt(const Chain& chain, const OrientationPlace& place, SectionRecord& s) {
  const Neighbours beside = chain.neighbours(place);
  s.signs = chain.linkSigns(place, beside);
  s.signsDependOnChain = chain.signsDependOnChain(place, beside);
  s.path = chain.method().make(chain.pathInput(place, beside));
}

// The records that take part in a build, all of them in one array.
class WholeChain : public Chain {
 public:
  WholeChain(const EvaluationTree& tree, const Flight& flight,
             const std::vector<FreshRecord>& records)
      : Chain(tree, flight.closed, *flight.orientationCurve), records_(records) {}
  const KeyRecord& record(std::size_t key) const override { return *records_[key]; }

 private:
  const std::vector<FreshRecord>& records_;
};

EvaluationTree treeOf(const std::vector<FreshRecord>& records) {
  return EvaluationTree(std::vector<RecordPointer>(records.begin(), records.end()));
}

// `reuse` gives the pieces of a flight with the same number of keys, or is null.
EvaluationTree buildWhole(const Flight& flight, const EvaluationTree* reuse) {
  const std::size_t n = flight.keys.size();
  assert(n >= 2);
  std::vector<const Key*> keys;
  keys.reserve(n);
  flight.keys.forEach([&](const Key& key) { keys.push_back(&key); });
  std::vector<std::shared_ptr<const CurvePiece>> pieces(n);
  if (reuse) {
    std::size_t k = 0;
    reuse->forEach([&](const RecordPointer& record) { pieces[k++] = record->piece; });
  }
  const auto keyAt = [&](std::size_t k) -> const Key* {
    if (k < n) return keys[k];
    return flight.closed ? keys[k - n] : nullptr;
  };
  const auto recordSlab = std::make_shared<Slab<KeyRecord>>(n);
  const auto pieceSlab = std::make_shared<Slab<CurvePiece>>(n);
  std::vector<FreshRecord> records(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Key* before = k > 0 ? keys[k - 1] : flight.closed ? keys[n - 1] : nullptr;
    records[k] = Slab<KeyRecord>::item(recordSlab, k);
    fillRecord(*records[k], flight, before, *keys[k], keyAt(k + 1), keyAt(k + 2), pieces[k],
               Slab<CurvePiece>::item(pieceSlab, k));
  }
  const EvaluationTree stage1 = treeOf(records);
  const WholeChain chain(stage1, flight, records);
  const auto forEachSection = [&](auto apply) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < records[k]->sections.size(); ++j) {
        SectionRecord& s = records[k]->sections[j];
        if (s.exists) apply(chain, OrientationPlace{k, j}, s);
      }
    }
  };
  forEachSection(setSpeedAt);
  forEachSection(setPathAt);
  return treeOf(records);
}

// An update: a few fresh records over a shared tree.
class Update : public Chain {
 public:
  Update(EvaluationTree& tree, const Flight& flight)
      : Chain(tree, flight.closed, *flight.orientationCurve), tree_(tree), flight_(flight) {}

  const KeyRecord& record(std::size_t key) const override {
    const auto found = find(key);
    return found != fresh_.end() && found->first == key ? *found->second : *tree_[key];
  }

  // Stage 1 for the keys of [first, last) (not wrapped), as one block; replaces `oldCount` records.
  void remake(std::size_t first, std::size_t last, std::size_t oldCount);
  // Stages 2 and 3 where stage 1 changed, then the tree.
  void finish();

 private:
  using Fresh = std::vector<std::pair<std::size_t, FreshRecord>>;
  Fresh::const_iterator find(std::size_t key) const {
    return std::lower_bound(fresh_.begin(), fresh_.end(), key,
                            [](const auto& entry, std::size_t k) { return entry.first < k; });
  }
  SectionRecord& edit(const OrientationPlace& place);
  const Key* keyAt(std::ptrdiff_t k) const;
  FreshRecord makeFresh(std::size_t k, const std::shared_ptr<const CurvePiece>& reuse) const;
  void addNeighbours(std::set<OrientationPlace>& places) const;
  void store();

  EvaluationTree& tree_;
  const Flight& flight_;
  Fresh fresh_;  // sorted by key
};

const Key* Update::keyAt(std::ptrdiff_t k) const {
  const auto n = static_cast<std::ptrdiff_t>(flight_.keys.size());
  if (k < 0 || k >= n) {
    if (!flight_.closed || n == 0) return nullptr;
    k = (k + n) % n;
  }
  return &flight_.keys[static_cast<std::size_t>(k)];
}

FreshRecord Update::makeFresh(std::size_t k, const std::shared_ptr<const CurvePiece>& reuse) const {
  const auto i = static_cast<std::ptrdiff_t>(k);
  auto record = std::make_shared<KeyRecord>();
  fillRecord(*record, flight_, keyAt(i - 1), *keyAt(i), keyAt(i + 1), keyAt(i + 2), reuse,
             std::make_shared<CurvePiece>());
  return record;
}

void Update::remake(std::size_t first, std::size_t last, std::size_t oldCount) {
  const bool sameKeys = oldCount == last - first;
  std::vector<RecordPointer> records;
  records.reserve(last - first);
  for (std::size_t k = first; k < last; ++k) {
    FreshRecord record = makeFresh(k, sameKeys ? tree_[k]->piece : nullptr);
    records.emplace_back(record);
    fresh_.emplace_back(k, std::move(record));
  }
  tree_.replace(first, oldCount, records);
}

SectionRecord& Update::edit(const OrientationPlace& place) {
  auto found = find(place.key);
  if (found == fresh_.end() || found->first != place.key) {
    found = fresh_.emplace(found, place.key, std::make_shared<KeyRecord>(*tree_[place.key]));
  }
  return found->second->sections[place.orientation];
}

// The nearest sections before and after each run of places.
void Update::addNeighbours(std::set<OrientationPlace>& places) const {
  const Places from(places.begin(), places.end());
  for (const OrientationPlace& place : from) {
    const Neighbours beside = neighbours(place);
    if (beside.previous) places.insert(*beside.previous);
    if (beside.next) places.insert(*beside.next);
  }
}

void Update::finish() {
  std::set<OrientationPlace> places;
  for (const auto& [k, record] : fresh_) {
    for (std::size_t j = 0; j < record->sections.size(); ++j) places.insert({k, j});
  }
  addNeighbours(places);
  const auto apply = [&](auto set) {
    for (const OrientationPlace& place : places) {
      if (at(place).exists) set(*this, place, edit(place));
    }
  };
  apply(setSpeedAt);
  addNeighbours(places);
  apply(setPathAt);
  store();
}

// Runs of neighbouring keys go into the tree together.
void Update::store() {
  std::size_t i = 0;
  while (i < fresh_.size()) {
    const std::size_t first = fresh_[i].first;
    std::vector<RecordPointer> run;
    while (i < fresh_.size() && fresh_[i].first == first + run.size()) {
      run.emplace_back(std::move(fresh_[i++].second));
    }
    tree_.replace(first, run.size(), run);
  }
  fresh_.clear();
}

// Keys whose records are made anew: ranges of the new flight's keys, sorted, apart from each other.
struct Range {
  std::size_t first = 0;
  std::size_t last = 0;
};

// A key reaches two pieces back and one piece on.
std::vector<Range> reached(const std::vector<Range>& changed, std::size_t n, bool closed) {
  std::vector<Range> list;
  const auto add = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    const auto size = static_cast<std::ptrdiff_t>(n);
    first = std::max<std::ptrdiff_t>(first, 0);
    last = std::min(last, size);
    if (first < last) {
      list.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(last)});
    }
  };
  for (const Range& range : changed) {
    const auto first = static_cast<std::ptrdiff_t>(range.first) - 2;
    const auto last = static_cast<std::ptrdiff_t>(range.last) + 1;
    const auto size = static_cast<std::ptrdiff_t>(n);
    add(first, last);
    if (closed && first < 0) add(first + size, size);
    if (closed && last > size) add(0, last - size);
  }
  std::sort(list.begin(), list.end(), [](auto& a, auto& b) { return a.first < b.first; });
  std::vector<Range> merged;
  for (const Range& range : list) {
    if (!merged.empty() && range.first <= merged.back().last) {
      merged.back().last = std::max(merged.back().last, range.last);
    } else {
      merged.push_back(range);
    }
  }
  return merged;
}

bool sameRules(const Flight& a, const Flight& b) {
  return a.frameRate == b.frameRate && a.rates == b.rates && a.closed == b.closed &&
         a.orientationCurve == b.orientationCurve && a.presets == b.presets;
}

std::size_t count(const std::vector<Range>& ranges) {
  std::size_t sum = 0;
  for (const Range& range : ranges) sum += range.last - range.first;
  return sum;
}

}  // namespace

EvaluationTree buildTree(const Flight& flight) { return buildWhole(flight, nullptr); }

EvaluationTree updateTree(const EvaluationTree& tree, const Flight& old, const Flight& flight) {
  const std::size_t n = flight.keys.size();
  const bool sameSize = old.keys.size() == n;
  const EvaluationTree* reuse = sameSize ? &tree : nullptr;
  if (!sameRules(old, flight)) return buildWhole(flight, reuse);
  const auto changes = KeyList::Sequence::changes(old.keys.sequence(), flight.keys.sequence());
  if (changes.empty()) return tree;

  std::vector<Range> changed;
  for (const auto& change : changes) {
    // Where keys came or went, their neighbours have new neighbours.
    const std::size_t margin = sameSize ? 0 : 1;
    changed.push_back(
        {change.first > margin ? change.first - margin : 0, std::min(change.newLast + margin, n)});
  }
  const std::vector<Range> ranges = reached(changed, n, flight.closed);
  const std::size_t few = 64 + n / 8;
  const auto& first = changes.front();
  if (count(ranges) > few || first.oldLast - first.first > few) return buildWhole(flight, reuse);

  EvaluationTree updated = tree;
  Update update(updated, flight);
  // The one replaced range of a flight whose length changed lies inside one of the ranges.
  const std::size_t oldSize = old.keys.size();
  for (const Range& range : ranges) {
    const bool holdsReplaced =
        !sameSize && range.first <= first.first && first.newLast <= range.last;
    const std::size_t size = range.last - range.first;
    update.remake(range.first, range.last, holdsReplaced ? size + oldSize - n : size);
  }
  update.finish();
  return updated;
}

}  // namespace vides
