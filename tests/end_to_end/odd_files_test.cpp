// Files that are not quite what they should be, and what the programs say to their users.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/end_to_end/programs.hpp"

namespace spoctree::test {
namespace {

// A box 2 x 3 x 4, and a plate 10 x 10 x 1 with a hole 4 x 4 in it, which top and bottom reach by a
// bridge.
const std::string kBox =
    "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string kPlate =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 3 3 0\nv 7 3 0\nv 7 7 0\nv 3 7 0\n"
    "v 0 0 1\nv 10 0 1\nv 10 10 1\nv 0 10 1\nv 3 3 1\nv 7 3 1\nv 7 7 1\nv 3 7 1\n"
    "f 9 10 11 12 9 13 16 15 14 13\nf 4 3 2 1 5 6 7 8 5 1\n"
    "f 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 1 9 12\n"
    "f 6 5 13 14\nf 7 6 14 15\nf 8 7 15 16\nf 5 8 16 13\n";

class OddFiles : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& bytes) const {
    write_file(folder_.file(name), bytes);
    return folder_.file(name);
  }
  Outcome build(const std::string& mesh, Arguments more = {}) const {
    more.insert(more.begin(), {"build", mesh, "-o", folder_.file("out.spo")});
    return run_server(more);
  }
  std::string measured() const { return run_client({"measure", folder_.file("out.spo")}).out; }

  TemporaryFolder folder_;
};

TEST_F(OddFiles, WithBridgedHolesAreSolidsAlsoAfterRepairAndBackFromTheirPlanes) {
  const std::string mesh = put("plate.obj", kPlate);
  for (const Arguments& more : {Arguments{}, Arguments{"--repair"}}) {
    const Outcome built = build(mesh, more);
    ASSERT_EQ(built.code, 0) << built.err;
    EXPECT_NE(built.out.find("10 faces, 10 planes, volume 84\n"), std::string::npos) << built.out;
    EXPECT_NE(measured().find("area        224\n"), std::string::npos) << measured();
  }
  // Without a wall, repair closes what is left.
  const std::string open = put("open.obj", kPlate.substr(0, kPlate.rfind("f ")));
  EXPECT_EQ(build(open).code, 3);
  const Outcome repaired = build(open, {"--repair"});
  EXPECT_NE(repaired.out.find("10 planes, volume 84\n"), std::string::npos)
      << repaired.out << repaired.err;
}

TEST_F(OddFiles, AreReadAndWhatIsOddIsSaid) {
  std::string mac = kBox;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  const Outcome built = build(put("mac.obj", mac));
  EXPECT_NE(built.out.find("volume 24\n"), std::string::npos) << built.out << built.err;

  // The facets of a tetrahedron of volume 1/6, and no end.
  const std::string cut = put("cut.stl",
                              "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n"
                              "vertex 1 0 0\nend loop\nendfacet\n"
                              "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                              "vertex 0 0 1\nend loop\nendfacet\n"
                              "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\n"
                              "vertex 0 1 0\nend loop\nendfacet\n"
                              "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\n"
                              "vertex 0 0 1\nend loop\nendfacet\n");
  const Outcome without_end = build(cut);
  EXPECT_EQ(without_end.code, 0) << without_end.err;
  EXPECT_NE(without_end.out.find("\nthe file ends without endsolid, behind facet 3"),
            std::string::npos)
      << without_end.out;
  EXPECT_NE(run_server({"info", cut}).out.find("the file ends without endsolid"),
            std::string::npos);

  // What is missing is missing: said with the reason, where the file has one.
  const std::string shorter = read_file(cut);
  const Outcome open = build(put("open.stl", shorter.substr(0, shorter.rfind("facet normal"))));
  expect_one_complaint(open, "spoctree-server");
  EXPECT_NE(open.err.find("not closed: 3 border edges"), std::string::npos) << open.err;
  EXPECT_NE(open.err.find("the file ends without endsolid, behind facet 2"), std::string::npos)
      << open.err;
}

TEST_F(OddFiles, OfOtherKindsAreCalledByTheirNames) {
  const std::pair<std::string, std::string> cases[] = {
      {"ISO-10303-21;\nHEADER;\n", ": is a STEP file: export it as an STL, OBJ, OFF or PLY mesh\n"},
      {std::string("glTF\x02\0\0\0", 8),
       ": is a glTF binary file (GLB): convert it to STL, OBJ, OFF or PLY\n"},
      {"version https://git-lfs.github.com/spec/v1\n",
       ": is a Git LFS pointer, not the file itself: fetch that with git lfs pull\n"},
      {"%PDF-1.4\n", ": is a PDF document, not a mesh\n"},
      {"SPO\x01", ": is a .spo file: it is built already\n"},
  };
  for (const char* name : {"part.obj", "part.stl", "part.off", "part.ply", "part.step", "part"}) {
    for (const auto& [bytes, message] : cases) {
      const std::string path = put(name, bytes);
      const Outcome outcome = build(path);
      EXPECT_EQ(outcome.code, 3);
      EXPECT_EQ(outcome.err, "spoctree-server: " + path + message);
    }
  }
}

TEST_F(OddFiles, ThatAreMeshesAreNamedByTheClient) {
  const std::string mesh = put("box.obj", kBox);
  const Outcome outcome = run_client({"draw", mesh, "-o", folder_.file("box.svg")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "spoctree-client: " + mesh +
                             ": is an OBJ mesh, not a .spo file: spoctree-server build makes one "
                             "of it\n");
  const std::string step = put("box.step", "ISO-10303-21;\n");
  EXPECT_EQ(run_client({"levels", step}).err,
            "spoctree-client: " + step + ": is a STEP file, not a .spo file\n");
  const std::string unmarked = put("box.off", "3 1 0\n");
  EXPECT_NE(run_client({"levels", unmarked}).err.find("is a mesh by its name"), std::string::npos);
}

TEST_F(OddFiles, MayHaveAnyNameInASource) {
  const std::string spo = spo_of("mechanical-piece");
  put("My Part.spo", spo);
  put("50%.spo", spo);
  put("Gehäuse.spo", spo);
  const ServerProcess server({folder_.path().string()});
  for (const char* name : {"My%20Part", "My Part", "50%25", "Gehäuse", "Geh%C3%A4use"}) {
    const Outcome outcome = run_client({"levels", server.url(name)});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
  for (const char* name : {"50%", "%4", "%zz", "a%0Ab", "%ff"}) {
    const Outcome outcome = run_client({"levels", server.url(name)});
    EXPECT_EQ(outcome.code, 2) << name;
    expect_one_complaint(outcome, "spoctree-client");
  }
  // What list prints can be used as it stands.
  const std::string list = run_client({"list", "spo://" + server.address()}).out;
  for (const char* name : {"/My%20Part ", "/50%25 ", "/Gehäuse "}) {
    EXPECT_NE(list.find("spo://" + server.address() + name), std::string::npos) << list;
  }
}

}  // namespace
}  // namespace spoctree::test
