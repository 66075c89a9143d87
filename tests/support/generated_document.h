#pragma once

#include <string>

namespace test {

/// Checks what stands in a document between the marks of a test's program, `<!-- generated: NAME -->` and
/// `<!-- end -->`; with GRANADA_UPDATE_DOCUMENTS in the environment, writes it. The path is from the
/// project's folder.
void expect_generated(const std::string& document, const std::string& program, const std::string& expected);

}  // namespace test
