// SPDX-License-Identifier: MIT
// A sequence whose copies share their structure, with sums over any prefix.
//
// A balanced tree of immutable nodes. Copying is O(1); set, insert and erase are O(log n) and leave
// every copy made before untouched, sharing all but the nodes on one path. Each node keeps the
// running sums of a Summary, so that "the item in which the sum reaches x" is found in O(log n).
// Any number of threads may read copies at the same time.
//
// Summary is an associative sum: a default constructor (the neutral element), operator+, static
// Summary of(const T&), and std::int64_t index() const, a part of the sum that never decreases and
// by which items are found. The tree's shape depends on the history of edits, so operator+ must be
// associative bit for bit (integers, not doubles).
// (a + b).index() is a.index() + b.index(), or, where a.addsUp() is false, at most kIndexSlack away
// from it.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "flight/fetch.hpp"
#include "flight/sequence_nodes.hpp"

namespace vides {

template <class T, class Summary>
class SharedSequence {
 public:
  SharedSequence() = default;
  explicit SharedSequence(std::span<const T> items) { build(items); }
  explicit SharedSequence(const std::vector<T>& items) { build(items); }

  std::size_t size() const { return root_ ? sizeOf(*root_) : 0; }
  bool empty() const { return size() == 0; }

  // i < size().
  const T& operator[](std::size_t i) const {
    assert(i < size());
    const Node* node = root_.get();
    while (!node->leaf) {
      const Inner& inner = innerOf(*node);
      const std::size_t c = inner.childOf(i);
      i -= inner.starts[c];
      node = inner.children[c].get();
    }
    return leafOf(*node).slots[i].item;
  }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size() - 1]; }

  Summary summary() const { return root_ ? root_->total : Summary{}; }
  // The sum over the items [0, i); i <= size().
  Summary summaryBefore(std::size_t i) const {
    assert(i <= size());
    Summary sum;
    const Node* node = root_.get();
    while (node != nullptr) {
      if (i >= sizeOf(*node)) return sum + node->total;
      if (node->leaf) return sum + leafOf(*node).before[i];
      const Inner& inner = innerOf(*node);
      const std::size_t c = inner.childOf(i);
      sum = sum + inner.before[c];
      i -= inner.starts[c];
      node = inner.children[c].get();
    }
    return sum;
  }

  struct Found {
    std::size_t index = 0;  // size() if there is none
    Summary before;         // the sum over [0, index)
    const T* item = nullptr;
  };
  // The first item i for which `reached`(sum over [0, i]) holds; `reached` must stay true once
  // true.
  template <class Predicate>
  Found find(Predicate reached) const {
    if (!root_ || !reached(root_->total)) return {size(), summary(), nullptr};
    return descend([&](const Node& node, const Summary& base) {
      const auto& before = node.leaf ? leafOf(node).before : innerOf(node).before;
      const auto first = before.begin() + 1;
      const auto last = before.begin() + static_cast<std::ptrdiff_t>(node.width);
      const auto at =
          std::partition_point(first, last, [&](const Summary& s) { return !reached(base + s); });
      return static_cast<std::size_t>(at - first);
    });
  }
  // The first item i at which the index() of the sum over [0, i] is greater than `value`; the same
  // as find, but reads little memory.
  Found findIndex(std::int64_t value) const {
    if (!root_ || !(root_->total.index() > value)) return {size(), summary(), nullptr};
    return descend([value](const Node& node, const Summary& base) {
      const std::int64_t rest = value - base.index();
      const std::int64_t slack = base.addsUp() ? 0 : Summary::kIndexSlack;
      const auto search = [&](const auto& list, const auto& before, auto index) {
        const auto last = list.begin() + static_cast<std::ptrdiff_t>(node.width);
        const auto at = std::partition_point(list.begin() + 1, last, [&](const auto& entry) {
          const std::int64_t i = index(entry);
          if (i <= rest - slack || i > rest + slack) return i <= rest;
          const auto k = static_cast<std::size_t>(&entry - list.data());
          return (base + before[k]).index() <= value;
        });
        return static_cast<std::size_t>(at - list.begin()) - 1;
      };
      return node.leaf ? search(leafOf(node).slots, leafOf(node).before,
                                [](const Slot& slot) { return slot.index; })
                       : search(innerOf(node).index, innerOf(node).before,
                                [](std::int64_t i) { return i; });
    });
  }

  // i < size().
  void set(std::size_t i, T item) {
    assert(i < size());
    root_ = replaced(*root_, i, std::span<const T>(&item, 1));
  }
  // i <= size().
  void insert(std::size_t i, T item) {
    assert(i <= size());
    if (!root_) {
      root_ = makeNode(std::span<const T>(&item, 1));
      return;
    }
    auto [left, right] = inserted(*root_, i, std::move(item));
    if (right) {
      const NodePointer both[] = {std::move(left), std::move(right)};
      root_ = makeNode(std::span<const NodePointer>(both));
    } else {
      root_ = std::move(left);
    }
  }
  // i < size().
  void erase(std::size_t i) {
    assert(i < size());
    root_ = erased(*root_, i);
    while (root_ && !root_->leaf && root_->width == 1) {
      root_ = NodePointer(innerOf(*root_).children[0]);
    }
  }
  // Replaces `count` items from `first` on by `items`.
  void replace(std::size_t first, std::size_t count, std::span<const T> items) {
    assert(first + count <= size());
    if (count + items.size() > 64 + size() / 8) {
      std::vector<T> all;
      all.reserve(size() - count + items.size());
      forEach(0, first, [&](const T& item) { all.push_back(item); });
      all.insert(all.end(), items.begin(), items.end());
      forEach(first + count, size(), [&](const T& item) { all.push_back(item); });
      build(all);
      return;
    }
    const std::size_t common = std::min(count, items.size());
    if (common > 0) root_ = replaced(*root_, first, items.first(common));
    for (std::size_t k = common; k < count; ++k) erase(first + common);
    for (std::size_t k = common; k < items.size(); ++k) insert(first + k, items[k]);
  }

  // Calls visit(item) for the items [first, last) in order.
  template <class Visit>
  void forEach(std::size_t first, std::size_t last, Visit visit) const {
    if (root_ && first < last) visitRange(*root_, first, last, visit);
  }
  template <class Visit>
  void forEach(Visit visit) const {
    forEach(0, size(), visit);
  }

  // Calls visit(i, sum over [0, i), item i) for the items whose own sum is `wanted`, in order.
  // `wanted` must be true of a sum as soon as it is of one of its terms; runs of which it isn't are
  // passed over at once.
  template <class Wanted, class Visit>
  void forEachWhere(Wanted wanted, Visit visit) const {
    if (root_) visitWhere(*root_, 0, Summary{}, wanted, visit);
  }

  // What differs between two sequences, by the items' operator==, in time proportional to what is
  // not shared. Of equal size: changed(first, last) for ranges of indices. Otherwise one range is
  // replaced by another.
  struct Change {
    std::size_t first = 0;    // in both
    std::size_t oldLast = 0;  // one past the end in the old sequence
    std::size_t newLast = 0;  // and in the new one
  };
  static std::vector<Change> changes(const SharedSequence& from, const SharedSequence& to) {
    std::vector<Change> list;
    if (from.root_ == to.root_) return list;
    if (from.size() == to.size()) {
      if (from.root_) compare(*from.root_, *to.root_, 0, list);
      return list;
    }
    const std::size_t shorter = std::min(from.size(), to.size());
    const std::size_t prefix = commonPrefix(from, to, shorter);
    const std::size_t suffix = commonSuffix(from, to, shorter - prefix);
    list.push_back({prefix, from.size() - suffix, to.size() - suffix});
    return list;
  }

  bool operator==(const SharedSequence& other) const {
    return size() == other.size() && changes(*this, other).empty();
  }

 private:
  using Nodes = SequenceNodes<T, Summary>;
  using Node = typename Nodes::Node;
  using Slot = typename Nodes::Slot;
  using Leaf = typename Nodes::Leaf;
  using Inner = typename Nodes::Inner;
  using NodePointer = typename Nodes::NodePointer;
  static constexpr std::size_t kMost = Nodes::kMost;
  static constexpr std::size_t kLeast = Nodes::kLeast;
  static const Leaf& leafOf(const Node& node) { return Nodes::leafOf(node); }
  static const Inner& innerOf(const Node& node) { return Nodes::innerOf(node); }
  static std::size_t sizeOf(const Node& node) { return Nodes::sizeOf(node); }
  static std::span<const Slot> slotsOf(const Node& node) { return Nodes::slotsOf(node); }
  static std::span<const NodePointer> childrenOf(const Node& node) {
    return Nodes::childrenOf(node);
  }
  template <class Part>
  static NodePointer makeNode(std::span<const Part> parts) {
    return Nodes::makeNode(parts);
  }
  template <class Part>
  static std::vector<NodePointer> makeLevel(std::span<const Part> parts) {
    return Nodes::makeLevel(parts);
  }

  // `choose`(node, sum before the node) is the child or item to go to.
  template <class Choose>
  Found descend(Choose choose) const {
    Found found;
    const Node* node = root_.get();
    while (true) {
      const std::size_t c = choose(*node, found.before);
      if (node->leaf) {
        found.item = &leafOf(*node).slots[c].item;
        found.before = found.before + leafOf(*node).before[c];
        found.index += c;
        return found;
      }
      const Inner& inner = innerOf(*node);
      node = inner.children[c].get();
      fetch(node, sizeof(Node) + kMost * sizeof(Slot));
      found.before = found.before + inner.before[c];
      found.index += inner.starts[c];
    }
  }
  void build(std::span<const T> items) {
    root_.reset();
    if (items.empty()) return;
    std::vector<NodePointer> level = makeLevel(items);
    while (level.size() > 1) level = makeLevel(std::span<const NodePointer>(level));
    root_ = level.front();
  }

  // A node's parts as a list that can be edited, and one or two nodes of them again.
  template <class Part>
  static std::vector<Part> listOf(std::span<const Part> parts) {
    std::vector<Part> list;
    list.reserve(2 * kMost);
    list.assign(parts.begin(), parts.end());
    return list;
  }
  template <class Part>
  static std::pair<NodePointer, NodePointer> oneOrTwo(const std::vector<Part>& list) {
    const std::span<const Part> parts(list);
    if (parts.size() <= kMost) return {makeNode(parts), nullptr};
    const std::size_t half = parts.size() / 2;
    return {makeNode(parts.first(half)), makeNode(parts.subspan(half))};
  }

  // The items from i on replaced by `items`, which must fit into the node.
  static NodePointer replaced(const Node& node, std::size_t i, std::span<const T> items) {
    if (node.leaf) {
      std::array<Slot, kMost> slots = leafOf(node).slots;
      for (const T& item : items) slots[i++].item = item;
      return makeNode(std::span<const Slot>(slots).first(node.width));
    }
    const Inner& inner = innerOf(node);
    std::array<NodePointer, kMost> children = inner.children;
    for (std::size_t c = inner.childOf(i); !items.empty(); ++c) {
      const std::size_t part = std::min(items.size(), inner.starts[c + 1] - i);
      children[c] = replaced(*children[c], i - inner.starts[c], items.first(part));
      items = items.subspan(part);
      i += part;
    }
    return makeNode(std::span<const NodePointer>(children).first(node.width));
  }

  static std::pair<NodePointer, NodePointer> inserted(const Node& node, std::size_t i, T item) {
    if (node.leaf) {
      std::vector<Slot> slots = listOf(slotsOf(node));
      slots.insert(slots.begin() + static_cast<std::ptrdiff_t>(i), Slot{0, std::move(item)});
      return oneOrTwo(slots);
    }
    const Inner& inner = innerOf(node);
    const std::size_t c = inner.childOf(i);
    auto [left, right] = inserted(*inner.children[c], i - inner.starts[c], std::move(item));
    std::vector<NodePointer> children = listOf(childrenOf(node));
    children[c] = std::move(left);
    if (right) {
      children.insert(children.begin() + static_cast<std::ptrdiff_t>(c) + 1, std::move(right));
    }
    return oneOrTwo(children);
  }

  // Null where nothing is left.
  static NodePointer erased(const Node& node, std::size_t i) {
    if (node.leaf) {
      if (node.width == 1) return nullptr;
      std::vector<Slot> slots = listOf(slotsOf(node));
      slots.erase(slots.begin() + static_cast<std::ptrdiff_t>(i));
      return makeNode(std::span<const Slot>(slots));
    }
    const Inner& inner = innerOf(node);
    const std::size_t c = inner.childOf(i);
    std::vector<NodePointer> children = listOf(childrenOf(node));
    children[c] = erased(*children[c], i - inner.starts[c]);
    if (!children[c]) {
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(c));
      if (children.empty()) return nullptr;
    } else if (children[c]->width < kLeast && children.size() > 1) {
      joinNeighbours(children, c + 1 < children.size() ? c : c - 1);
    }
    return makeNode(std::span<const NodePointer>(children));
  }

  // Joins the children c and c + 1 and divides them again if they are too many for one node.
  static void joinNeighbours(std::vector<NodePointer>& children, std::size_t c) {
    const NodePointer left = children[c];
    const NodePointer right = children[c + 1];
    const auto join = [](auto a, auto b) {
      auto list = listOf(a);
      list.insert(list.end(), b.begin(), b.end());
      return oneOrTwo(list);
    };
    auto [first, second] = left->leaf ? join(slotsOf(*left), slotsOf(*right))
                                      : join(childrenOf(*left), childrenOf(*right));
    children[c] = std::move(first);
    const auto next = children.begin() + static_cast<std::ptrdiff_t>(c) + 1;
    if (second) {
      *next = std::move(second);
    } else {
      children.erase(next);
    }
  }

  template <class Visit>
  static void visitRange(const Node& node, std::size_t first, std::size_t last, Visit& visit) {
    if (node.leaf) {
      const std::span<const Slot> slots = slotsOf(node);
      for (std::size_t i = first; i < std::min(last, slots.size()); ++i) visit(slots[i].item);
      return;
    }
    const Inner& inner = innerOf(node);
    for (std::size_t c = inner.childOf(first); c < node.width; ++c) {
      const std::size_t start = inner.starts[c];
      if (start >= last) break;
      visitRange(*inner.children[c], first > start ? first - start : 0, last - start, visit);
    }
  }

  template <class Wanted, class Visit>
  static void visitWhere(const Node& node, std::size_t first, const Summary& before,
                         const Wanted& wanted, Visit& visit) {
    if (!wanted(node.total)) return;
    for (std::size_t c = 0; c < node.width; ++c) {
      if (!node.leaf) {
        const Inner& inner = innerOf(node);
        visitWhere(*inner.children[c], first + inner.starts[c], before + inner.before[c], wanted,
                   visit);
      } else if (const T& item = leafOf(node).slots[c].item; wanted(Summary::of(item))) {
        visit(first + c, before + leafOf(node).before[c], item);
      }
    }
  }

  static void note(std::vector<Change>& list, std::size_t i) {
    if (!list.empty() && list.back().newLast == i) {
      ++list.back().oldLast;
      ++list.back().newLast;
    } else {
      list.push_back({i, i + 1, i + 1});
    }
  }

  // Nodes over the same range of indices.
  static void compare(const Node& a, const Node& b, std::size_t base, std::vector<Change>& list) {
    if (&a == &b) return;
    if (!a.leaf && !b.leaf && a.width == b.width && innerOf(a).starts == innerOf(b).starts) {
      for (std::size_t c = 0; c < a.width; ++c) {
        compare(*innerOf(a).children[c], *innerOf(b).children[c], base + innerOf(a).starts[c],
                list);
      }
      return;
    }
    std::vector<const T*> left;
    left.reserve(sizeOf(a));
    auto collect = [&](const T& item) { left.push_back(&item); };
    visitRange(a, 0, sizeOf(a), collect);
    std::size_t i = 0;
    auto check = [&](const T& item) {
      if (!(*left[i] == item)) note(list, base + i);
      ++i;
    };
    visitRange(b, 0, sizeOf(b), check);
  }

  // The node that starts at item i (ends before item `end`), as high up as there is one.
  static const Node* highestStartingAt(const Node* node, std::size_t i) {
    while (i != 0 && !node->leaf) {
      const std::size_t c = innerOf(*node).childOf(i);
      i -= innerOf(*node).starts[c];
      node = innerOf(*node).children[c].get();
    }
    return i == 0 ? node : nullptr;
  }
  static const Node* highestEndingAt(const Node* node, std::size_t end) {
    while (end != sizeOf(*node) && !node->leaf) {
      const std::size_t c = innerOf(*node).childOf(end - 1);
      end -= innerOf(*node).starts[c];
      node = innerOf(*node).children[c].get();
    }
    return end == sizeOf(*node) ? node : nullptr;
  }
  // The size of a node that both trees share there, 0 if there is none.
  template <class Down>
  static std::size_t sharedSize(const Node* a, const Node* b, Down down) {
    while (a != nullptr && b != nullptr && a != b) {
      const Node*& larger = sizeOf(*a) >= sizeOf(*b) ? a : b;
      larger = larger->leaf ? nullptr : down(childrenOf(*larger));
    }
    return a != nullptr && a == b ? sizeOf(*a) : 0;
  }

  static std::size_t commonPrefix(const SharedSequence& a, const SharedSequence& b,
                                  std::size_t most) {
    std::size_t i = 0;
    while (i < most) {
      const std::size_t skip =
          sharedSize(highestStartingAt(a.root_.get(), i), highestStartingAt(b.root_.get(), i),
                     [](auto children) { return children.front().get(); });
      if (skip == 0 && !(a[i] == b[i])) break;
      i += std::max<std::size_t>(skip, 1);
    }
    return std::min(i, most);
  }
  static std::size_t commonSuffix(const SharedSequence& a, const SharedSequence& b,
                                  std::size_t most) {
    std::size_t n = 0;
    while (n < most) {
      const std::size_t skip = sharedSize(highestEndingAt(a.root_.get(), a.size() - n),
                                          highestEndingAt(b.root_.get(), b.size() - n),
                                          [](auto children) { return children.back().get(); });
      if (skip == 0 && !(a[a.size() - 1 - n] == b[b.size() - 1 - n])) break;
      n += std::max<std::size_t>(skip, 1);
    }
    return std::min(n, most);
  }

  NodePointer root_;
};

}  // namespace vides
