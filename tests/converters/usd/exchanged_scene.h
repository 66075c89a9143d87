// Scenes are written as USD and MaterialX for tests, and read again.
#pragma once

#include <string>
#include <vector>

#include "tests/converters/usd/mtlx_document.h"
#include "tests/converters/usd/usda_stage.h"
#include "tests/support/temporary_folder.h"

namespace convert {

class ExchangedScene {
 public:
  /// Writes GRF text; the OP text may be empty. Fails the test if that fails.
  explicit ExchangedScene(const std::string& grf, const std::string& op = {});
  /// Writes a scene likewise, with files beside it, by name.
  ExchangedScene(const std::string& grf, const std::string& op, const test::TemporaryFolder& files);

  const test::UsdaStage& usd() const { return usd_; }
  const test::MtlxDocument& mtlx() const { return mtlx_; }
  const std::string& usd_text() const { return usd_text_; }
  const std::string& mtlx_text() const { return mtlx_text_; }
  const std::string& usd_warnings() const { return usd_warnings_; }
  const std::string& mtlx_warnings() const { return mtlx_warnings_; }

 private:
  void write(const std::string& grf, const std::string& op);

  test::TemporaryFolder folder_;
  test::UsdaStage usd_;
  test::MtlxDocument mtlx_;
  std::string usd_text_;
  std::string mtlx_text_;
  std::string usd_warnings_;
  std::string mtlx_warnings_;
};

/// A mesh of a cube, with words before its list of vertices and before each of its faces.
std::string exchange_cube(const std::string& attributes, const std::vector<std::string>& of_faces);

}  // namespace convert
