# Every message of the protocol. PROTOCOL.md says how they are framed, in which order they stand,
# and what the bytes of the columns mean. Each message is one frame: one Cap'n Proto message of
# exactly one segment, not packed.
#
# Ids, ordinals and enumerants are frozen: add at the end, never renumber.
@0xd90ef62a8416b274;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("spoctree::schema");

# ---- The stream, and with it the .spo file ----------------------------------------------------

enum Encoding {
  plain @0;  # exact: every plane as four 64-bit floating-point numbers
}

struct Header {  # frame type 1, the first frame
  protocolVersion @0 :UInt16;
  encoding @1 :Encoding;
  levelCount @2 :UInt16;     # levels of a full transmission: 1 .. 31
  scaleExponent @3 :Int16;   # the universe cube: see common/geometry/universe.hpp
  planeCount @4 :UInt32;     # planes of a full transmission
  nodeCount @5 :UInt32;      # nodes of a full transmission
  centerX @6 :Float64;       # model units
  centerY @7 :Float64;
  centerZ @8 :Float64;
  halfSide @9 :Float64;      # universe coordinates
  sourceHash @10 :UInt64;    # XXH3-64 of the mesh file
  units @11 :Text;           # of the model, such as "mm"; empty: not known
  sourceName @12 :Text;      # name of the mesh file, without folders
  buildOptions @13 :Text;    # "name=value" pairs, blank between
}

struct Chunk {  # frame type 2: the next run of each column of the level
  kinds @0 :Data;        # a byte per node: White 0, Black 1, Grey 2, Convex 3, Concave 4, Vertex 5
  planes @1 :Data;       # 32 bytes per plane: normal x, y, z, offset
  counts @2 :Data;       # varints: number of planes of each node that is neither White nor Black
  references @3 :Data;   # varints: the planes of those nodes
  expressions @4 :Data;  # varints: the expression of each Vertex node
}

struct LevelEnd {  # frame type 3: closes a level
  level @0 :UInt16;
  last @1 :Bool;            # no level follows in a full transmission
  nodeCount @2 :UInt32;     # of this level
  planeCount @3 :UInt32;    # planes that appeared for the first time in this level
  errorBound @4 :Float64;   # model units: no point of T_k is farther from the solid, or of it from T_k
  innerVolume @5 :Float64;  # model units cubed: certainly material
  outerVolume @6 :Float64;  # model units cubed: volume of T_k
  innerArea @7 :Float64;    # model units squared: of the boundary in the leaves of levels 0..k
  outerArea @8 :Float64;    # model units squared: at most this is the whole boundary's
}

struct Index {  # frame type 4: in a .spo file only, after the stream's frames
  framesHash @0 :UInt64;           # XXH3-64 of all bytes before this frame
  levelEnds @1 :List(UInt64);      # byte after each level's LevelEnd; level 0 begins at byte 0
}

# ---- The conversation --------------------------------------------------------------------------

struct Request {  # frame type 16, client to server
  protocolVersion @0 :UInt16;
  union {
    list @1 :Void;
    get :group {
      name @2 :Text;        # a model of the catalog; empty: the server's only model
      levels @3 :UInt16;    # up to which level: the first `levels` of them; 0 = all
      fromByte @4 :UInt64;  # a frame boundary: bytes of the stream that the client already holds
      heldHash @5 :UInt64;  # XXH3-64 of those bytes; not looked at where fromByte is 0
    }
  }
}

struct Catalog {  # frame type 17, the answer to `list`
  models @0 :List(Model);
  more @1 :Bool;  # another Catalog frame follows
}

struct Model {
  modelId @0 :UInt64;  # XXH3-64 of all frames
  byteCount @1 :UInt64;
  levelCount @2 :UInt16;
  planeCount @3 :UInt32;
  nodeCount @4 :UInt32;
  name @5 :Text;
  units @6 :Text;
  sourceName @7 :Text;
}

struct Error {  # frame type 18: the answer to a request that cannot be met
  code @0 :Code;
  text @1 :Text;

  enum Code {
    internal @0;
    badRequest @1;    # malformed, or of a protocol version that the server does not speak
    unknownModel @2;
    changedModel @3;  # the held bytes are not the beginning of the model: start at byte 0
    badOffset @4;     # fromByte is no frame boundary, or nothing of the levels asked for follows it
    busy @5;          # too many connections; try again later
  }
}
