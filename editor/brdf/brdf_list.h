#pragma once

#include <QString>
#include <vector>

class QComboBox;
class QWidget;

namespace editor {

/// Makes a list of the BRDFs that the scene defines.
QComboBox* new_brdf_list(const QString& accessible_name, QWidget* parent);

/// Fills the list and chooses a name, which is added if the scene does not define it; an empty one is none.
void fill_brdf_list(QComboBox& list, const std::vector<QString>& names, const QString& chosen);

}  // namespace editor
