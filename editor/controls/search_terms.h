#pragma once

#include <QString>

namespace editor {

/// Tells whether `text` has every word of `query`, in any case. A word that begins a synonym from other
/// programs stands for the editor's term, too: "merge" finds "Append", "glossy" finds "roughness".
bool matches_search(const QString& text, const QString& query);

}  // namespace editor
