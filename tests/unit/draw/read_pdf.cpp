#include <zlib.h>

#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/unit/draw/read_back.hpp"

namespace spoctree::test {

namespace {

std::string inflate_all(const std::string& bytes) {
  std::string text(1 << 20, '\0');
  uLongf size = text.size();
  if (uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK)
    throw std::runtime_error("a stream that cannot be decompressed");
  text.resize(size);
  return text;
}

/// Of an object's text: the number after `key`.
int number_after(const std::string& object, const std::string& key) {
  const std::size_t at = object.find(key);
  if (at == std::string::npos) throw std::runtime_error("no " + key);
  return std::stoi(object.substr(at + key.size()));
}

std::string ascii_of(const std::string& object) {
  const std::size_t begin = object.find("<FEFF") + 5;
  std::string text;
  for (std::size_t at = begin; object[at] != '>'; at += 4)
    text += static_cast<char>(std::stoi(object.substr(at, 4), nullptr, 16));
  return text;
}

}  // namespace

PdfText read_pdf_objects(const std::string& pdf) {
  PdfText text;
  if (pdf.rfind("%PDF-1.5\n", 0) != 0) throw std::runtime_error("not a PDF file");
  const std::size_t start = pdf.rfind("startxref\n");
  std::istringstream table(pdf.substr(std::stoul(pdf.substr(start + 10))));
  std::string word;
  std::size_t first = 1;
  std::size_t count = 0;
  table >> word >> first >> count;
  if (word != "xref" || first != 0) throw std::runtime_error("no cross references");
  table.ignore();
  for (std::size_t number = 0; number < count; ++number) {
    char entry[21] = {};
    table.read(entry, 20);  // 20 bytes each, exactly
    if (number == 0) continue;
    const std::size_t at = std::stoul(std::string(entry, 10));
    const std::string head = std::to_string(number) + " 0 obj\n";
    if (pdf.compare(at, head.size(), head) != 0)
      throw std::runtime_error("object " + std::to_string(number) + " is elsewhere");
    const std::size_t begin = at + head.size();
    std::string object = pdf.substr(begin, pdf.find("\nendobj\n", begin) - begin);
    const std::size_t stream = object.find("stream\n");
    if (stream != std::string::npos) {
      const auto length = static_cast<std::size_t>(number_after(object, "/Length "));
      object = object.substr(0, stream) + inflate_all(pdf.substr(begin + stream + 7, length));
    }
    text.objects.push_back(object);
  }
  text.trailer = pdf.substr(pdf.rfind("trailer\n"));
  return text;
}

std::vector<PdfPage> read_pdf(const std::string& pdf) {
  const PdfText text = read_pdf_objects(pdf);
  const auto object = [&](int number) {
    return text.objects.at(static_cast<std::size_t>(number) - 1);
  };
  std::vector<PdfPage> pages;
  for (const std::string& body : text.objects) {
    if (body.rfind("<</Type/Page/", 0) != 0) continue;
    PdfPage page;
    std::istringstream box(body.substr(body.find("/MediaBox[") + 10));
    double zero = 0;
    box >> zero >> zero >> page.width >> page.height;
    std::string content = object(number_after(body, "/Contents "));
    content = content.substr(content.find(">>") + 2);
    std::istringstream words(content);
    std::vector<double> numbers;
    std::vector<std::string> layers;
    std::string name;
    double scale = 1;
    double top = 0;
    Vec2 at{0.0};
    for (std::string word; words >> word;) {
      if (word.find_first_not_of("-.0123456789") == std::string::npos) {
        numbers.push_back(std::stod(word));
        continue;
      }
      if (word[0] == '/') {
        name = word;
        continue;
      }
      if (word == "cm") {
        scale = numbers.at(0);
        top = numbers.at(5);
      } else if (word == "BDC") {
        layers.push_back(ascii_of(object(number_after(body, name + ' '))));
      } else if (word == "EMC") {
        layers.pop_back();
      } else if (word == "m" || word == "l") {
        const Vec2 next{numbers.at(0) * scale, top - numbers.at(1) * scale};
        if (word == "l") page.segments.push_back({at, next, layers.back(), ""});
        at = next;
      }
      numbers.clear();
    }
    pages.push_back(page);
  }
  return pages;
}

}  // namespace spoctree::test
