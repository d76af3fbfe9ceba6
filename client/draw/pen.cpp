#include "client/draw/pen.hpp"

#include <cstdio>
#include <tuple>

namespace spoctree {

namespace {

constexpr Rgb kInkColours[kInkCount] = {{0, 0, 0},      {128, 128, 128}, {0, 150, 60},
                                        {30, 80, 215},  {228, 180, 0},   {215, 25, 30},
                                        {140, 40, 170}, {0, 255, 255},   {255, 0, 0}};
constexpr const char* kInkNames[kInkCount] = {"black", "grey",   "green",    "blue",     "yellow",
                                              "red",   "purple", "left-eye", "right-eye"};
constexpr const char* kUseNames[] = {"crease", "silhouette", "caption"};

}  // namespace

std::strong_ordering Pen::operator<=>(const Pen& other) const {
  const auto rank = [](const Pen& pen) {
    return std::tuple(!pen.hidden, pen.use, !pen.is_step, pen.ink);
  };
  return rank(*this) <=> rank(other);
}

Ink ink_of_kind(const LineSource& source) {
  switch (source.kind) {
    case NodeKind::Convex:
      return source.is_inherited ? Ink::Red : Ink::Green;
    case NodeKind::Concave:
      return source.is_inherited ? Ink::Yellow : Ink::Blue;
    case NodeKind::Black:
      return source.is_inherited ? Ink::Red : Ink::Grey;
    case NodeKind::Vertex:
      return Ink::Purple;
    case NodeKind::Grey:
    case NodeKind::White:
      return Ink::Grey;
  }
  return Ink::Grey;
}

double width_mm(const Pen& pen) {
  if (pen.hidden) return 0.18;
  return pen.use == PenUse::Silhouette ? 0.5 : 0.25;
}

Rgb colour_of(const Pen& pen) {
  if (pen.ink == Ink::Black && pen.hidden) return {100, 100, 100};
  if (pen.ink == Ink::Black && pen.is_step) return {150, 150, 150};
  return kInkColours[static_cast<int>(pen.ink)];
}

const char* name_of(Ink ink) { return kInkNames[static_cast<int>(ink)]; }

std::string name_of(const Pen& pen, char separator) {
  std::string name = kUseNames[static_cast<int>(pen.use)];
  if (pen.is_step) name = name + separator + "step";
  if (pen.hidden) name = name + separator + "hidden";
  if (pen.ink != Ink::Black) name = name + separator + name_of(pen.ink);
  return name;
}

std::string to_hex(Rgb colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(colour.red),
                static_cast<unsigned>(colour.green), static_cast<unsigned>(colour.blue));
  return text;
}

}  // namespace spoctree
