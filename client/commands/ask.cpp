// classify and ray.

#include "client/queries/ask.hpp"

#include <vector>

#include "client/commands/commands.hpp"
#include "client/queries/number_lines.hpp"
#include "common/base/errors.hpp"
#include "common/program/output.hpp"

namespace spoctree {

namespace {

/// Reads questions from a file and checks them.
template <class OnQuestion>
void read(const AskArguments& arguments, const Question& question, OnQuestion&& on_question,
          const std::function<void()>& flush) {
  const std::string name = name_of_questions(arguments.questions);
  NumberLines lines(name, question.size(),
                    [&](std::uint64_t line, std::span<const double> numbers) {
                      if (const char* fault = question.fault(numbers)) {
                        throw BadInput(name + ": line " + std::to_string(line) + ": " + fault);
                      }
                      on_question(line, numbers);
                    });
  read_questions(arguments.questions, lines, flush);
}

/// One answer per question, in order, while they come.
void answer_each(const AskArguments& arguments, const Question& question) {
  LevelStream stream(arguments.stream);
  while (stream.next_level()) {
  }
  stream.progress_line().clear();
  const QueryIndex index(stream.tree(), stream.level());
  std::string answers;
  read(
      arguments, question,
      [&](std::uint64_t, std::span<const double> numbers) {
        question.answer(index, numbers, answers);
        answers += '\n';
      },
      [&] {
        print(answers);
        answers.clear();
      });
}

/// All questions first; then every level answers those that it can, as soon as it is there.
void answer_as_levels_arrive(const AskArguments& arguments, const Question& question) {
  const std::size_t size = question.size();
  std::vector<double> numbers;
  std::vector<std::uint64_t> open;  // lines, and from where on their numbers stand
  std::vector<std::size_t> first;
  read(
      arguments, question,
      [&](std::uint64_t line, std::span<const double> asked) {
        open.push_back(line);
        first.push_back(numbers.size());
        numbers.insert(numbers.end(), asked.begin(), asked.end());
      },
      [] {});
  LevelStream stream(arguments.stream);
  bool has_more = stream.next_level();
  while (has_more) {
    const std::string level = std::to_string(stream.level()) + ' ';
    stream.progress_line().clear();
    const QueryIndex index(stream.tree(), stream.level());
    std::string decided;
    std::string undecided;
    std::size_t kept = 0;
    std::string answer;
    for (std::size_t i = 0; i < open.size(); ++i) {
      answer.clear();
      const bool is_decided = question.answer(index, {numbers.data() + first[i], size}, answer);
      (is_decided ? decided : undecided) += level + std::to_string(open[i]) + ' ' + answer + '\n';
      if (is_decided) continue;
      open[kept] = open[i];
      first[kept++] = first[i];
    }
    open.resize(kept);
    print(decided);
    if (open.empty()) return;  // no need to receive the rest
    has_more = stream.next_level();
    if (!has_more) print(undecided);
  }
}

void ask(const AskArguments& arguments, const Question& question) {
  if (arguments.follow) {
    answer_as_levels_arrive(arguments, question);
  } else {
    answer_each(arguments, question);
  }
}

}  // namespace

void run_classify(const AskArguments& arguments) { ask(arguments, PointQuestion()); }

void run_ray(const AskArguments& arguments) { ask(arguments, RayQuestion()); }

}  // namespace spoctree
