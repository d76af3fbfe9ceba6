// The inputs that fuzzing begins with: small files of every format, streams of small trees, soups
// with every kind of damage. make_fuzz_corpus FOLDER writes a folder for each target.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "common/wire/encode.hpp"
#include "common/wire/messages.hpp"
#include "common/wire/spo_writer.hpp"
#include "server/silhouettes/encode_mask.hpp"
#include "tests/fuzz/soup_of_bytes.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"
#include "tools/model/models.hpp"

namespace {

using namespace spoctree;
namespace fs = std::filesystem;

class Corpus {
 public:
  explicit Corpus(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& target, const std::string& bytes) {
    fs::create_directories(folder_ / target);
    const fs::path path = folder_ / target / ("seed-" + std::to_string(count_++));
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::ssize(bytes));
  }

 private:
  fs::path folder_;
  int count_ = 0;
};

PolygonSoup soup_of(const model::PolygonMesh& mesh) {
  PolygonSoup soup;
  soup.points = mesh.points;
  for (const model::Loop& face : mesh.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

void add_meshes(Corpus& corpus) {
  using namespace mesh_test;
  corpus.add("fuzz_off", kTetrahedronOff);
  corpus.add("fuzz_off", "4OFF # x\n3 1\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 .5 .5 .5\n");
  corpus.add("fuzz_off", "STCNOFF\n3 1 0\n0 0 0 1 1 1\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n");
  corpus.add("fuzz_off", "nOFF 3\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 1 2\n");
  corpus.add("fuzz_off",
             "off\n4 4\n6\n0\n0\n0 1 0 0\n0 1 0 0 0 1.0D0\n"
             "3 0\n2 1\n3 0 1 3 3 0 3 2 3 1 2 3\n");
  corpus.add("fuzz_off",
             "COFF\n3 3\n0 0 0 1 1 1 1 1 0 0 0 0 0 0\n0 1 0 1 1\n1 1\n"
             "3 0 1 2\n2 0 1\n1 0\n");
  const std::string frame =
      "0 0 0\n9 0 0\n9 9 0\n0 9 0\n3 3 0\n6 3 0\n6 6 0\n3 6 0\n10 0 1 2 3 0 4 7 6 5 4\n";
  corpus.add("fuzz_off", "OFF 8 1 0\n" + frame);
  corpus.add("fuzz_obj", kTetrahedronObj);
  corpus.add("fuzz_obj", "V 0 0 0\rV 1 0 0\rv 0 1 0\r# c\rfo 1 2 3\rF 1 2\rf 1 2 3 1 2 3 1\r");
  corpus.add("fuzz_obj", kTetrahedronObj + "v 1 1 \\\n1\nf -1 -2/1 \\\n-3//4\nf 1/1/1 2/2 3 3\n");
  corpus.add("fuzz_text_stl", kTetrahedronTextStl);
  corpus.add("fuzz_text_stl", kTetrahedronTextStl + kTetrahedronTextStl);
  corpus.add("fuzz_text_stl",
             "; c\nhead\nsolidx\nmore\ncolor 1 0 0\nfacet normal 0 0 1 outer loop # c\n"
             "vertex 0 0 0 vertex\n1 0 0\nvertex 0 1d0 0 end loop\nend facet // c\n");
  corpus.add("fuzz_text_stl", tetrahedron_binary_stl() + "behind");
  std::string wrong_count = tetrahedron_binary_stl();
  wrong_count[80] = 7;
  corpus.add("fuzz_text_stl", wrong_count);
  corpus.add("fuzz_text_stl", kTetrahedronTextStl + "\x1a and more\n");
  corpus.add("fuzz_binary_stl", tetrahedron_binary_stl());
  corpus.add("fuzz_binary_stl", tetrahedron_binary_stl("solid"));
  corpus.add("fuzz_text_ply", kTetrahedronTextPly);
  corpus.add("fuzz_text_ply",
             "ply\nformat ascii 1.0\ncomment c\nelement material 1\nproperty list uchar double a\n"
             "element vertex 3\nproperty double z\nproperty uchar red\nproperty double y\n"
             "property double x\nelement face 1\nproperty list ushort uint vertex_index\n"
             "property float q\nend_header\n2 1 2\n0 1 0 0\n0 1 1 0\n0 1 0 1\n3 0 1 2 7\n");
  corpus.add("fuzz_text_ply",
             "PLY\rFORMAT ASCII 1.0\rELEMENT VERTEX 3\rPROPERTY FLOAT X\rPROPERTY FLOAT Y\r"
             "PROPERTY FLOAT Z\rELEMENT NOTHING 3\rELEMENT FACE 2\r"
             "PROPERTY LIST UCHAR INT VERTEX_INDEX\rEND_HEADER\r"
             "0 0 0 1\r0 0 0 1 0\r3 0 1 2\r3\r2\r1\r0\rbehind");
  for (const ByteOrder order : {ByteOrder::LittleEndian, ByteOrder::BigEndian}) {
    corpus.add("fuzz_binary_ply", tetrahedron_binary_ply(order));
    corpus.add("fuzz_binary_ply", tetrahedron_binary_ply(order) + "behind");
  }
}

void add_soups(Corpus& corpus) {
  for (const model::ModelInfo& info : model::models()) {
    const PolygonSoup soup = soup_of(info.make(info.sizes.lowest));
    bool is_small = soup.points.size() <= 64;
    for (std::size_t f = 0; f < soup.face_count(); ++f) is_small &= soup.face(f).size() <= 6;
    if (!is_small) continue;
    corpus.add("fuzz_repair", bytes_of_soup(soup));
    for (std::size_t damaged = 0; damaged < std::min<std::size_t>(soup.face_count(), 3);
         ++damaged) {
      PolygonSoup open = soup;  // without a face, with another twice, with a third turned
      open.corners.clear();
      open.first_corner = {0};
      for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto face = soup.face(f);
        for (std::size_t copies = f == damaged       ? 0
                                  : f == damaged + 1 ? 2
                                                     : 1;
             copies > 0; --copies) {
          open.corners.insert(open.corners.end(), face.begin(), face.end());
          if (f == damaged + 2)
            std::reverse(open.corners.end() - std::ssize(face), open.corners.end());
          open.first_corner.push_back(static_cast<std::uint32_t>(open.corners.size()));
        }
      }
      corpus.add("fuzz_repair", bytes_of_soup(open));
    }
  }
}

// As fuzz_decode seals frames: type, length in words, what follows the segment table.
std::string unsealed(std::string_view stream) {
  std::string bytes(1, '\0');
  for (const FrameView& frame : frames_of(stream)) {
    const std::size_t words = frame.payload.size() / 8 - 1;
    bytes += static_cast<char>(frame.type);
    bytes += static_cast<char>(words);
    bytes += static_cast<char>(words >> 8);
    bytes += frame.payload.substr(8);
  }
  return bytes;
}

void add_trees(Corpus& corpus) {
  const SourceInfo source{"mm", "piece.off", 0x1234, "max-depth=12"};
  const auto add = [&](const Octree& tree) {
    const std::string file = encode_spo(tree, source);
    corpus.add("fuzz_decode", "\x01" + file);
    corpus.add("fuzz_decode", unsealed(encode_stream(tree, source)));
  };
  add(cube_tree());
  add(every_kind_tree());
  for (std::uint64_t seed = 0; seed < 8; ++seed) add(random_tree(seed));
  corpus.add("fuzz_decode", unsealed(seal_request(GetRequest{"cube", 1, {}})));
}

void add_masks(Corpus& corpus) {
  Mask mask(13, 9);
  for (std::size_t i = 0; i < mask.pixels.size(); i += 2) mask.pixels[i] = 1;
  for (const char view : {'\0', '\x04', '\x8b'}) {
    for (const MaskFormat format : {MaskFormat::Pbm, MaskFormat::Pgm, MaskFormat::Png})
      corpus.add("fuzz_mask", view + encode_mask(mask, format));
    corpus.add("fuzz_mask", std::string(1, view) + "P1\n# plain\n3 2\n0 1 1\n110");
    corpus.add("fuzz_mask", std::string(1, view) + "P2 3 1\n9\n4 5 9\n");
    corpus.add("fuzz_mask", std::string(1, view) + "P2 3 1\n255\n0 1 1\n");
    corpus.add("fuzz_mask", std::string(1, view) + "P5 3 1\n255\n\x01\x02\x03");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_fuzz_corpus FOLDER\n", stderr);
    return 2;
  }
  Corpus corpus(argv[1]);
  add_meshes(corpus);
  add_soups(corpus);
  add_trees(corpus);
  add_masks(corpus);
}
