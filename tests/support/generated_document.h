#pragma once

#include <string>

namespace test {

/// Checks the text of a document between the marks of a test program, `<!-- generated: NAME -->` and
/// `<!-- end -->`; rewrites it if GRANADA_UPDATE_DOCUMENTS is set in the environment. The path is relative to
/// the project's folder.
void expect_generated(const std::string& document, const std::string& program, const std::string& expected);

}  // namespace test
