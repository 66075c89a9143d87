#include "tests/reflectance/scheme_cases.h"

#include <stdexcept>

#include "grf/read.h"

namespace test {

reflectance::Scheme scheme_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_pdf(text, "test", diagnostics);
  if (!model || !grf::check(*model, reflectance::scheme_infos(), "PDF", diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
  return *reflectance::make_scheme(*model);
}

}  // namespace test
