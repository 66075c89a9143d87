#pragma once

#include <string>
#include <variant>
#include <vector>

namespace command_line {

/// A document of headings, paragraphs, texts in a program's language, tables and pictures, which becomes
/// Markdown or a page of HTML. Texts are plain; what has a meaning in either format is escaped.
class ReportDocument {
 public:
  using Row = std::vector<std::string>;

  void add_heading(int level, std::string text) { parts_.emplace_back(Heading{level, std::move(text)}); }
  void add_paragraph(std::string text) { parts_.emplace_back(Paragraph{std::move(text)}); }
  void add_code(std::string text) { parts_.emplace_back(Code{std::move(text)}); }
  /// The first row has the titles.
  void add_table(std::vector<Row> rows) { parts_.emplace_back(Table{std::move(rows)}); }
  /// Adds a picture, a file beside the document.
  void add_picture(std::string file, std::string title) {
    parts_.emplace_back(Picture{std::move(file), std::move(title)});
  }

  std::string markdown() const;
  std::string html() const;

 private:
  struct Heading {
    int level;
    std::string text;
  };
  struct Paragraph {
    std::string text;
  };
  struct Code {
    std::string text;
  };
  struct Table {
    std::vector<Row> rows;
  };
  struct Picture {
    std::string file;
    std::string title;
  };

  static std::string markdown_of(const Heading& heading);
  static std::string markdown_of(const Paragraph& paragraph);
  static std::string markdown_of(const Code& code);
  static std::string markdown_of(const Table& table);
  static std::string markdown_of(const Picture& picture);
  static std::string html_of(const Heading& heading);
  static std::string html_of(const Paragraph& paragraph);
  static std::string html_of(const Code& code);
  static std::string html_of(const Table& table);
  static std::string html_of(const Picture& picture);

  std::vector<std::variant<Heading, Paragraph, Code, Table, Picture>> parts_;
};

}  // namespace command_line
