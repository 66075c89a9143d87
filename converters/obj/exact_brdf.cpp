#include "converters/obj/exact_brdf.h"

#include <algorithm>
#include <set>

#include "grf/diagnostics.h"
#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/scene.h"

namespace convert {
namespace {

/// Returns the distinct words of a text that may name definitions.
std::set<std::string> identifiers_of(std::string_view text) {
  std::set<std::string> names;
  while (!text.empty()) {
    const auto* const end = std::find_if_not(text.begin(), text.end(), grf::is_word_character);
    const std::string word(text.begin(), end);
    if (grf::is_identifier(word)) names.insert(word);
    text.remove_prefix(std::max<std::size_t>(word.size(), 1));
  }
  return names;
}

/// The name of the BRDF among the definitions of its terms; no encoded name is equal to it.
constexpr std::string_view OwnName = "$combine";

}  // namespace

std::optional<grf::BrdfModel> read_exact_brdf(std::string_view text,
                                              const std::function<bool(const std::string&)>& is_known) {
  grf::Diagnostics ignored_diagnostics;
  const std::string_view keyword = text.substr(0, text.find(' '));
  if (keyword != "combine" && grf::layer_names(keyword).empty()) {
    return grf::read_brdf(std::string(text), "comment", ignored_diagnostics);
  }
  // A `combine` is only valid in the scope of its terms, and so are layers.
  std::string scene = "def ";
  for (const std::string& name : identifiers_of(text)) {
    if (is_known(name)) scene += name + " = brdf diffuse\n";
  }
  scene.append(OwnName).append(" = brdf ").append(text).append("\nbegin end");
  const auto read = grf::read_text(scene, "comment", ignored_diagnostics);
  if (!read || read->contents.blocks.size() != 1) return std::nullopt;
  const auto* scope = std::get_if<grf::DefinitionScope>(&read->contents.blocks.front().content);
  if (scope == nullptr || scope->definitions.back().name != OwnName) return std::nullopt;
  return std::get<grf::BrdfModel>(scope->definitions.back().body);
}

}  // namespace convert
