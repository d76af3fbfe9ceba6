// Damage at every place of a small file: a reader throws BadInput or keeps its promises.
#include <gtest/gtest.h>

#include "server/mesh/read_mesh.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

struct Sample {
  const char* name;
  MeshFormat format;
  std::string bytes;
};

std::vector<Sample> samples() {
  return {
      {"off", MeshFormat::Off, kTetrahedronOff},
      {"4off", MeshFormat::Off, "4OFF # x\n3 1\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 .5 .5 .5\n"},
      {"obj", MeshFormat::Obj, kTetrahedronObj + "v 1 1 \\\n1\nf -1 -2/1 \\\n-3//4\n"},
      {"text stl", MeshFormat::Stl, kTetrahedronTextStl},
      {"binary stl", MeshFormat::Stl, tetrahedron_binary_stl()},
      {"binary stl with solid", MeshFormat::Stl, tetrahedron_binary_stl("solid")},
      {"text ply", MeshFormat::Ply, kTetrahedronTextPly},
      {"little ply", MeshFormat::Ply, tetrahedron_binary_ply(ByteOrder::LittleEndian)},
      {"big ply", MeshFormat::Ply, tetrahedron_binary_ply(ByteOrder::BigEndian)},
  };
}

// Reads `bytes`; true if that gives a soup. Anything but a soup that keeps its promises or a
// BadInput that names the file is a failure of the test.
bool is_read(MeshFormat format, const std::string& bytes, const std::string& what) {
  // A copy of exactly this size, so that the address sanitizer sees a byte too far.
  const std::vector<char> exact(bytes.begin(), bytes.end());
  try {
    const PolygonSoup soup = parse_mesh(format, {exact.data(), exact.size()}, "part");
    EXPECT_EQ(broken_promise(soup), "") << what;
    return true;
  } catch (const BadInput& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("part:")) << what << ": " << error.what();
    return false;
  }
}

TEST(DamagedMesh, IsReadOrRejectedAtEveryTruncation) {
  for (const Sample& sample : samples()) {
    EXPECT_TRUE(is_read(sample.format, sample.bytes, sample.name)) << sample.name;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      is_read(sample.format, sample.bytes.substr(0, size),
              sample.name + (" cut to " + std::to_string(size)));
    }
  }
}

TEST(DamagedMesh, IsNeverReadFromATruncatedBinaryFile) {
  for (const Sample& sample :
       {Sample{"stl", MeshFormat::Stl, tetrahedron_binary_stl()},
        Sample{"ply", MeshFormat::Ply, tetrahedron_binary_ply(ByteOrder::LittleEndian)}}) {
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      EXPECT_FALSE(is_read(sample.format, sample.bytes.substr(0, size), sample.name)) << size;
    }
  }
}

TEST(DamagedMesh, IsReadOrRejectedWithAnyByteChanged) {
  for (const Sample& sample : samples()) {
    for (std::size_t i = 0; i < sample.bytes.size(); ++i) {
      for (const int change : {0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xff}) {
        std::string bytes = sample.bytes;
        bytes[i] = static_cast<char>(bytes[i] ^ change);
        is_read(sample.format, bytes, sample.name + (" changed at " + std::to_string(i)));
      }
    }
  }
}

TEST(DamagedMesh, IsReadOrRejectedWithAnyByteRemovedOrDoubled) {
  for (const Sample& sample : samples()) {
    for (std::size_t i = 0; i < sample.bytes.size(); ++i) {
      std::string removed = sample.bytes;
      removed.erase(i, 1);
      is_read(sample.format, removed, sample.name + (" without byte " + std::to_string(i)));
      std::string doubled = sample.bytes;
      doubled.insert(i, 1, doubled[i]);
      is_read(sample.format, doubled, sample.name + (" with byte twice " + std::to_string(i)));
    }
  }
}

TEST(DamagedMesh, IsReadOrRejectedByEveryReader) {
  for (const Sample& sample : samples()) {
    for (const MeshFormat format :
         {MeshFormat::Off, MeshFormat::Obj, MeshFormat::Stl, MeshFormat::Ply}) {
      EXPECT_EQ(is_read(format, sample.bytes, sample.name), format == sample.format) << sample.name;
    }
  }
}

}  // namespace
}  // namespace spoctree
