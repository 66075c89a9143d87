#include "editor/brdf/brdf_list.h"

#include <QComboBox>

#include "editor/brdf/terms_editor.h"
#include "editor/controls/form_widgets.h"

namespace editor {

QComboBox* new_brdf_list(const QString& accessible_name, QWidget* parent) {
  return narrow_list(accessible_name, TermsEditor::tr("A BRDF that the scene defines"), 6, parent);
}

void fill_brdf_list(QComboBox& list, const std::vector<QString>& names, const QString& chosen) {
  list.clear();
  for (const QString& name : names) list.addItem(name);
  if (!chosen.isEmpty() && list.findText(chosen, Qt::MatchFixedString) < 0) list.addItem(chosen);
  list.setCurrentIndex(chosen.isEmpty() ? -1 : list.findText(chosen, Qt::MatchFixedString));
}

}  // namespace editor
