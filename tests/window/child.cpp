#include "window/child.hpp"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cstdlib>
#include <utility>

#include "base/text.hpp"

namespace terrella::test {
namespace {

void change_environment(const std::string& change) {
  const std::size_t equals = change.find('=');
  if (equals == std::string::npos) {
    unsetenv(change.c_str());
  } else {
    setenv(change.substr(0, equals).c_str(), change.c_str() + equals + 1, 1);
  }
}

// In the new process. Comes back only if it fails.
void become(const Child::Start& start) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // tests that are stopped leave nothing behind
#endif
  for (const std::string& change : start.environment) change_environment(change);
  if (chdir(start.folder.c_str()) != 0) return;
  if (!start.complaints.empty()) {
    const int file = open(start.complaints.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || dup2(file, STDERR_FILENO) < 0) return;
  }
  std::vector<char*> words;
  for (const std::string& word : start.command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
}

}  // namespace

Result<Child> Child::start(const Start& start) {
  // Closed by a program that has started; else it brings the reason why none did.
  int failure[2];
  if (pipe2(failure, O_CLOEXEC) != 0) return Failure{text_of("No pipe can be made: ", strerror(errno), '.')};
  const int process = fork();
  if (process == 0) {
    become(start);
    const int reason = errno;
    if (write(failure[1], &reason, sizeof reason) < 0) _exit(126);
    _exit(127);
  }
  close(failure[1]);
  int reason = process < 0 ? errno : 0;
  if (process > 0 && read(failure[0], &reason, sizeof reason) > 0) waitpid(process, nullptr, 0);
  close(failure[0]);
  if (reason != 0) return Failure{text_of(start.command[0], " cannot be run: ", strerror(reason), '.')};
  return Child(process);
}

Child::~Child() {
  if (ended()) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

Child::Child(Child&& other) noexcept : process_(std::exchange(other.process_, 0)), code_(other.code_) {}

std::optional<int> Child::ended() {
  if (process_ == 0) return code_;
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  process_ = 0;
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return code_;
}

std::chrono::nanoseconds Child::work() const {
  clockid_t clock = {};
  timespec time = {};
  if (process_ == 0 || clock_getcpuclockid(process_, &clock) != 0 || clock_gettime(clock, &time) != 0) return {};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace terrella::test
