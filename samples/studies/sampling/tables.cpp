#include "samples/studies/sampling/tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace study {
namespace {

/// Appends a row of means to a table of several rows.
class Means {
 public:
  void add(const std::vector<double>& values) {
    sums_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) sums_[i] += values[i];
    ++count_;
  }
  std::vector<double> values() const {
    std::vector<double> means;
    for (const double sum : sums_) means.push_back(sum / count_);
    return means;
  }

 private:
  std::vector<double> sums_;
  int count_ = 0;
};

std::vector<std::string> row_of(const std::string& name, const std::vector<double>& values) {
  std::vector<std::string> row = {name};
  for (const double value : values) row.push_back(figure(value));
  return row;
}

/// Makes a table of numbers with a row per BRDF and one of means.
template <class ValuesOf>
std::string table_with_means(const Results& results, const std::vector<std::string>& header,
                             const ValuesOf& values_of) {
  Table table(header);
  Means means;
  for (const CaseResult& one : results.cases) {
    const std::vector<double> values = values_of(one);
    table.add(row_of(one.subject->name, values));
    means.add(values);
  }
  table.add(row_of("mean", means.values()));
  return table.str();
}

std::string words_for(const FactorParameters& p) {
  return fmt::format("{}x{} {} {} {}", p.rows, p.columns, p.j, p.k, p.half ? "half" : "direction");
}

}  // namespace

std::string build_table(const Results& results) {
  return table_with_means(results,
                          {"seconds", "60, thesis", "60 `reject`", "60 `warp`", "90, thesis", "90 `reject`",
                           "90 `warp`", "thesis / `warp`", "factors, thesis", "factors", "factors as found"},
                          [](const CaseResult& one) -> std::vector<double> {
                            const ThesisFigures& thesis = one.subject->thesis;
                            return {thesis.seconds_60,
                                    one.reject_60.seconds,
                                    one.warp_60.seconds,
                                    thesis.seconds_90,
                                    one.reject_90.seconds,
                                    one.warp_90.seconds,
                                    thesis.seconds_90 / one.warp_90.seconds,
                                    thesis.factored_seconds,
                                    one.factored.seconds,
                                    one.factored_found.seconds};
                          });
}

std::string tree_table(const Results& results) {
  std::vector<std::string> header = {"KB"};
  for (const double tries : TriesOfTable) {
    header.push_back(fmt::format("{}, thesis", tries));
    header.push_back(fmt::format("{}", tries));
  }
  return table_with_means(results, header, [](const CaseResult& one) {
    std::vector<double> values;
    for (std::size_t i = 0; i < TriesOfTable.size(); ++i) {
      values.push_back(one.subject->thesis.tree_kb[i]);
      values.push_back(kilobytes(one.tree_bytes[i]));
    }
    return values;
  });
}

std::string memory_table(const Results& results) {
  return table_with_means(results,
                          {"KB", "60, thesis", "60 `reject`", "60 `warp`", "90 `reject`", "90 `warp`",
                           "factors, thesis", "factors", "factors as found"},
                          [](const CaseResult& one) -> std::vector<double> {
                            const ThesisFigures& thesis = one.subject->thesis;
                            return {thesis.adaptive_kb,
                                    kilobytes(one.reject_60.bytes),
                                    kilobytes(one.warp_60.bytes),
                                    kilobytes(one.reject_90.bytes),
                                    kilobytes(one.warp_90.bytes),
                                    thesis.factored_kb,
                                    kilobytes(one.factored.bytes),
                                    kilobytes(one.factored_found.bytes)};
                          });
}

std::string factor_table(const Results& results) {
  Table table({"theta x phi, J, K, over", "thesis", "distance", "found", "distance", "found / thesis"});
  for (const CaseResult& one : results.cases) {
    table.add({one.subject->name, words_for(one.subject->thesis.factors), figure(one.factored_distance),
               words_for(one.found.parameters), figure(one.found.distance),
               figure(one.found.distance / one.factored_distance)});
  }
  return table.str();
}

std::string scheme_table(const Results& results) {
  Table table({"scheme", "build, s", "tables, KB", "sample and pdf, ns", "with value, ns", "deviation",
               "largest cosine fraction"});
  for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
    const auto mean_over = [&](const auto& value_of) {
      double sum = 0;
      for (const CaseResult& one : results.cases) sum += value_of(one.techniques[id]);
      return sum / static_cast<double>(results.cases.size());
    };
    double share = 0;
    for (const CaseResult& one : results.cases) share = std::max(share, one.techniques[id].cosine_fraction);
    table.add({std::string(TechniqueNames[id]),
               figure(mean_over([](const TechniqueResult& one) { return one.build_seconds; })),
               figure(mean_over([](const TechniqueResult& one) { return kilobytes(one.bytes); })),
               figure(mean_over([](const TechniqueResult& one) { return one.cost.with_pdf; })),
               figure(mean_over([](const TechniqueResult& one) { return one.cost.with_value; })),
               figure(mean_over([](const TechniqueResult& one) { return one.fit.deviation; })),
               figure(share)});
  }
  return table.str();
}

std::string sample_table(const Results& results) {
  std::vector<std::string> header = {"ns"};
  for (const std::string_view name : TechniqueNames) header.emplace_back(name);
  return table_with_means(results, header, [](const CaseResult& one) {
    std::vector<double> values;
    for (const TechniqueResult& technique : one.techniques) values.push_back(technique.cost.with_pdf);
    return values;
  });
}

std::string choice_table(const Results& results) {
  Table table({"BRDF", "GRF", "glossy", "deviation of `diffuse`", "`sphere`, best exponent",
               "`hemisphere`, best exponent"});
  const auto exponent = [](const TechniqueResult& one) {
    return one.scheme.substr(one.scheme.find('=') + 1);
  };
  for (const CaseResult& one : results.cases) {
    table.add({one.subject->name, '`' + one.subject->brdf + '`', one.is_glossy ? "yes" : "no",
               figure(one[Diffuse].fit.deviation), exponent(one[SphereBest]), exponent(one[HemisphereBest])});
  }
  return table.str();
}

std::string error_table(const Results& results, Light light, Points points) {
  std::vector<std::string> header = {points == Sobol ? "Sobol" : "independent"};
  for (const std::string_view name : TechniqueNames) header.emplace_back(name);
  Table table(header);
  for (const CaseResult& one : results.cases) {
    std::vector<double> errors;
    for (const TechniqueResult& technique : one.techniques) {
      errors.push_back(technique.error(light, points, MostSamples).value());
    }
    // The least of the generic ones is bold.
    const auto best = std::min_element(errors.begin(), errors.begin() + Own) - errors.begin();
    std::vector<std::string> row = row_of(one.subject->name + (one.is_glossy ? "*" : ""), errors);
    std::string& least = row[static_cast<std::size_t>(best) + 1];
    least = "**" + least + "**";
    table.add(row);
  }
  return table.str();
}

std::string points_table(const Results& results) {
  std::vector<std::string> header = {"independent / Sobol"};
  for (const std::string_view name : TechniqueNames) header.emplace_back(name);
  Table table(header);
  for (const Light light : LightsByWeight) {
    std::vector<double> gains;
    for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
      gains.push_back(geometric_mean(results.cases, [&](const CaseResult& one) {
        const TechniqueResult& technique = one.techniques[id];
        const double sobol = technique.error(light, Sobol, MostSamples).value();
        return sobol > 0 ? technique.error(light, Independent, MostSamples).value() / sobol : 1.0;
      }));
    }
    table.add(row_of(std::string(LightNames[light]), gains));
  }
  return table.str();
}

std::string errors_csv(const Results& results) {
  std::string text = "brdf,scheme,view_degrees,points";
  for (const std::string_view light : LightNames) {
    for (const int count : SampleCounts) text += fmt::format(",{}_{}", light, count);
  }
  text += '\n';
  for (const CaseResult& one : results.cases) {
    for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
      for (std::size_t points = 0; points < PointNames.size(); ++points) {
        for (std::size_t view = 0; view < ViewDegrees.size(); ++view) {
          text += fmt::format("{},{},{},{}", one.subject->name, TechniqueNames[id], ViewDegrees[view],
                              PointNames[points]);
          for (const auto& of_light : one.techniques[id].errors[points][view]) {
            for (const Error& error : of_light) text += fmt::format(",{:.3g}", error.value());
          }
          text += '\n';
        }
      }
    }
  }
  return text;
}

std::string tables_csv(const Results& results) {
  std::string text = "brdf,scheme,quantity,value,thesis\n";
  for (const CaseResult& one : results.cases) {
    const std::string& name = one.subject->name;
    const ThesisFigures& thesis = one.subject->thesis;
    const auto add = [&](const std::string& scheme, const char* quantity, double value,
                         const std::string& printed) {
      text += fmt::format("{},{},{},{:.6g},{}\n", name, scheme, quantity, value, printed);
    };
    const auto add_trees = [&](const std::string& scheme, const TableCost& cost, double seconds, double kb) {
      add(scheme, "build_seconds", cost.seconds, fmt::format("{}", seconds));
      add(scheme, "kb", kilobytes(cost.bytes), kb > 0 ? fmt::format("{}", kb) : "");
    };
    add_trees("60 reject", one.reject_60, thesis.seconds_60, thesis.adaptive_kb);
    add_trees("90 reject", one.reject_90, thesis.seconds_90, 0);
    add_trees("60 warp", one.warp_60, thesis.seconds_60, thesis.adaptive_kb);
    add_trees("90 warp", one.warp_90, thesis.seconds_90, 0);
    add_trees(scheme_text(thesis.factors), one.factored, thesis.factored_seconds, thesis.factored_kb);
    add(scheme_text(thesis.factors), "distance", one.factored_distance, "");
    for (std::size_t i = 0; i < TriesOfTable.size(); ++i) {
      add(fmt::format("one tree nmax={}", TriesOfTable[i]), "kb", kilobytes(one.tree_bytes[i]),
          fmt::format("{}", thesis.tree_kb[i]));
    }
    for (const TechniqueResult& technique : one.techniques) {
      const auto add_own = [&](const char* quantity, double value) {
        add(technique.scheme, quantity, value, "");
      };
      add_own("cosine_share", technique.cosine_fraction);
      add_own("build_and_cover_seconds", technique.build_seconds);
      add_own("kb", kilobytes(technique.bytes));
      add_own("sample_and_density_ns", technique.cost.with_pdf);
      add_own("sample_and_value_ns", technique.cost.with_value);
      add_own("distance", technique.fit.distance);
      add_own("deviation", technique.fit.deviation);
    }
  }
  return text;
}

}  // namespace study
