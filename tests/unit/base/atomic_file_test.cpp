// Files are whole or absent, whatever fails.
#include "common/base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <string>

#include "common/base/errors.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;

/// A directory of its own per test.
class AtomicFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "spoctree-atomic-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    directory = pattern;
  }
  void TearDown() override { fs::remove_all(directory); }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
  }
  static std::string contents(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }

  fs::path directory;
};

TEST_F(AtomicFileTest, HoldsEveryByteAfterCommit) {
  const std::string bytes("a\0b\r\n\xff", 6);
  const std::string many(3'000'000, 'x');
  {
    AtomicFile file(directory / "file");
    file.write(bytes);
    file.write({});
    file.write(many);
    EXPECT_FALSE(fs::exists(directory / "file"));
    file.commit();
  }
  EXPECT_EQ(contents(directory / "file"), bytes + many);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, LeavesNothingWithoutCommit) {
  { AtomicFile file(directory / "file"); }
  EXPECT_EQ(entries(), 0u);
  {
    AtomicFile file(directory / "file");
    file.write("half");
  }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(AtomicFileTest, KeepsTheOldFileUntilCommit) {
  write_file_atomically(directory / "file", "old");
  {
    AtomicFile file(directory / "file");
    file.write("new");
    EXPECT_EQ(contents(directory / "file"), "old");
  }
  EXPECT_EQ(contents(directory / "file"), "old");
  write_file_atomically(directory / "file", "new");
  EXPECT_EQ(contents(directory / "file"), "new");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, ReplacesTheFileThatALinkPointsTo) {
  write_file_atomically(directory / "file", "old");
  fs::create_symlink("file", directory / "link");
  write_file_atomically(directory / "link", "new");
  EXPECT_TRUE(fs::is_symlink(directory / "link"));
  EXPECT_EQ(contents(directory / "file"), "new");
  // A link to a file that is yet to be.
  fs::create_symlink("other", directory / "early");
  write_file_atomically(directory / "early", "new");
  EXPECT_TRUE(fs::is_symlink(directory / "early"));
  EXPECT_EQ(contents(directory / "other"), "new");
  EXPECT_EQ(entries(), 4u);
}

TEST_F(AtomicFileTest, IsTheSameUnderATemporaryName) {
  for (const auto storage : {AtomicFile::Storage::Unnamed, AtomicFile::Storage::Named}) {
    const fs::path path = directory / "file";
    {
      AtomicFile file(path, storage);
      file.write("half");
    }
    EXPECT_EQ(entries(), 0u);
    for (const char* const bytes : {"old", "new"}) {
      AtomicFile file(path, storage);
      file.write(bytes);
      file.commit();
      EXPECT_EQ(contents(path), bytes);
    }
    EXPECT_EQ(entries(), 1u);
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    EXPECT_EQ(status.st_mode & 0777, 0666 & ~mask);
    fs::remove(path);
  }
}

TEST_F(AtomicFileTest, SignalsLeaveNoTemporaryName) {
  for (const auto storage : {AtomicFile::Storage::Unnamed, AtomicFile::Storage::Named}) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      EXPECT_EXIT(
          {
            remove_temporary_files_on_signals();
            AtomicFile file(directory / "file", storage);
            file.write("half");
            std::raise(signal);
          },
          testing::KilledBySignal(signal), "");
      EXPECT_EQ(entries(), 0u);
    }
  }
}

TEST_F(AtomicFileTest, NamesThePathAndTheReasonWhereTheDirectoryFails) {
  write_file_atomically(directory / "file", "");
  const fs::path bad_paths[] = {directory / "absent" / "file", directory / "file" / "below",
                                directory / std::string(5000, 'n'), directory, ""};
  for (const fs::path& path : bad_paths) {
    try {
      write_file_atomically(path, "bytes");
      FAIL() << path;
    } catch (const BadInput& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path.string() + ": cannot ", 0), 0u)
          << error.what();
    }
  }
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, ReportsAFullDevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  try {
    write_file_atomically("/dev/full", "bytes");
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_EQ(std::string(error.what()).rfind("/dev/full: cannot write: ", 0), 0u) << error.what();
  }
  // More than any buffer holds: `write` itself fails, and the destructor must bear it.
  EXPECT_THROW(write_file_atomically("/dev/full", std::string(1 << 22, 'x')), BadInput);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFileTest, WritesDevicesAsTheyStand) {
  ASSERT_NO_THROW(write_file_atomically("/dev/null", "bytes"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, ReportsAFailedRename) {
  // The target becomes a directory while the file is written.
  AtomicFile file(directory / "file");
  file.write("bytes");
  fs::create_directories(directory / "file" / "below");
  EXPECT_THROW(file.commit(), BadInput);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, LetsTwoWritersOfOneFileBothSucceed) {
  AtomicFile one(directory / "file");
  AtomicFile other(directory / "file");
  one.write("one");
  other.write("other");
  one.commit();
  EXPECT_EQ(contents(directory / "file"), "one");
  other.commit();
  EXPECT_EQ(contents(directory / "file"), "other");
  EXPECT_EQ(entries(), 1u);
}

}  // namespace
}  // namespace spoctree
