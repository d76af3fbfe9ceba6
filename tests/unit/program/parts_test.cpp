// The small parts of the programs: addresses, sources, names of files, numbers as text.

#include <gtest/gtest.h>

#include <filesystem>

#include "client/commands/level_files.hpp"
#include "client/source/source_name.hpp"
#include "client/source/throttle.hpp"
#include "common/base/errors.hpp"
#include "common/program/remaining_time.hpp"
#include "common/report/json_text.hpp"
#include "common/report/level_rows.hpp"
#include "common/report/text_table.hpp"
#include "common/wire/address.hpp"
#include "common/wire/percent_text.hpp"

namespace spoctree {
namespace {

TEST(ParseAddress, TakesHostsNumbersAndPorts) {
  EXPECT_EQ(parse_address("localhost:80"), (Address{"localhost", 80}));
  EXPECT_EQ(parse_address("10.1.2.3:0"), (Address{"10.1.2.3", 0}));
  EXPECT_EQ(parse_address("[::1]:65535"), (Address{"::1", 65535}));
  EXPECT_EQ(parse_address("[fe80::1]"), (Address{"fe80::1", 7762}));
  EXPECT_EQ(parse_address("example.org"), (Address{"example.org", 7762}));
}

TEST(ParseAddress, RejectsEverythingElse) {
  for (const char* text : {"", ":80", "host:", "host:x", "host:65536", "host:-1", "host:+1",
                           "host:80 ", "::1", "::1:80", "[::1", "[::1]80", "[]:80", "a\nb:1"})
    EXPECT_THROW(parse_address(text), UsageError) << text;
}

TEST(ParseAddress, ReadsBackWhatToTextWrites) {
  for (const char* text : {"localhost:80", "[::1]:9"})
    EXPECT_EQ(to_text(parse_address(text)), text);
}

TEST(ParseSource, TellsServersFromFiles) {
  const auto remote = std::get<RemoteModel>(parse_source("spo://host:12/a b/c%2520%C3%a9"));
  EXPECT_EQ(remote.server, (Address{"host", 12}));
  EXPECT_EQ(remote.name, "a b/c%20\xc3\xa9");
  EXPECT_EQ(std::get<RemoteModel>(parse_source("spo://[::1]")).name, "");
  EXPECT_EQ(std::get<ModelFile>(parse_source("dir/spo.spo")).path, "dir/spo.spo");
}

TEST(ParseSource, RejectsOtherSchemesAndBadNames) {
  for (const char* text : {"http://host/x", "spo://", "spo:///x", "spo://h:1/a\x01", "spo://h/%",
                           "spo://h/a%4", "spo://h/%g0", "spo://h/%0a", "spo://h/%c3"})
    EXPECT_THROW(parse_source(text), UsageError) << text;
  for (const char* text : {"host:1", "spo://host:1/name", "file.spo"})
    EXPECT_THROW(parse_server(text), UsageError) << text;
}

TEST(PercentText, IsReadBackAsItWasWritten) {
  std::string every_byte;
  for (int byte = 0; byte < 256; ++byte) every_byte += static_cast<char>(byte);
  EXPECT_EQ(percent_decoded(percent_encoded(every_byte)), every_byte);
  EXPECT_EQ(percent_encoded("My Part-1.2_~50%/é"), "My%20Part-1.2_~50%25%2Fé");
  EXPECT_EQ(percent_decoded("%2fa%2F"), "/a/");
  for (const char* text : {"%", "%1", "a%", "%%41", "%x1", "%1x"})
    EXPECT_EQ(percent_decoded(text), std::nullopt) << text;
}

TEST(LevelFiles, NumberByPattern) {
  EXPECT_EQ(LevelFiles("a%d.svg", true, ".svg").name_of(12), "a12.svg");
  EXPECT_EQ(LevelFiles("a%03d.svg", true, ".svg").name_of(7), "a007.svg");
  EXPECT_EQ(LevelFiles("100%/a%02d", true, ".svg").name_of(7), "100%/a07");
  EXPECT_EQ(LevelFiles("a%d.svg", false, ".svg").name_of(3), "a3.svg");
}

TEST(LevelFiles, NumberInAFolder) {
  const auto folder = std::filesystem::temp_directory_path();
  EXPECT_EQ(LevelFiles(folder.string(), true, ".json").name_of(3), folder / "level-03.json");
  EXPECT_EQ(LevelFiles(folder.string(), false, ".json").name_of(3), folder / "level-03.json");
}

TEST(LevelFiles, OneNameIsForOneLevel) {
  EXPECT_EQ(LevelFiles("x.svg", false, ".svg").name_of(3), "x.svg");
  EXPECT_EQ(LevelFiles("no-extension", false, ".svg").name_of(3), "no-extension");
  EXPECT_EQ(LevelFiles("-", false, ".svg").name_of(3), "-");
  EXPECT_THROW(LevelFiles("x.svg", true, ".svg"), UsageError);
  EXPECT_THROW(LevelFiles("-", true, ".svg"), UsageError);
}

TEST(JsonText, EscapesWhatStringsMustNotHold) {
  EXPECT_EQ(quote_json("a\"b\\c\n\x01"), R"("a\"b\\c\u000a\u0001")");
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(1e300 * 1e10), "null");
}

TEST(TextTable, AlignsToTheRightExceptTheLastColumn) {
  EXPECT_EQ(align_columns({{"n", "name"}, {"10", "x"}}), " n  name\n10  x\n");
}

TEST(LevelRows, CountPlanesWhereTheyAppearFirst) {
  Octree tree;
  tree.universe = universe_around(Vec3{0.0}, Vec3{1.0});
  tree.levels.resize(2);
  tree.levels[0].append(NodeKind::Grey, std::vector<std::uint32_t>{0, 1});
  tree.levels[0].statement.error_bound = tree.universe.diagonal() / 4;
  for (std::uint32_t i = 0; i < 8; ++i) {
    tree.levels[1].append(i < 2 ? NodeKind::Convex : NodeKind::White,
                          i < 2 ? std::vector<std::uint32_t>{2} : std::vector<std::uint32_t>{});
  }
  const std::vector<LevelBytes> costs = {{100, 100}, {50, 150}};
  const auto rows = level_rows(tree, costs);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].new_planes, 2U);
  EXPECT_EQ(rows[0].error_percent, 25);
  EXPECT_EQ(rows[1].new_planes, 1U);
  EXPECT_EQ(rows[1].plane_references, 2U);
  EXPECT_EQ(rows[1].nodes[static_cast<int>(NodeKind::Convex)], 2U);
  EXPECT_EQ(to_json("m", std::span(rows).first(1)),
            "{\"model\":\"m\",\"total_bytes\":100,\"levels\":[\n"
            "{\"level\":0,\"bytes\":100,\"total_bytes\":100,\"nodes\":{\"white\":0,\"black\":0,"
            "\"grey\":1,\"convex\":0,\"concave\":0,\"vertex\":0},\"new_planes\":2,"
            "\"plane_references\":2,\"error\":25,\"inner_volume\":0,\"outer_volume\":0,\"inner_"
            "area\":0,\"outer_area\":0}\n]}\n");
}

TEST(Throttle, GivesPortionsOfATwentiethOfASecond) {
  EXPECT_EQ(Throttle(2000).portion(), 100U);
  EXPECT_EQ(Throttle(1).portion(), 1U);
  EXPECT_GT(Throttle(0).portion(), std::size_t{1} << 30);
}

TEST(RemainingTime, ReadsLikeAClock) {
  EXPECT_EQ(duration_text(0), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1:00 min");
  EXPECT_EQ(duration_text(3599), "59:59 min");
  EXPECT_EQ(duration_text(3600), "1:00 h");
  EXPECT_EQ(duration_text(1e300), "99:00 h");
}

TEST(RemainingTime, GoesOnAsFastAsSoFar) {
  EXPECT_EQ(describe_progress(0, 0), "  0 %, 0 s");
  EXPECT_EQ(describe_progress(0.001, 5), "  0 %, 5 s");
  EXPECT_EQ(describe_progress(0.25, 10), " 25 %, 10 s, 30 s left");
  EXPECT_EQ(describe_progress(0.1, 60), " 10 %, 1:00 min, 9:00 min left");
  EXPECT_EQ(describe_progress(1, 10), "100 %, 10 s, 0 s left");
  EXPECT_EQ(describe_progress(1.5, 10), "100 %, 10 s, 0 s left");
}

}  // namespace
}  // namespace spoctree
