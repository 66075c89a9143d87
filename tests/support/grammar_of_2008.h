#pragma once

#include <string>
#include <string_view>

namespace test {

/// Recognizes the grammar of GRF of 2008 (`grf-format`, section 2, without what is marked as an extension)
/// independently of the parser. Returns an empty text if the GRF text is in that grammar, and else what was
/// expected where. Models may have any keyword and any names of parameters. Names are not looked up.
std::string difference_from_grammar_of_2008(std::string_view text);

}  // namespace test
