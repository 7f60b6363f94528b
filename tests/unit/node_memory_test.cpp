#include "tracer/scene/node_memory.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <thread>
#include <vector>

namespace durer {
namespace {

// Filled with a number of its own.
struct Node {
  explicit Node(uint64_t number) { figures.fill(number); }
  std::array<uint64_t, 13> figures;
  bool holds(uint64_t number) const {
    return figures == Node(number).figures;
  }
};

TEST(NodeMemory, NodesKeepWhatTheyHoldWhileOthersComeAndGo) {
  std::mt19937_64 random(3);
  std::vector<std::pair<uint64_t, std::shared_ptr<Node>>> nodes;
  for (uint64_t i = 0; i < 200000; ++i) {
    if (random() % 3 && !nodes.empty()) {
      const size_t gone = random() % nodes.size();
      ASSERT_TRUE(nodes[gone].second->holds(nodes[gone].first));
      nodes[gone] = nodes.back();
      nodes.pop_back();
    }
    nodes.emplace_back(i, make_node<Node>(i));
  }
  for (const auto& [number, node] : nodes) ASSERT_TRUE(node->holds(number));
}

TEST(NodeMemory, AllSizesAreAlignedAndApart) {
  std::vector<std::pair<unsigned char*, size_t>> pieces;
  for (size_t size = 1; size < 5000; size += 7) {
    auto* const memory = static_cast<unsigned char*>(take_node_memory(size));
    EXPECT_EQ(reinterpret_cast<uintptr_t>(memory) % kNodeAlignment, 0u);
    std::fill_n(memory, size, static_cast<unsigned char>(size));
    pieces.emplace_back(memory, size);
  }
  for (const auto& [memory, size] : pieces) {
    for (size_t i = 0; i < size; ++i) ASSERT_EQ(memory[i], static_cast<unsigned char>(size));
    give_node_memory(memory, size);
  }
}

TEST(NodeMemory, OtherThreadsLetGoOfWhatThisOneMade) {
  std::vector<std::shared_ptr<Node>> nodes;
  std::thread maker([&] {
    for (uint64_t i = 0; i < 20000; ++i) nodes.push_back(make_node<Node>(i));
  });
  maker.join();
  std::vector<std::thread> threads;
  for (uint64_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (uint64_t i = t; i < nodes.size(); i += 4) {
        EXPECT_TRUE(nodes[i]->holds(i));
        nodes[i].reset();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace durer
