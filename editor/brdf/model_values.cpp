#include "editor/brdf/model_values.h"

#include <QDir>
#include <QFileInfo>
#include <QStringList>
#include <algorithm>

#include "editor/brdf/model_form.h"
#include "editor/controls/expression.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

grf::Value default_of(const grf::ParameterInfo& parameter) {
  switch (parameter.kind) {
    case grf::ParameterKind::Boolean:
      return parameter.default_value != 0;
    case grf::ParameterKind::Word:
      return grf::Word{std::string(parameter.choices[static_cast<std::size_t>(parameter.default_value)])};
    case grf::ParameterKind::Number:
    case grf::ParameterKind::Reflectance:
      break;
  }
  if (parameter.default_rgb) return *parameter.default_rgb;
  return parameter.default_value;
}

}  // namespace

grf::Value value_of(const grf::Model& model, const grf::ModelInfo& info,
                    const grf::ParameterInfo& parameter) {
  const grf::Argument* argument = grf::find_argument(model, parameter);
  if (argument == nullptr && !parameter.default_from.empty()) {
    if (const auto* source = info.find(parameter.default_from)) argument = grf::find_argument(model, *source);
  }
  if (argument == nullptr) return default_of(parameter);
  const auto* number = std::get_if<float>(&argument->value);
  if (number != nullptr && parameter.kind == grf::ParameterKind::Boolean) return *number != 0;
  return argument->value;
}

bool is_default(const grf::Model& model, const grf::ParameterInfo& parameter) {
  return grf::find_argument(model, parameter) == nullptr;
}

void set_value(grf::Model& model, const grf::ParameterInfo& parameter, const grf::Value& value) {
  for (grf::Argument& argument : model.arguments) {
    if (!parameter.is_called(argument.name)) continue;
    argument.value = value;
    return;
  }
  model.arguments.push_back({std::string(parameter.name), value, model.location});
}

std::optional<grf::ParameterMap> map_of(const grf::Model& model, const grf::ParameterInfo& parameter) {
  const grf::Argument* argument = grf::find_argument(model, parameter);
  return argument == nullptr ? std::nullopt : argument->map;
}

void set_map(grf::Model& model, const grf::ModelInfo& info, const grf::ParameterInfo& parameter,
             const std::optional<grf::ParameterMap>& map) {
  if (!map && is_default(model, parameter)) return;
  const grf::Value value = value_of(model, info, parameter);
  const bool hides = map && (value == grf::Value(0.0F) || value == grf::Value(grf::Colour(0)));
  set_value(model, parameter, hides ? grf::Value(std::min(1.0F, parameter.maximum)) : value);
  for (grf::Argument& argument : model.arguments) {
    if (!parameter.is_called(argument.name)) continue;
    argument.map = map;
    if (!map || !model.location.file) continue;
    // The name is relative to the file that has the BRDF, so that both can be moved together.
    argument.location = model.location;
    const QFileInfo scene(QString::fromStdString(model.location.file->path));
    const QString file = QString::fromStdString(map->file);
    if (QFileInfo(file).isAbsolute())
      argument.map->file = scene.absoluteDir().relativeFilePath(file).toStdString();
  }
}

void reset_value(grf::Model& model, const grf::ParameterInfo& parameter) {
  std::erase_if(model.arguments,
                [&](const grf::Argument& argument) { return parameter.is_called(argument.name); });
}

QString text_of(const grf::Value& value) {
  if (const auto* number = std::get_if<float>(&value)) return number_text(*number);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* word = std::get_if<grf::Word>(&value)) return QString::fromStdString(word->text);
  const auto& rgb = std::get<grf::Colour>(value);
  return QString("(%1, %2, %3)").arg(number_text(rgb.x), number_text(rgb.y), number_text(rgb.z));
}

QString help_of(const grf::ParameterInfo& parameter) {
  QStringList lines = {
      QString("<b>%1</b>: %2").arg(text_of(parameter.name), text_of(parameter.help).toHtmlEscaped())};
  if (parameter.kind == grf::ParameterKind::Number || parameter.kind == grf::ParameterKind::Reflectance) {
    const bool has_maximum = parameter.maximum < 1e30F;
    lines << (has_maximum ? BrdfForm::tr("From %1 to %2")
                                .arg(number_text(parameter.minimum), number_text(parameter.maximum))
                          : BrdfForm::tr("%1 or more").arg(number_text(parameter.minimum))) +
                 (parameter.unit.empty() ? QString() : " " + text_of(parameter.unit)) +
                 (parameter.kind == grf::ParameterKind::Reflectance
                      ? BrdfForm::tr(", a number or RGB (linear)")
                      : "");
  }
  lines << BrdfForm::tr("Default: %1")
               .arg(parameter.default_from.empty()
                        ? text_of(default_of(parameter))
                        : BrdfForm::tr("that of %1").arg(text_of(parameter.default_from)));
  return lines.join("<br>");
}

}  // namespace editor
