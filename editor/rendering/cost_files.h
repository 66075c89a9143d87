// Reads and saves studies of `bpt cost`. The functions return why they failed.
#pragma once

#include <QString>
#include <optional>

#include "editor/rendering/cost_study.h"

namespace editor {

/// Reads the JSON of a study; nothing after a problem.
std::optional<CostStudy> read_cost_file(const QString& path, QString& problem);

/// Saves a study whose JSON is in `study`, with its table, figure and reference beside it, by the extension:
/// svg, png or pdf (the figure), csv (the table), or json, with its reference so that it can be continued.
/// Returns an empty text, or the problem.
QString save_cost_file(const QString& study, const QString& path);

}  // namespace editor
