#include "command_line/report_document.h"

#include <string_view>

#include <fmt/format.h>

namespace command_line {
namespace {

std::string escaped_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string escaped_markdown(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// Returns a row of a table in Markdown.
std::string markdown_row(const ReportDocument::Row& row) {
  std::string text = "|";
  for (const std::string& cell : row) text += " " + escaped_markdown(cell) + " |";
  return text + "\n";
}

constexpr std::string_view Style =
    "body{font-family:sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.2em .6em;text-align:right}"
    "td:first-child,th:first-child{text-align:left}pre{background:#f3f3f3;padding:.6em;overflow:auto}"
    "img{max-width:100%}";

}  // namespace

std::string ReportDocument::markdown_of(const Heading& heading) {
  return std::string(static_cast<std::size_t>(heading.level), '#') + " " + escaped_markdown(heading.text) +
         "\n";
}
std::string ReportDocument::markdown_of(const Paragraph& paragraph) {
  return escaped_markdown(paragraph.text) + "\n";
}
std::string ReportDocument::markdown_of(const Code& code) {
  std::string text = "    ";
  for (std::size_t i = 0; i < code.text.size(); ++i) {
    text += code.text[i];
    if (code.text[i] == '\n' && i + 1 < code.text.size()) text += "    ";
  }
  return text.ends_with('\n') ? text : text + "\n";
}
std::string ReportDocument::markdown_of(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    text += markdown_row(table.rows[i]);
    if (i > 0) continue;
    text += "|---|";
    for (std::size_t column = 1; column < table.rows[0].size(); ++column) text += "---:|";
    text += "\n";
  }
  return text;
}
std::string ReportDocument::markdown_of(const Picture& picture) {
  return fmt::format("![{}]({})\n", escaped_markdown(picture.title), picture.file);
}

std::string ReportDocument::html_of(const Heading& heading) {
  return fmt::format("<h{0}>{1}</h{0}>\n", heading.level, escaped_html(heading.text));
}
std::string ReportDocument::html_of(const Paragraph& paragraph) {
  return fmt::format("<p>{}</p>\n", escaped_html(paragraph.text));
}
std::string ReportDocument::html_of(const Code& code) {
  return fmt::format("<pre>{}</pre>\n", escaped_html(code.text));
}
std::string ReportDocument::html_of(const Table& table) {
  std::string text = "<table>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const char* kind = i == 0 ? "th" : "td";
    text += "<tr>";
    for (const std::string& cell : table.rows[i])
      text += fmt::format("<{0}>{1}</{0}>", kind, escaped_html(cell));
    text += "</tr>\n";
  }
  return text + "</table>\n";
}
std::string ReportDocument::html_of(const Picture& picture) {
  return fmt::format("<p><img src=\"{}\" alt=\"{}\"></p>\n", escaped_html(picture.file),
                     escaped_html(picture.title));
}

std::string ReportDocument::markdown() const {
  std::string text;
  for (const auto& part : parts_) {
    if (!text.empty()) text += "\n";
    text += std::visit([](const auto& one) { return markdown_of(one); }, part);
  }
  return text;
}

std::string ReportDocument::html() const {
  std::string title = "Report";
  if (!parts_.empty()) {
    if (const auto* heading = std::get_if<Heading>(&parts_[0])) title = heading->text;
  }
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n"
      "<style>{}</style>\n</head>\n<body>\n",
      escaped_html(title), Style);
  for (const auto& part : parts_) text += std::visit([](const auto& one) { return html_of(one); }, part);
  return text + "</body>\n</html>\n";
}

}  // namespace command_line
