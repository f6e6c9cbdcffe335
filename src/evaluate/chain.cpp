// SPDX-License-Identifier: MIT
// Neighbours, holds and signs along the chain of orientations.
#include "evaluate/chain.hpp"

#include <numbers>

namespace vides {
namespace {

Quaternion signedBy(int sign, const Quaternion& q) { return sign < 0 ? -q : q; }

}  // namespace

OrientationPlace Chain::after(const OrientationPlace& place) const {
  if (place.orientation + 1 < record(place.key).sections.size()) {
    return {place.key, place.orientation + 1};
  }
  return {place.key + 1 < keys() ? place.key + 1 : 0, 0};
}

OrientationPlace Chain::sectionOfRank(std::int64_t rank) const {
  const auto found = tree_.find([&](const RecordSummary& sum) { return sum.sections > rank; });
  std::int64_t left = rank - found.before.sections;
  const KeyRecord& r = record(found.index);
  std::size_t j = 0;
  while (!r.sections[j].exists || left-- > 0) ++j;
  return {found.index, j};
}

std::optional<OrientationPlace> Chain::nextSection(const OrientationPlace& place) const {
  const KeyRecord& r = record(place.key);
  for (std::size_t j = place.orientation + 1; j < r.sections.size(); ++j) {
    if (r.sections[j].exists) return OrientationPlace{place.key, j};
  }
  if (place.key + 1 < keys()) {
    const KeyRecord& neighbour = record(place.key + 1);
    for (std::size_t j = 0; j < neighbour.sections.size(); ++j) {
      if (neighbour.sections[j].exists) return OrientationPlace{place.key + 1, j};
    }
  }
  const std::int64_t total = tree_.summary().sections;
  const std::int64_t rank = tree_.summaryBefore(place.key + 1).sections;
  if (rank < total) return sectionOfRank(rank);
  if (!closed_ || total == 0) return std::nullopt;
  return sectionOfRank(0);
}

std::optional<OrientationPlace> Chain::previousSection(const OrientationPlace& place) const {
  const KeyRecord& r = record(place.key);
  for (std::size_t j = place.orientation; j-- > 0;) {
    if (r.sections[j].exists) return OrientationPlace{place.key, j};
  }
  if (place.key > 0) {
    const KeyRecord& neighbour = record(place.key - 1);
    for (std::size_t j = neighbour.sections.size(); j-- > 0;) {
      if (neighbour.sections[j].exists) return OrientationPlace{place.key - 1, j};
    }
  }
  const std::int64_t total = tree_.summary().sections;
  const std::int64_t rank = tree_.summaryBefore(place.key).sections;
  if (rank > 0) return sectionOfRank(rank - 1);
  if (!closed_ || total == 0) return std::nullopt;
  return sectionOfRank(total - 1);
}

std::optional<double> Chain::speedBefore(const OrientationPlace& place) const {
  const auto p = previousSection(place);
  return p ? std::optional(at(*p).speed.values().back()) : std::nullopt;
}

std::optional<double> Chain::speedAfter(const OrientationPlace& place) const {
  const auto n = nextSection(place);
  return n ? std::optional(at(*n).speed.values().front()) : std::nullopt;
}

std::int64_t Chain::holdsBefore(const OrientationPlace& place) const {
  std::int64_t sum = tree_.summaryBefore(place.key).holdFrames;
  const KeyRecord& r = record(place.key);
  for (std::size_t j = 0; j < place.orientation; ++j) sum += r.sections[j].holdFrames;
  return sum;
}

std::int64_t Chain::holdsThrough(const OrientationPlace& first,
                                 const OrientationPlace& last) const {
  if (first == last) return at(first).holdFrames;
  const std::int64_t start = holdsBefore(first);
  const std::int64_t end = holdsBefore(last) + at(last).holdFrames;
  return first <= last ? end - start : tree_.summary().holdFrames - start + end;
}

int Chain::sign(const OrientationPlace& place) const {
  int sign = tree_.summaryBefore(place.key).signs(1);
  const KeyRecord& r = record(place.key);
  for (std::size_t j = 0; j < place.orientation; ++j) {
    sign = SignMap::of(r.sections[j].link)(sign);
  }
  return sign;
}

int Chain::linkSign(const OrientationPlace& place) const {
  switch (at(place).link) {
    case SignLink::kKeep:
      return 1;
    case SignLink::kFlip:
      return -1;
    case SignLink::kReset:
      break;
  }
  return sign(place);
}

int Chain::signBetween(const OrientationPlace& first, const OrientationPlace& last) const {
  if (first == last) return 1;
  if (first < last) return sign(first) * sign(last);
  const OrientationPlace end{keys() - 1, record(keys() - 1).sections.size() - 1};
  return sign(first) * sign(end) * linkSign(end) * sign(last);
}

PathSection Chain::pathSection(const OrientationPlace& place, int startSign, int linkSign) const {
  const KeyRecord& r = record(place.key);
  const SectionRecord& s = r.sections[place.orientation];
  PathSection p;
  p.start = signedBy(startSign, s.q);
  p.end = signedBy(startSign * linkSign, s.qEnd);
  p.work = s.work;
  p.hold = s.kind == SectionKind::kHold;
  p.tracking = s.tracking && method_.tracks;
  if (p.tracking) {
    p.aim = s.aim;
    p.rollStart = s.roll * (std::numbers::pi / 180.0);
    p.rollChange = s.rollChange * (std::numbers::pi / 180.0);
    p.curve = &r.piece->curve;
    p.length = r.piece->length;
  }
  return p;
}

LinkSigns Chain::linkSigns(const OrientationPlace& place, const Neighbours& beside) const {
  const auto signOf = [&](const OrientationPlace& p) {
    return static_cast<std::int8_t>(linkSign(p));
  };
  LinkSigns signs;
  signs.own = signOf(place);
  if (beside.previous) signs.previous = signOf(*beside.previous);
  if (beside.next) signs.next = signOf(*beside.next);
  return signs;
}

bool Chain::signsDependOnChain(const OrientationPlace& place, const Neighbours& beside) const {
  const auto resets = [&](const OrientationPlace& p) { return at(p).link == SignLink::kReset; };
  return resets(place) || (beside.previous && resets(*beside.previous)) ||
         (beside.next && resets(*beside.next));
}

PathInput Chain::pathInput(const OrientationPlace& place, const Neighbours& beside) const {
  PathInput in;
  const int own = linkSign(place);
  in.section = pathSection(place, 1, own);
  const OrientationPlace end = after(place);
  if (const auto& p = beside.previous) {
    const OrientationPlace joint = after(*p);
    const int link = linkSign(*p);
    in.previous = pathSection(*p, signBetween(joint, place) * link, link);
    in.restsBefore = holdsThrough(joint, place) > 0;
  } else {
    in.restsBefore = holdsThrough({0, 0}, place) > 0;
  }
  if (const auto& n = beside.next) {
    in.next = pathSection(*n, own * signBetween(end, *n), linkSign(*n));
    in.restsAfter = holdsThrough(end, *n) > 0;
  } else {
    const std::size_t lastKey = keys() - 1;
    const OrientationPlace last{lastKey, record(lastKey).sections.size() - 1};
    in.restsAfter = holdsThrough(end, last) > 0;
  }
  return in;
}

}  // namespace vides
