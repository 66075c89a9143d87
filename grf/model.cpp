#include "grf/model.h"

#include <array>

#include "grf/keywords.h"

namespace grf {
namespace {

constexpr std::array<std::string_view, 2> LayerNames = {"base", "top"};

}  // namespace

bool operator==(const Argument& a, const Argument& b) {
  return same_keyword(a.name, b.name) && a.value == b.value;
}

bool operator==(const Word& a, const Word& b) { return same_keyword(a.text, b.text); }

bool operator==(const Model& a, const Model& b) {
  return same_keyword(a.keyword, b.keyword) && a.arguments == b.arguments;
}

bool is_bare_word(const BrdfModel& brdf) {
  return brdf.arguments.empty() && brdf.terms.empty() && brdf.data_file.empty() && brdf.instance_file.empty();
}

std::span<const std::string_view> layer_names(std::string_view keyword) {
  const std::span names(LayerNames);
  return names.first(same_keyword(keyword, "coat") ? 1 : same_keyword(keyword, "layer") ? 2 : 0);
}

bool is_layered(const BrdfModel& brdf) { return !brdf.terms.empty() && !layer_names(brdf.keyword).empty(); }

bool is_bare_word(const PdfModel& pdf) { return pdf.arguments.empty(); }

}  // namespace grf
