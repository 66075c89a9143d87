#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/catalogue.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace studies {

/// The state of a study tool: its settings and what it studies. As text it is a line for each:
///
///   // comment
///   tool subdivision nmax=2 depth=8
///   def paint = brdf ward sx=0.1 sy=0.1
///   brdf combine 0.5 paint
///   pdf adaptive
///   file samples.fit
///
/// The first line names the tool. BRDFs, sampling schemes and definitions of BRDFs are written as in GRF, a
/// file's name reaches to the end of its line and is relative to the state's own file.
struct ToolState {
  grf::Model settings;  ///< the tool's name as keyword, and the values of its settings
  std::optional<grf::Model> distribution;
  std::vector<grf::Definition> definitions;  ///< of BRDFs, for the terms of a `combine`
  std::vector<grf::BrdfModel> brdfs;
  std::vector<grf::PdfModel> pdfs;

  struct File {
    std::string path;  ///< resolved
    grf::SourceLocation location;

    bool operator==(const File&) const = default;
  };
  std::vector<File> files;

  bool operator==(const ToolState&) const = default;
};

/// Parses a state; messages and the paths of files use the path. Checks the syntax only: settings are checked
/// by the tool. Returns nothing after an error.
std::optional<ToolState> read_state(const std::string& text, const std::string& path,
                                    grf::Diagnostics& diagnostics);

/// Sets one of the settings, by its name.
void set_value(grf::Model& settings, std::string_view name, grf::Value value);

/// Formats a state. Paths are written relative to the file that the text will be in; absolute if that is
/// empty.
std::string to_text(const ToolState& state, const std::string& path = {});

}  // namespace studies
