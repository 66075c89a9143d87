#include "renderer/job/job_file.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// An entry of an archive that is made by hand.
struct Entry {
  std::string name;
  std::string bytes;
  std::string link = "";  ///< target of a symbolic link
};

class JobFile : public testing::Test {
 protected:
  test::TemporaryFolder folder_;

  std::string archive_with(const std::vector<Entry>& entries) const {
    const std::string path = folder_.path("made.grfjob");
    archive* writer = archive_write_new();
    archive_write_set_format_pax_restricted(writer);
    EXPECT_EQ(archive_write_open_filename(writer, path.c_str()), ARCHIVE_OK);
    for (const Entry& entry : entries) {
      archive_entry* header = archive_entry_new();
      archive_entry_set_pathname(header, entry.name.c_str());
      archive_entry_set_size(header, static_cast<la_int64_t>(entry.bytes.size()));
      archive_entry_set_filetype(header, entry.link.empty() ? AE_IFREG : AE_IFLNK);
      if (!entry.link.empty()) archive_entry_set_symlink(header, entry.link.c_str());
      archive_write_header(writer, header);
      archive_write_data(writer, entry.bytes.data(), entry.bytes.size());
      archive_entry_free(header);
    }
    archive_write_free(writer);
    return path;
  }

  /// Unpacks into a new folder and returns the error; empty if there is none.
  std::string error_of(const std::string& path) const {
    const std::string to = folder_.path("unpacked");
    fs::remove_all(to);
    fs::create_directory(to);
    grf::Diagnostics diagnostics;
    const auto op_path = job::unpack_job(path, to, diagnostics);
    EXPECT_NE(op_path.has_value(), diagnostics.has_errors());
    EXPECT_TRUE(!op_path || op_path->starts_with(to));
    return diagnostics.to_text();
  }
};

TEST_F(JobFile, StaysInItsFolder) {
  EXPECT_EQ(error_of(archive_with({{"a/scene.op", "BPT_Scene x.grf\n"}, {"a/b/x.grf", ""}})), "");
  EXPECT_EQ(fs::file_size(folder_.path("unpacked/a/scene.op")), 16U);
  for (const char* name : {"../x.grf", "a/../../x.grf", "/tmp/x.grf", "a/..", "./x.grf"}) {
    const std::string error = error_of(archive_with({{"scene.op", ""}, {name, "bytes"}}));
    EXPECT_THAT(error, HasSubstr("it names a file outside of its folder")) << name;
    EXPECT_FALSE(fs::exists(folder_.path("x.grf"))) << name;
  }
  EXPECT_THAT(error_of(archive_with({{"scene.op", ""}, {"link", "", "/etc/passwd"}})),
              HasSubstr("'link' is not a regular file"));
  EXPECT_THAT(error_of(archive_with({{"scene.op", ""}, {"scene.op", "again"}})),
              HasSubstr("'scene.op' is damaged, or cannot be written"));
  EXPECT_THAT(error_of(archive_with({{"scene.grf", ""}})), HasSubstr("it is damaged, or no job file"));
}

TEST_F(JobFile, NamesNoFileOutsideOfItsFolder) {
  const auto error_with = [&](const std::string& op, const std::string& scene) {
    return error_of(archive_with({{"a/scene.op", op}, {"a/scene.grf", scene}}));
  };
  const std::string op = "BPT_Scene scene.grf\n";
  EXPECT_EQ(error_with(op, "include \"../b/../other.grf\"\n# \"quoted\" 'words'\n"), "");
  for (const char* scene :
       {"include \"/etc/passwd\"", "include \"../../x.grf\"", "brdf diffuse texture \"..\\..\\x.png\"",
        "# an odd \" quote\ninclude \"/etc/passwd\"", "\"a\" include \"b/../../../x.grf\""}) {
    EXPECT_THAT(error_with(op, scene), HasSubstr("outside of its folder")) << scene;
  }
  for (const char* line : {"BPT_Scene /etc/passwd\n", "BPT_Scene ../../x.grf\n",
                           "BPT_Scene scene.grf\nBPT_EM_Background /etc/x.exr\n"}) {
    EXPECT_THAT(error_with(line, ""), HasSubstr("outside of its folder")) << line;
  }
}

TEST_F(JobFile, KnowsWhichFilesAreInsideOfAFolder) {
  const std::string inside = folder_.add("top/a/file", "");
  const std::string outside = folder_.add("other", "");
  fs::create_symlink(outside, folder_.path("top/link"));
  EXPECT_TRUE(job::are_inside({inside, folder_.path("top/a/../a/file")}, folder_.path("top")));
  EXPECT_FALSE(job::are_inside({inside, outside}, folder_.path("top")));
  EXPECT_FALSE(job::are_inside({folder_.path("top/link")}, folder_.path("top")));
}

TEST_F(JobFile, ThatIsDamagedIsRefusedWithoutHarm) {
  std::ifstream file(
      archive_with({{"scene.op", std::string(3000, 'x')}, {"a/x.grf", std::string(3000, 'y')}}),
      std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (const std::size_t size : {0U, 100U, 512U, 2000U, 4000U, 5000U}) {
    EXPECT_NE(error_of(folder_.add("cut.grfjob", bytes.substr(0, size))), "") << size;
  }
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    std::string altered = bytes;
    for (int k = 0; k < 3; ++k) altered[random() % altered.size()] = static_cast<char>(random());
    error_of(folder_.add("altered.grfjob", altered));
  }
}

}  // namespace
