// SPDX-License-Identifier: MIT
// A sequence whose copies share their structure, with sums over any prefix.
//
// A balanced tree of immutable nodes. Copying is O(1); set, insert and erase are O(log n) and leave
// every copy made before untouched, sharing all but the nodes on one path. Each node keeps the
// running sums of a Summary, so that "the item in which the sum reaches x" is found in O(log n).
// Any number of threads may read copies at the same time.
//
// Summary is an associative sum: a default constructor (the neutral element), operator+ and
// static Summary of(const T&). The tree's shape depends on the history of edits, so operator+ must
// be associative bit for bit (integers, not doubles).
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace vides {

template <class T, class Summary>
class SharedSequence {
 public:
  SharedSequence() = default;
  explicit SharedSequence(std::vector<T> items) { build(std::move(items)); }

  std::size_t size() const { return root_ ? root_->size() : 0; }
  bool empty() const { return size() == 0; }

  // i < size().
  const T& operator[](std::size_t i) const {
    assert(i < size());
    const Node* node = root_.get();
    while (!node->isLeaf()) {
      const std::size_t c = node->childOf(i);
      i -= node->starts[c];
      node = node->children[c].get();
    }
    return node->items[i];
  }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size() - 1]; }

  Summary summary() const { return root_ ? root_->total() : Summary{}; }
  // The sum over the items [0, i); i <= size().
  Summary summaryBefore(std::size_t i) const {
    assert(i <= size());
    Summary sum;
    const Node* node = root_.get();
    while (node != nullptr) {
      if (i >= node->size()) return sum + node->total();
      const std::size_t c = node->isLeaf() ? i : node->childOf(i);
      sum = sum + node->before[c];
      if (node->isLeaf()) break;
      i -= node->starts[c];
      node = node->children[c].get();
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
    Found found;
    const Node* node = root_.get();
    if (node == nullptr || !reached(node->total())) return {size(), summary(), nullptr};
    Summary base;
    while (true) {
      const auto first = node->before.begin() + 1;
      const auto at = std::partition_point(first, node->before.end() - 1,
                                           [&](const Summary& s) { return !reached(base + s); });
      const auto c = static_cast<std::size_t>(at - first);
      base = base + node->before[c];
      if (node->isLeaf()) {
        found.index += c;
        found.before = base;
        found.item = &node->items[c];
        return found;
      }
      found.index += node->starts[c];
      node = node->children[c].get();
    }
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
      root_ = makeLeaf({std::move(item)});
      return;
    }
    auto [left, right] = inserted(*root_, i, std::move(item));
    root_ = right ? makeInner({std::move(left), std::move(right)}) : std::move(left);
  }
  // i < size().
  void erase(std::size_t i) {
    assert(i < size());
    root_ = erased(*root_, i);
    while (root_ && !root_->isLeaf() && root_->children.size() == 1) {
      root_ = NodePointer(root_->children[0]);
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
      build(std::move(all));
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
  static constexpr std::size_t kMost = 32;  // items in a leaf, children of an inner node
  static constexpr std::size_t kLeast = 8;

  struct Node;
  using NodePointer = std::shared_ptr<const Node>;
  struct Node {
    std::vector<T> items;               // a leaf's
    std::vector<NodePointer> children;  // an inner node's
    std::vector<std::size_t> starts;    // of the children, and one past the last
    std::vector<Summary> before;        // sums before each item or child, and the total

    bool isLeaf() const { return children.empty(); }
    std::size_t size() const { return isLeaf() ? items.size() : starts.back(); }
    std::size_t width() const { return isLeaf() ? items.size() : children.size(); }
    const Summary& total() const { return before.back(); }
    std::size_t childOf(std::size_t i) const {
      const auto at = std::upper_bound(starts.begin() + 1, starts.end() - 1, i);
      return static_cast<std::size_t>(at - starts.begin()) - 1;
    }
  };

  static NodePointer makeLeaf(std::vector<T> items) {
    auto node = std::make_shared<Node>();
    node->before.reserve(items.size() + 1);
    node->before.emplace_back();
    for (const T& item : items) node->before.push_back(node->before.back() + Summary::of(item));
    node->items = std::move(items);
    return node;
  }
  static NodePointer makeInner(std::vector<NodePointer> children) {
    auto node = std::make_shared<Node>();
    node->before.reserve(children.size() + 1);
    node->starts.reserve(children.size() + 1);
    node->before.emplace_back();
    node->starts.push_back(0);
    for (const NodePointer& child : children) {
      node->before.push_back(node->before.back() + child->total());
      node->starts.push_back(node->starts.back() + child->size());
    }
    node->children = std::move(children);
    return node;
  }

  void build(std::vector<T> items) {
    root_.reset();
    if (items.empty()) return;
    std::vector<NodePointer> level;
    const auto groups = [](std::size_t n) { return (n + kMost - 1) / kMost; };
    const std::size_t leaves = groups(items.size());
    for (std::size_t g = 0; g < leaves; ++g) {
      const auto at = [&](std::size_t k) {
        return items.begin() + static_cast<std::ptrdiff_t>(k * items.size() / leaves);
      };
      level.push_back(
          makeLeaf({std::make_move_iterator(at(g)), std::make_move_iterator(at(g + 1))}));
    }
    while (level.size() > 1) {
      std::vector<NodePointer> upper;
      const std::size_t parents = groups(level.size());
      for (std::size_t g = 0; g < parents; ++g) {
        const auto at = [&](std::size_t k) {
          return level.begin() + static_cast<std::ptrdiff_t>(k * level.size() / parents);
        };
        upper.push_back(makeInner({at(g), at(g + 1)}));
      }
      level = std::move(upper);
    }
    root_ = level.front();
  }

  // The items from i on replaced by `items`, which must fit into the node.
  static NodePointer replaced(const Node& node, std::size_t i, std::span<const T> items) {
    if (node.isLeaf()) {
      std::vector<T> all = node.items;
      std::copy(items.begin(), items.end(), all.begin() + static_cast<std::ptrdiff_t>(i));
      return makeLeaf(std::move(all));
    }
    std::vector<NodePointer> children = node.children;
    for (std::size_t c = node.childOf(i); !items.empty(); ++c) {
      const std::size_t part = std::min(items.size(), node.starts[c + 1] - i);
      children[c] = replaced(*children[c], i - node.starts[c], items.first(part));
      items = items.subspan(part);
      i += part;
    }
    return makeInner(std::move(children));
  }

  template <class Items, class Make>
  static std::pair<NodePointer, NodePointer> splitIfFull(Items items, Make make) {
    if (items.size() <= kMost) return {make(std::move(items)), nullptr};
    const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    Items right(std::make_move_iterator(middle), std::make_move_iterator(items.end()));
    items.erase(middle, items.end());
    return {make(std::move(items)), make(std::move(right))};
  }

  static std::pair<NodePointer, NodePointer> inserted(const Node& node, std::size_t i, T item) {
    if (node.isLeaf()) {
      std::vector<T> items = node.items;
      items.insert(items.begin() + static_cast<std::ptrdiff_t>(i), std::move(item));
      return splitIfFull(std::move(items), [](std::vector<T> v) { return makeLeaf(std::move(v)); });
    }
    const std::size_t c = node.childOf(i);
    auto [left, right] = inserted(*node.children[c], i - node.starts[c], std::move(item));
    std::vector<NodePointer> children = node.children;
    children[c] = std::move(left);
    if (right) {
      children.insert(children.begin() + static_cast<std::ptrdiff_t>(c) + 1, std::move(right));
    }
    return splitIfFull(std::move(children),
                       [](std::vector<NodePointer> v) { return makeInner(std::move(v)); });
  }

  // Null where nothing is left.
  static NodePointer erased(const Node& node, std::size_t i) {
    if (node.isLeaf()) {
      if (node.items.size() == 1) return nullptr;
      std::vector<T> items = node.items;
      items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
      return makeLeaf(std::move(items));
    }
    const std::size_t c = node.childOf(i);
    std::vector<NodePointer> children = node.children;
    children[c] = erased(*node.children[c], i - node.starts[c]);
    if (!children[c]) {
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(c));
      if (children.empty()) return nullptr;
    } else if (children[c]->width() < kLeast && children.size() > 1) {
      joinNeighbours(children, c + 1 < children.size() ? c : c - 1);
    }
    return makeInner(std::move(children));
  }

  // Joins the children c and c + 1 and divides them again if they are too many for one node.
  static void joinNeighbours(std::vector<NodePointer>& children, std::size_t c) {
    const Node& left = *children[c];
    const Node& right = *children[c + 1];
    const auto join = [](auto a, const auto& b) {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    };
    auto [first, second] =
        left.isLeaf()
            ? splitIfFull(join(left.items, right.items),
                          [](std::vector<T> v) { return makeLeaf(std::move(v)); })
            : splitIfFull(join(left.children, right.children),
                          [](std::vector<NodePointer> v) { return makeInner(std::move(v)); });
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
    if (node.isLeaf()) {
      for (std::size_t i = first; i < std::min(last, node.items.size()); ++i) visit(node.items[i]);
      return;
    }
    for (std::size_t c = node.childOf(first); c < node.children.size(); ++c) {
      const std::size_t start = node.starts[c];
      if (start >= last) break;
      visitRange(*node.children[c], first > start ? first - start : 0, last - start, visit);
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
    if (!a.isLeaf() && !b.isLeaf() && a.starts == b.starts) {
      for (std::size_t c = 0; c < a.children.size(); ++c) {
        compare(*a.children[c], *b.children[c], base + a.starts[c], list);
      }
      return;
    }
    std::vector<const T*> left;
    left.reserve(a.size());
    auto collect = [&](const T& item) { left.push_back(&item); };
    visitRange(a, 0, a.size(), collect);
    std::size_t i = 0;
    auto check = [&](const T& item) {
      if (!(*left[i] == item)) note(list, base + i);
      ++i;
    };
    visitRange(b, 0, b.size(), check);
  }

  // The node that holds item i, as high up as it starts just there (from the front) or ends just
  // there (from the back).
  static const Node* highestStartingAt(const Node* node, std::size_t i) {
    while (i != 0 && !node->isLeaf()) {
      const std::size_t c = node->childOf(i);
      i -= node->starts[c];
      node = node->children[c].get();
    }
    return i == 0 ? node : nullptr;
  }
  static const Node* highestEndingAt(const Node* node, std::size_t end) {
    while (end != node->size() && !node->isLeaf()) {
      const std::size_t c = node->childOf(end - 1);
      end -= node->starts[c];
      node = node->children[c].get();
    }
    return end == node->size() ? node : nullptr;
  }
  // The size of a node that both trees share there, 0 if there is none.
  template <class Down>
  static std::size_t sharedSize(const Node* a, const Node* b, Down down) {
    while (a != nullptr && b != nullptr && a != b) {
      const Node*& larger = a->size() >= b->size() ? a : b;
      larger = larger->isLeaf() ? nullptr : down(*larger);
    }
    return a != nullptr && a == b ? a->size() : 0;
  }

  static std::size_t commonPrefix(const SharedSequence& a, const SharedSequence& b,
                                  std::size_t most) {
    std::size_t i = 0;
    while (i < most) {
      const std::size_t skip =
          sharedSize(highestStartingAt(a.root_.get(), i), highestStartingAt(b.root_.get(), i),
                     [](const Node& n) { return n.children.front().get(); });
      if (skip == 0 && !(a[i] == b[i])) break;
      i += std::max<std::size_t>(skip, 1);
    }
    return std::min(i, most);
  }
  static std::size_t commonSuffix(const SharedSequence& a, const SharedSequence& b,
                                  std::size_t most) {
    std::size_t n = 0;
    while (n < most) {
      const std::size_t skip =
          sharedSize(highestEndingAt(a.root_.get(), a.size() - n),
                     highestEndingAt(b.root_.get(), b.size() - n),
                     [](const Node& node) { return node.children.back().get(); });
      if (skip == 0 && !(a[a.size() - 1 - n] == b[b.size() - 1 - n])) break;
      n += std::max<std::size_t>(skip, 1);
    }
    return std::min(n, most);
  }

  NodePointer root_;
};

}  // namespace vides
