#include "command_line/report_document.h"

#include <gtest/gtest.h>

namespace {

command_line::ReportDocument document() {
  command_line::ReportDocument document;
  document.add_heading(1, "Fit of a<b>_c.csv");
  document.add_paragraph("1 < 2 & 3 * 4");
  document.add_code("def a = 1 < 2\n  end\n");
  document.add_table({{"model", "error"}, {"a|b", "0.1 %"}});
  document.add_picture("fit-1.svg", "Lobes");
  return document;
}

TEST(ReportDocument, IsMarkdown) {
  EXPECT_EQ(document().markdown(),
            "# Fit of a\\<b\\>\\_c.csv\n"
            "\n"
            "1 \\< 2 & 3 \\* 4\n"
            "\n"
            "    def a = 1 < 2\n"
            "      end\n"
            "\n"
            "| model | error |\n"
            "|---|---:|\n"
            "| a\\|b | 0.1 % |\n"
            "\n"
            "![Lobes](fit-1.svg)\n");
}

TEST(ReportDocument, IsHtml) {
  const std::string html = document().html();
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n"));
  EXPECT_NE(html.find("<title>Fit of a&lt;b&gt;_c.csv</title>"), std::string::npos) << html;
  EXPECT_NE(html.find("<body>\n"
                      "<h1>Fit of a&lt;b&gt;_c.csv</h1>\n"
                      "<p>1 &lt; 2 &amp; 3 * 4</p>\n"
                      "<pre>def a = 1 &lt; 2\n  end\n</pre>\n"
                      "<table>\n"
                      "<tr><th>model</th><th>error</th></tr>\n"
                      "<tr><td>a|b</td><td>0.1 %</td></tr>\n"
                      "</table>\n"
                      "<p><img src=\"fit-1.svg\" alt=\"Lobes\"></p>\n"
                      "</body>\n</html>\n"),
            std::string::npos)
      << html;
}

}  // namespace
