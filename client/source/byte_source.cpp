#include "client/source/byte_source.hpp"

#include <algorithm>
#include <array>

#include "client/net/connection.hpp"
#include "common/wire/answer_get.hpp"
#include "common/wire/spo_file.hpp"

namespace spoctree {

namespace {

// Room for a quarter of a second, within what systems like to give.
std::size_t receive_buffer_for(std::uint64_t rate) {
  if (rate == 0) return 0;
  return std::clamp<std::uint64_t>(rate / 4, 4'096, 65'536);
}

class RemoteSource : public ByteSource {
 public:
  RemoteSource(const Address& server, const GetRequest& request, std::uint64_t rate)
      : connection_(server, {.receive_buffer_bytes = receive_buffer_for(rate)}) {
    connection_.write(seal_request(request));
  }
  std::string_view read(std::size_t most) override {
    const std::size_t count =
        connection_.read_some(std::span(buffer_).first(std::min(most, buffer_.size())));
    return {buffer_.data(), count};
  }

 private:
  Connection connection_;
  std::array<char, kMaxFrameBytes> buffer_;
};

class FileSource : public ByteSource {
 public:
  FileSource(const std::string& path, const GetRequest& request) : file_(path) {
    const GetAnswer answer = answer_get(file_, request);
    if (const auto* const error = std::get_if<ErrorMessage>(&answer)) throw_refusal(*error);
    rest_ = std::get<std::string_view>(answer);
  }
  std::string_view read(std::size_t most) override {
    const std::string_view bytes = rest_.substr(0, most);
    rest_.remove_prefix(bytes.size());
    return bytes;
  }
  std::optional<std::uint32_t> level_count() const override { return file_.level_count(); }

 private:
  SpoFile file_;
  std::string_view rest_;
};

}  // namespace

void throw_refusal(const ErrorMessage& error) {
  if (error.code == ErrorCode::UnknownModel) throw BadInput(error.text);
  throw Refusal(error.code, error.text);
}

std::unique_ptr<ByteSource> open_source(const SourceName& source, GetRequest request,
                                        std::uint64_t rate) {
  if (const auto* const file = std::get_if<ModelFile>(&source))
    return std::make_unique<FileSource>(file->path, request);
  const auto& model = std::get<RemoteModel>(source);
  request.name = model.name;
  return std::make_unique<RemoteSource>(model.server, request, rate);
}

std::vector<CatalogEntry> fetch_catalog(const Address& server,
                                        std::chrono::milliseconds timeout) try {
  Connection connection(server, {.idle_timeout = timeout});
  connection.write(seal_request(ListRequest{}));
  std::vector<CatalogEntry> entries;
  FrameReader frames;
  std::array<char, kMaxFrameBytes> buffer;
  while (true) {
    const auto frame = frames.next();
    if (!frame) {
      const std::size_t count = connection.read_some(buffer);
      if (count == 0)
        throw NetworkError(to_text(server) + ": closed the connection before it had answered");
      frames.feed({buffer.data(), count});
      continue;
    }
    if (frame->type == FrameType::Error) throw_refusal(open_error(*frame));
    if (!open_catalog(*frame, entries)) return entries;
  }
} catch (const BadInput& error) {
  throw BadInput(to_text(server) + ": " + error.what());
}

}  // namespace spoctree
