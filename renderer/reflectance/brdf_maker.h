#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// Makes the BRDFs of a scene. Each file of measured data is loaded once.
class BrdfMaker {
 public:
  explicit BrdfMaker(grf::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Makes a BRDF, with names looked up in the scope, or returns nothing after an error.
  std::optional<Brdf> make(const grf::BrdfModel& data, const grf::Scope& scope);

  /// Returns the terms of a sum, nested sums expanded and weights of 0 left out, or the model itself; and
  /// those of the BRDFs that layers consist of, after the layered model. Reads no data.
  std::vector<const grf::BrdfModel*> models_of(const grf::BrdfModel& data, const grf::Scope& scope);

  /// Returns the paths of the data files that a BRDF uses.
  std::vector<std::string> data_files_of(const grf::BrdfModel& data, const grf::Scope& scope);

  /// Returns a cache key that is equal for equal BRDFs.
  std::string identity(const grf::BrdfModel& data, const grf::Scope& scope);

 private:
  std::optional<Brdf> make_summand(const grf::BrdfModel& data);
  std::optional<Brdf> make_layered(const grf::BrdfModel& data, const grf::Scope& scope);
  std::optional<Brdf> make_term(const grf::BrdfModel& data, std::size_t term, const grf::Scope& scope);
  void warn_of_glass(const Brdf& part, const grf::BrdfModel& whole);
  template <class Model>
  std::shared_ptr<const typename Model::Data> data_of(const grf::BrdfModel& data);

  grf::Diagnostics& diagnostics_;
  /// The cache maps the model's keyword and the file's canonical path to the data that were loaded.
  std::map<std::pair<std::string_view, std::string>, std::shared_ptr<const void>> loaded_;
  std::size_t layers_ = 0;  ///< above the BRDF that is being made
};

}  // namespace reflectance
