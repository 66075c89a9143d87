// The catalogue's hard cases that take longer than seconds.
#include <gtest/gtest.h>

#include "tests/stability/hard_case.h"

namespace test {
namespace {

class LongStability : public testing::TestWithParam<HardCase> {};

TEST_P(LongStability, BoundHoldsAndNaiveCodeFails) { expect_holds(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Catalogue, LongStability, testing::ValuesIn(cases_of_length(true)),
                         [](const auto& instance) { return test_name(instance.param); });

}  // namespace
}  // namespace test
