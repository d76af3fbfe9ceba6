#include <algorithm>

#include "common/base/errors.hpp"
#include "server/silhouettes/find_object.hpp"

namespace spoctree {

namespace {

// Fewer dark pixels in strong colours than this, as a fraction of the object, are fringes.
constexpr double kMostFringe = 0.01;

class ObjectFinder {
 public:
  ObjectFinder(const Picture& picture, std::string_view name) : picture_(picture), name_(name) {}

  MaskReading find() const {
    const std::size_t transparent = count([](const Pixel& p) { return p.is_transparent; });
    if (transparent == picture_.pixels.size()) fail("every pixel is transparent");
    if (transparent > 0) return find_opaque();
    const std::size_t bright = count([this](const Pixel& p) { return is_bright(p); });
    const std::size_t dark_colours = count([this](const Pixel& p) { return is_dark_colour(p); });
    if (bright > 0) {
      const auto fringe = kMostFringe * static_cast<double>(bright + dark_colours);
      if (static_cast<double>(dark_colours) > fringe) {
        fail("it has bright pixels (brightness up to " + level(brightest()) +
             ") and dark ones in strong colours (brightness from " + level(darkest_colour()) +
             "): make the object white and all else black");
      }
      return {mask_of([this](const Pixel& p) { return is_bright(p); }), {}};
    }
    if (has_strong_colours()) return find_coloured();
    return find_label();
  }

 private:
  bool is_at_least_half(std::uint16_t value) const { return 2 * value >= picture_.white; }
  bool is_bright(const Pixel& p) const { return is_at_least_half(p.brightness); }
  bool is_dark_colour(const Pixel& p) const {
    return !is_bright(p) && is_at_least_half(static_cast<std::uint16_t>(p.strongest - p.weakest));
  }
  bool has_strong_colours() const {
    return count([this](const Pixel& p) { return is_at_least_half(p.strongest); }) > 0;
  }

  template <class Predicate>
  std::size_t count(const Predicate& is_counted) const {
    return static_cast<std::size_t>(
        std::count_if(picture_.pixels.begin(), picture_.pixels.end(), is_counted));
  }

  template <class Predicate>
  Mask mask_of(const Predicate& is_object) const {
    Mask mask(picture_.width, picture_.height);
    std::transform(picture_.pixels.begin(), picture_.pixels.end(), mask.pixels.begin(),
                   [&](const Pixel& p) { return std::uint8_t{is_object(p)}; });
    return mask;
  }

  template <class Predicate>
  std::uint16_t largest(const Predicate& value) const {
    std::uint16_t largest = 0;
    for (const Pixel& p : picture_.pixels) largest = std::max<std::uint16_t>(largest, value(p));
    return largest;
  }
  std::uint16_t brightest() const {
    return largest([](const Pixel& p) { return p.brightness; });
  }
  std::uint16_t darkest_colour() const {
    std::uint16_t darkest = 0xffff;
    for (const Pixel& p : picture_.pixels) {
      if (is_dark_colour(p)) darkest = std::min(darkest, p.brightness);
    }
    return darkest;
  }

  std::string level(int value) const {
    return std::to_string(value) + " of " + std::to_string(picture_.white);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(std::string(name_) + ": " + what);
  }

  MaskReading find_opaque() const {
    const auto is_opaque = [](const Pixel& p) { return !p.is_transparent; };
    std::uint16_t darkest = 0xffff;
    for (const Pixel& p : picture_.pixels) {
      if (is_opaque(p)) darkest = std::min(darkest, p.brightness);
    }
    MaskReading reading{mask_of(is_opaque), {}};
    if (!is_at_least_half(darkest)) {
      reading.remark =
          "the object is what is opaque, bright or not (brightness from " + level(darkest) + " on)";
    }
    return reading;
  }

  MaskReading find_coloured() const {
    const auto is_strong = [this](const Pixel& p) { return is_at_least_half(p.strongest); };
    if (count(is_strong) == picture_.pixels.size()) {
      fail("it is dark, but in strong colours all over: the brightest pixel is " +
           level(brightest()) + ", and what is at least half of white is the object");
    }
    return {mask_of(is_strong), "no pixel is bright (the brightest is " + level(brightest()) +
                                    "): the object is what has a strong colour"};
  }

  MaskReading find_label() const {
    const std::uint16_t label = largest([](const Pixel& p) { return p.strongest; });
    const auto is_black = [](const Pixel& p) { return p.strongest == 0; };
    const auto is_label = [label](const Pixel& p) { return p.strongest == label; };
    if (label == 0) return {mask_of(is_label_of_nothing), "every pixel is black"};
    if (count(is_black) == 0 || count(is_black) + count(is_label) < picture_.pixels.size()) {
      fail("it is dark: the brightest pixel is " + level(brightest()) +
           ", and what is at least half of white is the object");
    }
    return {mask_of(is_label), "the brightest pixel is " + level(brightest()) +
                                   ": taken for a picture of labels, in which the object is what "
                                   "is not black"};
  }

  static bool is_label_of_nothing(const Pixel&) { return false; }

  const Picture& picture_;
  std::string_view name_;
};

}  // namespace

MaskReading find_object(const Picture& picture, std::string_view name) {
  return ObjectFinder(picture, name).find();
}

}  // namespace spoctree
