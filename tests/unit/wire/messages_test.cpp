#include "common/wire/messages.hpp"

#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "tests/support/frames.hpp"

namespace spoctree {
namespace {

Request reopened(const Request& request) {
  const std::string bytes = seal_request(request);
  const auto frame = read_frame(bytes, 0, 0, kMaxRequestPayloadBytes);
  return open_request(frame.value());
}

TEST(Request, ComesBackAsItWas) {
  EXPECT_EQ(reopened(ListRequest{}), Request{ListRequest{}});
  const GetRequest get{"gear", 4, {1234, 0xfedcba9876543210u}};
  EXPECT_EQ(reopened(get), Request{get});
  EXPECT_EQ(reopened(GetRequest{}), Request{GetRequest{}});
  const GetRequest longest{std::string(kMaxNameBytes, 'n'), UINT16_MAX, {UINT64_MAX, UINT64_MAX}};
  EXPECT_EQ(reopened(longest), Request{longest});
}

TEST(Error, ComesBackAsItWas) {
  const ErrorMessage error{ErrorCode::UnknownModel, "no model is called \"x\""};
  const std::string bytes = seal_error(error);
  EXPECT_EQ(open_error(read_frame(bytes, 0, 0).value()), error);
  const std::string odd = seal_error({static_cast<ErrorCode>(77), "two\nlines"});
  EXPECT_EQ(open_error(read_frame(odd, 0, 0).value()),
            (ErrorMessage{ErrorCode::Internal, "two?lines"}));
}

std::vector<CatalogEntry> reopened(const std::vector<CatalogEntry>& entries) {
  const std::string bytes = seal_catalog(entries);
  std::vector<CatalogEntry> again;
  bool more = true;
  for (const FrameView& frame : frames_of(bytes)) {
    EXPECT_TRUE(more);
    more = open_catalog(frame, again);
  }
  EXPECT_FALSE(more);
  return again;
}

TEST(Catalog, ComesBackAsItWas) {
  EXPECT_TRUE(reopened(std::vector<CatalogEntry>{}).empty());
  const std::vector<CatalogEntry> entries{{"gear", 1, 2, 3, 4, 5, "mm", "gear.off"},
                                          {"", UINT64_MAX, UINT64_MAX, 31, 6, 7, "", ""}};
  EXPECT_EQ(reopened(entries), entries);
}

TEST(Catalog, OfManyModelsTakesSeveralFrames) {
  std::vector<CatalogEntry> entries;
  for (std::size_t i = 0; i < 2000; ++i) {
    entries.push_back({std::string(i % (kMaxNameBytes + 1), 'n'), i, 0, 1, 0, 1,
                       std::string(i % 32, 'u'), std::string(i % 200, 's')});
  }
  EXPECT_EQ(reopened(entries), entries);
}

TEST(Messages, AreNotTakenForOneAnother) {
  const std::string request = seal_request(ListRequest{});
  const std::string error = seal_error({});
  std::vector<CatalogEntry> entries;
  EXPECT_THROW(open_request(read_frame(error, 0, 0).value()), BadInput);
  EXPECT_THROW(open_error(read_frame(request, 0, 0).value()), BadInput);
  EXPECT_THROW(open_catalog(read_frame(error, 0, 0).value(), entries), BadInput);
}

TEST(Messages, OfAnotherProtocolVersionAreNamed) {
  std::string bytes = seal_request(ListRequest{});
  // Frame header, segment table, root pointer, then the version.
  bytes[16 + 16] = 9;
  const std::string sealed = seal_frame(FrameType::Request, bytes.substr(16));
  try {
    open_request(read_frame(sealed, 0, 0).value());
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("protocol version 9"), std::string::npos);
  }
}

}  // namespace
}  // namespace spoctree
