#include "fuzz/supervisor.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

namespace etendue::test {
namespace {

constexpr std::uint64_t kSeedsPerProcess = 1000;
/// Of one trial; most take a hundredth of a second.
constexpr double kCpuDeadline = 120;
constexpr double kDeadline = 600;

using Clock = std::chrono::steady_clock;

double seconds_of(clockid_t clock) {
    timespec t{};
    return clock_gettime(clock, &t) == 0 ? static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec) : 0;
}

/// What the worker tells its supervisor; lies in memory that both see.
struct Report {
    std::atomic<std::uint64_t> seed{0};
    std::atomic<std::uint64_t> rendered{0};
    std::atomic<std::uint64_t> refused{0};
    std::atomic<std::uint64_t> findings{0};
};

Report& shared_report() {
    void* memory = mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no shared memory");
    return *new (memory) Report;
}

void say(std::uint64_t seed, const std::string& what) {
    std::fprintf(stderr, "seed %llu: %s\n", static_cast<unsigned long long>(seed), what.c_str());
}

void run_one(std::uint64_t seed, const std::function<Outcome(std::uint64_t)>& trial, Report& report) {
    try {
        auto& kind = trial(seed).rendered ? report.rendered : report.refused;
        ++kind;
    } catch (const std::exception& error) {
        ++report.findings;
        say(seed, error.what());
    }
}

bool leaks() {
#ifdef __SANITIZE_ADDRESS__
    return __lsan_do_recoverable_leak_check() != 0;
#else
    return false;
#endif
}

[[noreturn]] void work(const Seeds& seeds, const std::function<Outcome(std::uint64_t)>& trial, Report& report) {
    for (std::uint64_t seed = seeds.first; seed - seeds.first < seeds.count; ++seed) {
        if (seconds_of(CLOCK_PROCESS_CPUTIME_ID) > seeds.seconds) break;
        report.seed = seed;
        run_one(seed, trial, report);
    }
    report.seed = std::numeric_limits<std::uint64_t>::max();
    // Not exit: libraries wait there for threads that they had before the fork.
    _exit(leaks() ? EXIT_FAILURE : EXIT_SUCCESS);
}

/// Sees to it that one process gets on.
class Watch {
public:
    Watch(pid_t pid, const Report& report) : pid_(pid), report_(report) { (void)clock_getcpuclockid(pid, &clock_); }

    /// Its status once it has ended, by itself or because it no longer got on.
    int wait() {
        int status = 0;
        while (waitpid(pid_, &status, WNOHANG) == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            look();
        }
        return status;
    }
    /// CPU seconds when last looked at.
    [[nodiscard]] double cpu() const { return cpu_; }

private:
    void look() {
        cpu_ = std::max(cpu_, seconds_of(clock_));
        if (report_.seed != seed_) {
            seed_ = report_.seed;
            cpu_of_seed_ = cpu_;
            since_ = Clock::now();
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - since_).count();
        if (cpu_ - cpu_of_seed_ > kCpuDeadline || seconds > kDeadline) kill(pid_, SIGKILL);
    }

    pid_t pid_;
    const Report& report_;
    clockid_t clock_{};
    double cpu_ = 0;
    std::uint64_t seed_ = 0;
    double cpu_of_seed_ = 0;
    Clock::time_point since_ = Clock::now();
};

std::string how_it_ended(int status) {
    if (WIFEXITED(status)) return "ended the process with status " + std::to_string(WEXITSTATUS(status));
    const int signal = WTERMSIG(status);
    if (signal == SIGKILL) return "does not end";
    return "ended the process by signal " + std::to_string(signal);
}

void show(const Report& report, double cpu) {
    const auto scenes = static_cast<double>(report.rendered + report.refused + report.findings);
    std::fprintf(stderr, "%.0f scenes in %.0f CPU seconds (%.1f a second): %.1f %% rendered, %llu findings\n", scenes,
                 cpu, scenes / std::max(cpu, 1e-9), 100 * static_cast<double>(report.rendered) / std::max(scenes, 1.0),
                 static_cast<unsigned long long>(report.findings.load()));
}

}  // namespace

Tally supervise(const Seeds& seeds, const std::function<Outcome(std::uint64_t)>& trial) {
    Report& report = shared_report();
    const std::uint64_t end = seeds.first + seeds.count;
    std::uint64_t next = seeds.first;
    double cpu = 0;
    while (next < end && cpu < seeds.seconds) {
        const Seeds part{next, std::min(end - next, kSeedsPerProcess), seeds.seconds - cpu};
        report.seed = next;
        const pid_t pid = fork();
        if (pid < 0) throw std::runtime_error("no process");
        if (pid == 0) work(part, trial, report);
        Watch watch(pid, report);
        const int status = watch.wait();
        cpu += watch.cpu();
        next = part.first + part.count;
        if (status != 0) {
            ++report.findings;
            const bool through = report.seed == std::numeric_limits<std::uint64_t>::max();
            say(through ? part.first : report.seed.load(), through ? "one of a thousand leaks" : how_it_ended(status));
            if (!through) next = report.seed + 1;
        }
        show(report, cpu);
    }
    return {report.rendered, report.refused, report.findings};
}

}  // namespace etendue::test
