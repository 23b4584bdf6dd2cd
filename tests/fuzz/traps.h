#pragma once

namespace etendue::test {

/// While it lives, and `on`, an invalid floating-point operation of this thread, and of the threads that it starts,
/// ends the process by SIGFPE: 0/0, inf - inf, 0 inf, the root of a negative number, NaN compared by size, a number
/// made an integer that cannot hold it. A division by zero does not: renderer code may rely on 1/0 = inf.
class InvalidTraps {
public:
    explicit InvalidTraps(bool on);
    ~InvalidTraps();
    InvalidTraps(const InvalidTraps&) = delete;
    InvalidTraps& operator=(const InvalidTraps&) = delete;

private:
    int before_;  ///< the exceptions that were trapped
};

}  // namespace etendue::test
