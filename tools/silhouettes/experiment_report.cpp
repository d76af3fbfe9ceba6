#include "tools/silhouettes/experiment_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "common/report/json_text.hpp"
#include "common/report/text_table.hpp"

namespace spoctree {

namespace {

std::string with_decimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string percent(double ratio) { return with_decimals(100 * ratio, 1); }

/// A chart with the ratio upwards, in percent, and a column per object.
class Chart {
 public:
  Chart(const std::vector<std::string>& labels, const std::string& title, double highest)
      : highest_(highest) {
    const double width =
        std::max(kLeft + kColumn * static_cast<double>(labels.size()) + 10, kLeastWidth);
    svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
           number(kBottom + 92) + "\" font-family=\"sans-serif\" font-size=\"11\">\n" +
           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    text(kLeft, 16, title, "");
    for (int level = 0; level <= highest; level += 20) {
      const double y = height_of(level / 100.0);
      line(kLeft, y, width - 10, y, level == 100 ? "#000" : "#ccc");
      text(kLeft - 4, y + 4, std::to_string(level), " text-anchor=\"end\"");
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const double x = middle_of(i);
      text(x, kBottom + 12, labels[i],
           " text-anchor=\"end\" transform=\"rotate(-40 " + number(x) + " " + number(kBottom + 12) +
               ")\"");
    }
  }

  static double middle_of(std::size_t i) {
    return kLeft + kColumn * (static_cast<double>(i) + 0.5);
  }
  double height_of(double ratio) const {
    return kBottom - (kBottom - kTop) * std::min(100 * ratio, highest_) / highest_;
  }
  void bar(double x, double width, double low, double high, const std::string& fill) {
    svg_ += "<rect x=\"" + number(x) + "\" y=\"" + number(height_of(high)) + "\" width=\"" +
            number(width) + "\" height=\"" + number(height_of(low) - height_of(high)) +
            "\" fill=\"" + fill + "\" stroke=\"#000\" stroke-width=\"0.6\"/>\n";
  }
  void text(double x, double y, const std::string& what, const std::string& more) {
    svg_ +=
        "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\"" + more + ">" + what + "</text>\n";
  }
  std::string finish() { return svg_ + "</svg>\n"; }

  static constexpr double kBottom = 340;

 private:
  static constexpr double kLeft = 40;
  static constexpr double kTop = 30;
  static constexpr double kColumn = 56;
  static constexpr double kLeastWidth = 480;  ///< for the title

  static std::string number(double value) { return with_decimals(value, 2); }
  void line(double x1, double y1, double x2, double y2, const std::string& stroke) {
    svg_ += "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
            "\" y2=\"" + number(y2) + "\" stroke=\"" + stroke + "\" stroke-width=\"0.6\"/>\n";
  }

  double highest_;
  std::string svg_;
};

constexpr std::array kShades{"#555", "#aaa", "#eee"};

void append_bars(Chart& chart, double x, const std::array<Accuracy, 3>& stages) {
  double below = 0;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    chart.bar(x, 18, below, std::max(stages[k].average, below), kShades[k]);
    below = std::max(stages[k].average, below);
  }
}

}  // namespace

std::string to_table(const std::vector<ExperimentRow>& rows) {
  std::vector<TableRow> cells{{"object", "volume", "views", "average", "lowest", "highest",
                               "deviation", "grown: average", "lowest", "highest", "deviation"}};
  for (const ExperimentRow& row : rows) {
    for (std::size_t k = 0; k < kStages.size(); ++k) {
      TableRow line{k == 0 ? row.object : "",
                    k == 0 && row.volume > 0 ? with_decimals(row.volume, 4) : "",
                    std::to_string(kStages[k])};
      for (const Accuracy& a : {row.as_seen[k], row.grown[k]}) {
        line.push_back(percent(a.average));
        for (const double value : {a.lowest, a.highest, a.deviation})
          line.push_back(row.volume > 0 ? percent(value) : "");
      }
      cells.push_back(line);
    }
  }
  return align_columns(cells);
}

std::string to_csv(const std::vector<ExperimentRow>& rows) {
  std::string text = "object,volume,paper_volume,grown,views,average,lowest,highest,deviation\n";
  for (const ExperimentRow& row : rows) {
    if (row.volume == 0) continue;
    for (const bool grown : {false, true}) {
      for (std::size_t k = 0; k < kStages.size(); ++k) {
        const Accuracy& a = (grown ? row.grown : row.as_seen)[k];
        text.append(row.object).append(",").append(to_text(row.volume)).append(",");
        if (row.paper_volume > 0) text += to_text(row.paper_volume);
        text.append(grown ? ",1," : ",0,").append(std::to_string(kStages[k]));
        for (const double value : {a.average, a.lowest, a.highest, a.deviation})
          text.append(",").append(to_text(value));
        text += "\n";
      }
    }
  }
  return text;
}

std::string average_chart(const std::vector<ExperimentRow>& rows) {
  std::vector<std::string> labels;
  for (const ExperimentRow& row : rows) labels.push_back(row.object);
  Chart chart(labels,
              "object volume / octree volume, %: left as seen, right grown; dark 3, grey 9, light "
              "13 views",
              120);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    append_bars(chart, Chart::middle_of(i) - 20, rows[i].as_seen);
    append_bars(chart, Chart::middle_of(i) + 2, rows[i].grown);
  }
  return chart.finish();
}

std::string stability_chart(const std::vector<StabilityEntry>& entries) {
  std::vector<std::string> labels;
  double highest = 1;
  for (const StabilityEntry& entry : entries) {
    labels.push_back(entry.label);
    for (const Accuracy& accuracy : entry.stages) highest = std::max(highest, accuracy.highest);
  }
  Chart chart(labels, "object volume / octree volume, %, with 3, 9 and 13 views: range, average",
              20 * std::ceil(5 * highest));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t k = 0; k < kStages.size(); ++k) {
      const Accuracy& a = entries[i].stages[k];
      const double x = Chart::middle_of(i) - 22 + 15 * static_cast<double>(k);
      chart.bar(x, 13, a.lowest, a.highest, "#fff");
      chart.bar(x, 13, a.average - a.deviation / 2, a.average + a.deviation / 2, "#555");
    }
  }
  return chart.finish();
}

}  // namespace spoctree
