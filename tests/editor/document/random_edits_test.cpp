// Fuzzes a document with thousands of random edits, undos, redos, saves, reloads, late results and external
// file changes, and compares it with a model of plain values after each.
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/editor/document/random_session.h"
#include "tests/support/thoroughness.h"

namespace editor {
namespace {

/// An operation and the seed of its choices, so that a sequence stays valid if some are left out.
struct Operation {
  std::size_t kind = 0;
  std::uint32_t seed = 0;
};

const std::vector<RandomOperation>& all_operations() {
  static const std::vector<RandomOperation> all = [] {
    std::vector<RandomOperation> operations;
    for (const auto& group : {face_operations(), object_operations(), file_operations()}) {
      operations.insert(operations.end(), group.begin(), group.end());
    }
    return operations;
  }();
  return all;
}

std::string problem_of(const std::vector<Operation>& operations) {
  RandomSession session;
  for (const Operation& operation : operations) {
    session.random.seed(operation.seed);
    all_operations()[operation.kind].run(session);
    std::string problem = session.modelled.check();
    if (!problem.empty()) return problem;
  }
  return {};
}

/// Removes operations that are not needed for the failure, and prints the rest.
std::string story_of(std::vector<Operation> operations) {
  for (std::size_t i = operations.size(); i-- > 0;) {
    std::vector<Operation> fewer = operations;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!problem_of(fewer).empty()) operations = std::move(fewer);
  }
  std::string story;
  for (const Operation& each : operations) {
    story += fmt::format("{} ({})\n", all_operations()[each.kind].name, each.seed);
  }
  return story + problem_of(operations);
}

TEST(RandomEdits, LeaveADocumentAsPlainValuesSay) {
  const std::uint32_t sessions = test::tries_all() ? 3000 : 150;
  for (std::uint32_t seed = 1; seed <= sessions; ++seed) {
    std::mt19937 random(seed);
    std::vector<Operation> operations(60);
    for (Operation& each : operations) {
      each = {random() % all_operations().size(), static_cast<std::uint32_t>(random())};
    }
    ASSERT_TRUE(problem_of(operations).empty()) << "session " << seed << "\n" << story_of(operations);
  }
}

}  // namespace
}  // namespace editor
