#include "grf/model.h"

#include "grf/keywords.h"

namespace grf {

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

bool is_bare_word(const PdfModel& pdf) { return pdf.arguments.empty(); }

}  // namespace grf
