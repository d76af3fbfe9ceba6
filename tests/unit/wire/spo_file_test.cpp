#include "common/wire/spo_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>
#include <sstream>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/answer_get.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "common/wire/spo_index.hpp"
#include "common/wire/spo_writer.hpp"
#include "common/wire/stream_messages.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;

const SourceInfo kSource{"mm", "piece.off", 0x1234, ""};

std::string read_bytes(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

class SpoFileTest : public testing::Test {
 protected:
  SpoFileTest() { fs::create_directories(folder_); }
  ~SpoFileTest() override { fs::remove_all(folder_); }

  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("spo_file_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
       std::to_string(::getpid()));
  const Octree tree_ = every_kind_tree();
  const std::string stream_ = encode_stream(tree_, kSource);
};

TEST_F(SpoFileTest, IsTheStreamAndAnIndex) {
  write_spo(folder_ / "a.spo", tree_, kSource);
  const std::string bytes = read_bytes(folder_ / "a.spo");
  EXPECT_EQ(bytes, encode_spo(tree_, kSource));
  EXPECT_EQ(bytes.substr(0, stream_.size()), stream_);
  EXPECT_EQ(bytes.substr(bytes.size() - 8), "spoctree");

  const SpoFile file(folder_ / "a.spo");
  EXPECT_EQ(file.frames(), stream_);
  EXPECT_EQ(file.frames_hash(), hash_bytes(stream_));
  EXPECT_TRUE(file.is_whole());
  EXPECT_EQ(file.level_count(), 3u);
  EXPECT_EQ(file.info(), open_header(frames_of(stream_)[0]));
  EXPECT_TRUE(are_equal(file.tree(), tree_));
  EXPECT_EQ(file.tree(2).levels.size(), 2u);
}

TEST_F(SpoFileTest, KnowsWhatEveryLevelCosts) {
  const std::string bytes = encode_spo(tree_, kSource);
  const SpoFile file(bytes, "bytes");
  StreamDecoder decoder;
  for (const FrameView& frame : frames_of(stream_)) decoder.accept(frame);
  EXPECT_EQ(file.level_bytes(), decoder.level_bytes());
  EXPECT_EQ(file.level_bytes().back().total_bytes, stream_.size());
}

TEST_F(SpoFileTest, IsWrittenTheSameByAClientThatReceivedAllFrames) {
  {
    SpoWriter writer(folder_ / "copy.spo");
    for (const FrameView& frame : frames_of(stream_)) writer.accept(frame);
    writer.commit();
  }
  EXPECT_EQ(read_bytes(folder_ / "copy.spo"), encode_spo(tree_, kSource));
}

TEST_F(SpoFileTest, OfAPartialFetchHoldsTheCompleteLevels) {
  const auto frames = frames_of(stream_);
  for (std::size_t count = 1; count < frames.size(); ++count) {
    const fs::path path = folder_ / "partial.spo";
    fs::remove(path);
    SpoWriter writer(path);
    for (std::size_t i = 0; i < count; ++i) writer.accept(frames[i]);
    const std::size_t levels = (count - 1) / 2;
    if (levels == 0) {
      EXPECT_THROW(writer.commit(), BadInput);
      continue;
    }
    writer.commit();
    const SpoFile file(path);
    EXPECT_FALSE(file.is_whole());
    EXPECT_EQ(file.info().level_count, 3u);
    EXPECT_EQ(file.level_count(), levels);
    EXPECT_EQ(file.frames(), stream_.substr(0, file.frames().size()));
    EXPECT_EQ(file.resume_point().hash, hash_bytes(file.frames()));
    EXPECT_EQ(validate(file.tree()), std::vector<std::string>{});
  }
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(SpoFileTest, IsNotThereWithoutCommit) {
  { SpoWriter(folder_ / "b.spo").accept(frames_of(stream_)[0]); }
  EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(SpoFileTest, GivesSlicesFromFrameBoundariesOnly) {
  const std::string bytes = encode_spo(tree_, kSource);
  const SpoFile file(bytes, "bytes");
  EXPECT_EQ(file.slice(0), stream_);
  EXPECT_EQ(file.slice(99), stream_);
  std::set<std::uint64_t> boundaries;
  for (const FrameView& frame : frames_of(stream_)) boundaries.insert(frame.offset);
  for (std::uint32_t levels = 1; levels <= 3; ++levels) {
    const std::uint64_t end = file.level_bytes()[levels - 1].total_bytes;
    for (std::uint64_t from = 0; from <= bytes.size(); ++from) {
      const auto slice = file.slice(levels, from);
      ASSERT_EQ(slice.has_value(), from < end && boundaries.contains(from)) << from;
      if (slice) {
        EXPECT_EQ(*slice, std::string_view(stream_).substr(from, end - from));
      }
    }
  }
  EXPECT_EQ(file.hash_before(0), hash_bytes(""));
  EXPECT_EQ(file.hash_before(stream_.size()), hash_bytes(stream_));
  EXPECT_EQ(file.hash_before(1), std::nullopt);
}

TEST_F(SpoFileTest, NamesTheFileThatIsNotOne) {
  const auto complaint = [&](std::string_view bytes) -> std::string {
    std::ofstream(folder_ / "x.spo", std::ios::binary) << bytes;
    try {
      SpoFile file(folder_ / "x.spo");
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  };
  const std::string name = (folder_ / "x.spo").string() + ": ";
  EXPECT_TRUE(complaint("").starts_with(name + "byte 0: no trailer"));
  EXPECT_TRUE(complaint("OFF\n8 6 0\n").starts_with(name));
  EXPECT_TRUE(complaint(stream_).starts_with(name + "byte " + std::to_string(stream_.size())));
  EXPECT_THROW(SpoFile(folder_ / "absent.spo"), BadInput);
  EXPECT_THROW(SpoFile{folder_}, BadInput);
}

TEST_F(SpoFileTest, RefusesAnIndexOfOtherFrames) {
  SpoIndex index{hash_bytes(stream_), {}};
  StreamDecoder decoder;
  for (const FrameView& frame : frames_of(stream_)) decoder.accept(frame);
  for (const LevelBytes& level : decoder.level_bytes()) {
    index.level_ends.push_back(level.total_bytes);
  }
  EXPECT_EQ(stream_ + seal_index(index), encode_spo(tree_, kSource));
  const auto is_refused = [&](const SpoIndex& bad) {
    const std::string bytes = stream_ + seal_index(bad);
    EXPECT_THROW(SpoFile(bytes, "bytes"), BadInput);
  };
  SpoIndex bad = index;
  bad.frames_hash ^= 1;
  is_refused(bad);
  bad = index;
  bad.level_ends[1] += 8;
  is_refused(bad);
  bad = index;
  bad.level_ends.erase(bad.level_ends.begin());
  is_refused(bad);
  bad = index;
  bad.level_ends.pop_back();
  is_refused(bad);
}

TEST_F(SpoFileTest, IsRecoveredUpToTheLastCompleteLevel) {
  const std::string bytes = encode_spo(tree_, kSource);
  const SpoFile file(bytes, "bytes");
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    const std::string_view recovered = recover_frames(std::string_view(bytes).substr(0, size));
    std::uint64_t expected = 0;
    for (const LevelBytes& level : file.level_bytes()) {
      if (level.total_bytes <= size) expected = level.total_bytes;
    }
    ASSERT_EQ(recovered.size(), expected) << size;
  }
  EXPECT_EQ(recover_frames("hello"), "");
}

class AnswerGet : public SpoFileTest {
 protected:
  ErrorCode code_of(const GetRequest& request) {
    return std::get<ErrorMessage>(answer_get(file_, request)).code;
  }
  const std::string bytes_ = encode_spo(tree_, kSource);
  const SpoFile file_{bytes_, "bytes"};
};

TEST_F(AnswerGet, SendsWhatIsAskedForAndNotHeld) {
  EXPECT_EQ(std::get<std::string_view>(answer_get(file_, {})), stream_);
  const std::uint64_t first = file_.level_bytes()[0].total_bytes;
  EXPECT_EQ(std::get<std::string_view>(answer_get(file_, {"", 1, {}})), stream_.substr(0, first));
  const ResumePoint held{first, hash_bytes(stream_.substr(0, first))};
  EXPECT_EQ(std::get<std::string_view>(answer_get(file_, {"", 0, held})), stream_.substr(first));
}

TEST_F(AnswerGet, SaysWhyItCannot) {
  const std::uint64_t first = file_.level_bytes()[0].total_bytes;
  const std::uint64_t hash = hash_bytes(stream_.substr(0, first));
  EXPECT_EQ(code_of({"", 0, {first, hash + 1}}), ErrorCode::ChangedModel);
  EXPECT_EQ(code_of({"", 0, {first + 8, hash}}), ErrorCode::BadOffset);
  EXPECT_EQ(code_of({"", 1, {first, hash}}), ErrorCode::BadOffset);
  EXPECT_EQ(code_of({"", 0, file_.resume_point()}), ErrorCode::BadOffset);
  EXPECT_EQ(code_of({"", 0, {UINT64_MAX, 0}}), ErrorCode::BadOffset);
}

}  // namespace
}  // namespace spoctree
