#include "drape/external/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <thread>

namespace toile::external {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double patience = 2;  // s between asking a child to end and ending it

double since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

// A running process group, ended with its owner.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { end(); }

  // Whether it has ended; then its status is kept.
  bool ended() {
    while (!ended_) {
      const pid_t got = waitpid(id_, &status_, WNOHANG);
      if (got == 0) return false;
      if (got < 0 && errno == EINTR) continue;
      ended_ = true;
      kill(-id_, SIGKILL);  // what it may have started
    }
    return true;
  }

  void end() {
    if (ended()) return;
    kill(-id_, SIGTERM);
    for (const auto asked = Clock::now(); since(asked) < patience && !ended();)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (ended()) return;
    kill(-id_, SIGKILL);
    while (waitpid(id_, &status_, 0) < 0 && errno == EINTR) {
    }
    ended_ = true;
  }

  int status() const { return status_; }

 private:
  pid_t id_;
  int status_ = 0;
  bool ended_ = false;
};

// Between fork and exec, where nothing but system calls is allowed. Tells `errno` through `trouble` when it fails.
[[noreturn]] void become(char* const* command, const char* folder, int out, int err, int in, int trouble, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() == parent && chdir(folder) == 0 && dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && dup2(err, 2) >= 0)
    execv(command[0], command);
  const int number = errno;
  [[maybe_unused]] const ssize_t told = write(trouble, &number, sizeof number);
  _exit(127);
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {
    if (number < 0) throw std::system_error(errno, std::generic_category());
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

Descriptor file_for_writing(const fs::path& file) {
  return Descriptor(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
}

pid_t start(const ChildOrder& order) {
  std::vector<std::string> words = order.command;
  std::vector<char*> command;
  for (std::string& word : words) command.push_back(word.data());
  command.push_back(nullptr);
  const Descriptor out = file_for_writing(order.folder / "stdout.txt"), err = file_for_writing(order.folder / "stderr.txt");
  const Descriptor in(open("/dev/null", O_RDONLY | O_CLOEXEC));
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
  Descriptor hear(ends[0]), tell(ends[1]);
  const pid_t parent = getpid(), id = fork();
  if (id < 0) throw std::system_error(errno, std::generic_category());
  if (id == 0) become(command.data(), order.folder.c_str(), out.number(), err.number(), in.number(), tell.number(), parent);
  setpgid(id, id);  // whoever comes first
  tell.close();
  int number = 0;
  ssize_t heard = 0;
  while ((heard = read(hear.number(), &number, sizeof number)) < 0 && errno == EINTR) {
  }
  if (heard > 0) {
    while (waitpid(id, nullptr, 0) < 0 && errno == EINTR) {
    }
    throw std::system_error(number, std::generic_category());
  }
  return id;
}

}  // namespace

ChildOutcome run_child(const ChildOrder& order) {
  const auto began = Clock::now();
  Child child(start(order));
  auto pause = std::chrono::milliseconds(1);
  while (!child.ended()) {
    const bool out_of_time = order.time_limit && since(began) > *order.time_limit;
    if (out_of_time || (order.stop && order.stop())) {
      child.end();
      return {out_of_time ? ChildEnd::out_of_time : ChildEnd::stopped, 0};
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
  if (WIFSIGNALED(child.status())) return {ChildEnd::signalled, WTERMSIG(child.status())};
  return {ChildEnd::exited, WEXITSTATUS(child.status())};
}

fs::path find_on_path(const std::string& name) {
  const auto is_program = [](const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return is_program(name) ? fs::absolute(name) : fs::path();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && is_program(fs::path(folder) / name)) return fs::absolute(fs::path(folder) / name);
  return {};
}

std::string last_words(const fs::path& folder, std::size_t most) {
  for (const char* name : {"stderr.txt", "stdout.txt"}) {
    std::ifstream in(folder / name, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    if (text.empty()) continue;
    if (text.size() <= most) return text;
    const std::size_t line = text.find('\n', text.size() - most);
    return line == std::string::npos ? text.substr(text.size() - most) : text.substr(line + 1);
  }
  return {};
}

}  // namespace toile::external
