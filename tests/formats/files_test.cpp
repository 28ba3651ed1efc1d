#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <string>

#include "formats/folder.h"
#include "formats/formats.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::Folder;

TEST(WholeFile, ComesBackByteForByte) {
  const Folder folder;
  std::string bytes;
  for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * 7);
  write_whole_file(folder / "a.bin", bytes);
  EXPECT_EQ(read_whole_file(folder / "a.bin").value, bytes);
  write_whole_file(folder / "a.bin", "short");
  EXPECT_EQ(read_whole_file(folder / "a.bin").value, "short");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(WholeFile, LeavesNothingBehindWhenItCannotBeWritten) {
  const Folder folder;
  fs::create_directory(folder / "taken");
  folder.write("file", "old");
  for (const fs::path& target : {folder / "taken", folder / "missing/a.svg", folder / "file/a.svg", folder / ""}) try {
      write_whole_file(target, "new");
      ADD_FAILURE() << target;
    } catch (const BadInput& bad) {
      EXPECT_EQ(bad.finding().code, "file.cannot-create");
      EXPECT_EQ(bad.finding().fault, Fault::cannot_create);
      EXPECT_FALSE(bad.finding().remedy.empty());
    }
  EXPECT_EQ(folder.entries(), 2u);
  EXPECT_EQ(contents(folder / "file"), "old");
}

TEST(WholeFile, LeavesTheOldFileWhenThereIsNoRoom) {
  const Folder folder;
  folder.write("file", "old");
  // The largest size a file may have stands in for a full disk.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit tight = before;
  tight.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  std::string code;
  try {
    write_whole_file(folder / "file", std::string(5000, 'x'));
  } catch (const BadInput& bad) {
    code = bad.finding().code;
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(code, "file.cannot-create");
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_EQ(contents(folder / "file"), "old");
}

}  // namespace
}  // namespace toile
