#include "editor/brdf/parameter_rows.h"

#include <QVBoxLayout>
#include <algorithm>

#include "editor/brdf/parameter_row.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"

namespace editor {

ParameterRows::ParameterRows(QWidget* parent) : QWidget(parent), column_(tight_layout<QVBoxLayout>(this)) {}

void ParameterRows::add_rows() {
  int name_width = 4 * Grid;
  for (const grf::ParameterInfo& parameter : info_->parameters) {
    auto* row = new ParameterRow(parameter, info_->takes_maps, this);
    rows_.push_back(row);
    column_->addWidget(row);
    name_width = std::max(name_width, row->name_width());
    const auto set = [this, row](const grf::Value& value, bool is_done) {
      emit edited([&](grf::Model& model) { set_value(model, row->parameter(), value); }, is_done);
    };
    connect(row, &ParameterRow::changing, this, [set](const grf::Value& value) { set(value, false); });
    connect(row, &ParameterRow::edited, this, [set](const grf::Value& value) { set(value, true); });
    connect(row, &ParameterRow::map_edited, this, [this, row](const auto& map) {
      emit edited([&](grf::Model& model) { set_map(model, *info_, row->parameter(), map); }, true);
    });
    connect(row, &ParameterRow::reset, this, [this, row] {
      emit edited([row](grf::Model& model) { reset_value(model, row->parameter()); }, true);
    });
  }
  for (ParameterRow* row : rows_) {
    row->set_name_width(name_width);
    row->show();
  }
}

void ParameterRows::show_models(const grf::ModelInfo* info, const std::vector<const grf::Model*>& models) {
  if (info != info_) {
    info_ = info;
    for (ParameterRow* row : rows_) {
      row->hide();
      row->deleteLater();
    }
    rows_.clear();
    if (info_ != nullptr) add_rows();
  }
  for (ParameterRow* row : rows_) {
    std::vector<grf::Value> values;
    for (const grf::Model* model : models) values.push_back(value_of(*model, *info_, row->parameter()));
    const bool all_default = std::ranges::all_of(
        models, [row](const grf::Model* model) { return is_default(*model, row->parameter()); });
    row->show_values(values, all_default);
    std::vector<std::optional<grf::ParameterMap>> maps;
    for (const grf::Model* model : models) maps.push_back(map_of(*model, row->parameter()));
    row->show_maps(maps);
  }
}

void ParameterRows::show_errors(const std::vector<QString>& errors) {
  for (ParameterRow* row : rows_) {
    const QString begin = QString("'%1' of ").arg(text_of(row->parameter().name));
    const auto found =
        std::ranges::find_if(errors, [&](const QString& mistake) { return mistake.startsWith(begin); });
    row->set_message(found == errors.end() ? QString() : *found);
  }
}

}  // namespace editor
