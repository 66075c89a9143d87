#pragma once

#include <QJsonObject>
#include <optional>

namespace editor {

/// Returns a number of a JSON object; empty if it has none of that name, or null.
inline std::optional<double> number_in(const QJsonObject& object, const char* name) {
  const QJsonValue value = object.value(QLatin1String(name));
  return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

}  // namespace editor
