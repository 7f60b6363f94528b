// Real scenes, slightly broken: tokens deleted, doubled and swapped by a fixed seed. Each broken scene
// is read (every twentieth one rendered, too) by the whole command in a process of its own. It may
// succeed, or fail with an error that names a place; it may not crash, hang, trip a sanitizer or leave
// anything but a whole picture.
//
//     mutations COUNT FOLDER... [--only NUMBER] [--keep FOLDER] [--seconds CPU]
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "cli/run.h"

namespace {

namespace fs = std::filesystem;

constexpr uint64_t kSeed = 1525;  // the year of the woodcut
constexpr int kJobs = 2;
constexpr int kRenderEvery = 20;

struct Options {
  int count = 0;
  std::vector<fs::path> folders;
  int only = -1;        // this mutation alone
  fs::path keep;        // where the broken scenes go; empty: nowhere
  unsigned seconds = 20;  // of CPU time, for one scene
};

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> scenes_below(const std::vector<fs::path>& folders) {
  std::vector<fs::path> scenes;
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".pov") scenes.push_back(entry.path());
    }
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

// Pieces of the text: [begin, end) of words, numbers, strings and symbols. Comments are left out.
std::vector<std::pair<size_t, size_t>> tokens_of(const std::string& text) {
  static const std::regex kToken(
      R"re(//[^\n]*|/\*(?:[^*]|\*(?!/))*\*/|"[^"\n]*"|#\s*\w+|\w[\w.]*|[^\s\w])re",
      std::regex::ECMAScript | std::regex::optimize);
  std::vector<std::pair<size_t, size_t>> tokens;
  for (std::sregex_iterator it(text.begin(), text.end(), kToken), end; it != end; ++it) {
    if (it->str().starts_with("//") || it->str().starts_with("/*")) continue;
    const size_t begin = static_cast<size_t>(it->position());
    tokens.emplace_back(begin, begin + static_cast<size_t>(it->length()));
  }
  return tokens;
}

// Numbers, words and everything else: a swap within a class is noticed late or never.
int class_of(char first) {
  return std::isdigit(static_cast<unsigned char>(first)) ? 0
         : std::isalpha(static_cast<unsigned char>(first)) ? 1
                                                           : 2;
}

// One or two changes of the text.
std::string mutated(std::string text, std::mt19937_64& random) {
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  for (size_t changes = 1 + below(3) / 2; changes > 0; --changes) {
    const auto tokens = tokens_of(text);
    if (tokens.size() < 2) break;
    const auto token = [&](size_t i) {
      return text.substr(tokens[i].first, tokens[i].second - tokens[i].first);
    };
    const size_t first = below(tokens.size());
    const auto [begin, end] = tokens[first];
    switch (below(4)) {
      case 0:
        text.erase(begin, end - begin);
        break;
      case 1:
        text.insert(end, " " + token(first));
        break;
      default: {
        // Neighbours, any two, or (for half of them) two of one class.
        const size_t distance = below(4);
        size_t a = first, b = distance == 0 ? first + 1 : below(tokens.size());
        for (int tries = 0; distance > 1 && tries < 50; ++tries) {
          if (class_of(text[begin]) == class_of(text[tokens[b].first])) break;
          b = below(tokens.size());
        }
        if (b >= tokens.size() || a == b) break;
        if (a > b) std::swap(a, b);
        const std::string former = token(a), latter = token(b);
        text.replace(tokens[b].first, latter.size(), former);
        text.replace(tokens[a].first, former.size(), latter);
      }
    }
  }
  return text;
}

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

// In the child: the whole command, in its own folder.
[[noreturn]] void become_durer(const fs::path& folder, const fs::path& scene, bool render,
                               unsigned seconds) {
  if (chdir(folder.c_str()) != 0) _exit(99);
  const int out = open("messages", O_CREAT | O_TRUNC | O_WRONLY, 0644);
  dup2(out, 1);
  dup2(out, 2);
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_CORE, 0);
  alarm(10 * seconds);  // of waiting, whatever for
  std::vector<std::string> arguments = {"scene.pov",       "+W8", "+H6", "+WT1", "-D",
                                        "-GR",             "-GS", "+L" + scene.parent_path().string(),
                                        "--max-loop-turns", "20000"};
  if (render) {
    arguments.push_back("+Opicture.png");
  } else {
    arguments.push_back("--parse-only");
  }
  std::exit(durer::run(arguments));
}

struct Job {
  int number = 0;
  fs::path scene, folder;
  bool render = false;
};

// What is wrong with how a run ended; empty: nothing.
std::string complaint(const Job& job, int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL) return "hangs (CPU time)";
    if (signal == SIGALRM) return "hangs (wall time)";
    return std::string("dies by ") + strsignal(signal);
  }
  const std::string messages = content_of(job.folder / "messages");
  if (messages.find("Sanitizer") != std::string::npos ||
      messages.find("runtime error:") != std::string::npos) {
    return "trips a sanitizer";
  }
  const fs::path picture = job.folder / "picture.png";
  switch (WEXITSTATUS(status)) {
    case 0: {
      if (!job.render) return "";
      const std::string bytes = fs::exists(picture) ? content_of(picture) : "";
      return bytes.find("IEND") == std::string::npos ? "leaves no whole picture" : "";
    }
    case 1:
    case 3:
      if (fs::exists(picture)) return "leaves a picture after an error";
      if (!std::regex_search(messages, std::regex("(error|not supported yet|durer): "))) {
        return "fails without a message";
      }
      return "";
    default:
      return "ends with status " + std::to_string(WEXITSTATUS(status));
  }
}

class Campaign {
 public:
  explicit Campaign(const Options& options)
      : options_(options), scenes_(scenes_below(options.folders)) {
    char name[] = "/tmp/durer_mutations_XXXXXX";
    root_ = mkdtemp(name);
  }
  ~Campaign() { fs::remove_all(root_); }

  int run() {
    if (scenes_.empty()) {
      std::puts("there are no scenes");
      return 1;
    }
    for (int number = 0; number < options_.count; ++number) {
      if (options_.only >= 0 && number != options_.only) continue;
      while (running_.size() >= kJobs) collect();
      start(number);
    }
    while (!running_.empty()) collect();
    std::printf("%d mutations of %zu scenes, %d rendered: %d read without an error, %d bad\n", done_,
                scenes_.size(), rendered_, successes_, bad_);
    return bad_ > 0 || done_ == 0 ? 1 : 0;
  }

 private:
  void start(int number) {
    // Each number has its own stream, so that one can be repeated alone.
    std::mt19937_64 random(kSeed * 1000003 + static_cast<uint64_t>(number));
    Job job;
    job.number = number;
    job.scene = scenes_[static_cast<size_t>(number) % scenes_.size()];
    job.render = number % kRenderEvery == kRenderEvery - 1;
    job.folder = root_ / std::to_string(number);
    fs::create_directory(job.folder);
    std::ofstream(job.folder / "scene.pov", std::ios::binary) << mutated(content_of(job.scene), random);
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) become_durer(job.folder, job.scene, job.render, options_.seconds);
    running_[child] = job;
  }

  void collect() {
    int status = 0;
    const pid_t child = wait(&status);
    const Job job = running_[child];
    running_.erase(child);
    ++done_;
    rendered_ += job.render;
    successes_ += WIFEXITED(status) && WEXITSTATUS(status) == 0;
    const std::string what = complaint(job, status);
    if (!what.empty()) {
      ++bad_;
      std::printf("--only %d: %s %s\n%s\n", job.number, job.scene.c_str(), what.c_str(),
                  content_of(job.folder / "messages").substr(0, 4000).c_str());
    }
    if (!options_.keep.empty()) {
      fs::create_directories(options_.keep);
      fs::copy_file(job.folder / "scene.pov",
                    options_.keep / (std::to_string(job.number) + ".pov"),
                    fs::copy_options::overwrite_existing);
    }
    fs::remove_all(job.folder);
  }

  const Options& options_;
  std::vector<fs::path> scenes_;
  fs::path root_;
  std::map<pid_t, Job> running_;
  int done_ = 0, rendered_ = 0, successes_ = 0, bad_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--only" && i + 1 < argc) {
      options.only = std::atoi(argv[++i]);
    } else if (word == "--keep" && i + 1 < argc) {
      options.keep = argv[++i];
    } else if (word == "--seconds" && i + 1 < argc) {
      options.seconds = static_cast<unsigned>(std::atoi(argv[++i]));
    } else if (options.count == 0) {
      options.count = std::atoi(argv[i]);
    } else {
      options.folders.push_back(word);
    }
  }
  if (options.count <= 0 || options.folders.empty()) {
    std::puts("usage: mutations COUNT FOLDER... [--only NUMBER] [--keep FOLDER] [--seconds CPU]");
    return 2;
  }
  return Campaign(options).run();
}
