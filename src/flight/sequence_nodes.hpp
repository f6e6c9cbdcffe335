// SPDX-License-Identifier: MIT
// The nodes of a shared sequence (flight/shared_sequence.hpp): what they hold, and how they are
// made of items or of other nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace vides {

template <class T, class Summary>
struct SequenceNodes {
  static constexpr std::size_t kMost = 32;  // items in a leaf, children of an inner node
  static constexpr std::size_t kLeast = 8;

  // Nodes keep everything in place, what a search reads first and close together: looking up an
  // item in a long sequence is waiting for memory, line after line.
  struct Node {
    std::size_t width = 0;  // items or children
    bool leaf = true;
    Summary total;
  };
  using NodePointer = std::shared_ptr<const Node>;
  struct Slot {
    std::int64_t index = 0;  // index() of the sum before the item
    T item{};
  };
  struct Leaf : Node {
    std::array<Slot, kMost> slots{};
    std::array<Summary, kMost> before{};  // sums before each item
  };
  struct Inner : Node {
    std::array<std::int64_t, kMost> index{};      // index() of the sum before each child
    std::array<std::size_t, kMost + 1> starts{};  // of the children, and one past the last
    std::array<NodePointer, kMost> children{};
    std::array<Summary, kMost> before{};  // sums before each child

    std::size_t childOf(std::size_t i) const {
      const auto last = starts.begin() + static_cast<std::ptrdiff_t>(this->width);
      const auto at = std::upper_bound(starts.begin() + 1, last, i);
      return static_cast<std::size_t>(at - starts.begin()) - 1;
    }
  };
  static const Leaf& leafOf(const Node& node) { return static_cast<const Leaf&>(node); }
  static const Inner& innerOf(const Node& node) { return static_cast<const Inner&>(node); }
  static std::size_t sizeOf(const Node& node) {
    return node.leaf ? node.width : innerOf(node).starts[node.width];
  }
  static std::span<const Slot> slotsOf(const Node& node) {
    return std::span(leafOf(node).slots).first(node.width);
  }
  static std::span<const NodePointer> childrenOf(const Node& node) {
    return std::span(innerOf(node).children).first(node.width);
  }

  template <class Item>
  static NodePointer makeNode(std::span<const Item> items) {
    auto node = std::make_shared<Leaf>();
    for (const Item& item : items) {
      const std::size_t i = node->width++;
      node->slots[i].index = node->total.index();
      if constexpr (std::is_same_v<Item, Slot>) {
        node->slots[i].item = item.item;
      } else {
        node->slots[i].item = item;
      }
      node->before[i] = node->total;
      node->total = node->total + Summary::of(node->slots[i].item);
    }
    return node;
  }
  static NodePointer makeNode(std::span<const NodePointer> children) {
    auto node = std::make_shared<Inner>();
    node->leaf = false;
    for (const NodePointer& child : children) {
      const std::size_t i = node->width++;
      node->index[i] = node->total.index();
      node->starts[i + 1] = node->starts[i] + sizeOf(*child);
      node->children[i] = child;
      node->before[i] = node->total;
      node->total = node->total + child->total;
    }
    return node;
  }

  // The nodes of one level over all of `parts`, evenly filled.
  template <class Part>
  static std::vector<NodePointer> makeLevel(std::span<const Part> parts) {
    const std::size_t count = (parts.size() + kMost - 1) / kMost;
    std::vector<NodePointer> level;
    level.reserve(count);
    for (std::size_t g = 0; g < count; ++g) {
      const std::size_t first = g * parts.size() / count;
      const std::size_t last = (g + 1) * parts.size() / count;
      level.push_back(makeNode(parts.subspan(first, last - first)));
    }
    return level;
  }
};

}  // namespace vides
