#include "io/replaced_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <etendue/error.h>

namespace etendue {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
    throw FileError("cannot write '" + file + "': " + reason);
}

std::string system_reason(int code) { return std::generic_category().message(code); }

/// A link keeps pointing where it points: the file behind it is the one to replace.
fs::path follow_link(const std::string& file) {
    std::error_code error;
    const fs::path target = fs::canonical(file, error);
    return error ? fs::path(file) : target;
}

void check_target(const std::string& file, const fs::path& target) {
    if (file.empty()) fail(file, "the name is empty");
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) fail(file, "it is a directory");
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(file, "it exists and is not a regular file");
    // Renaming would replace a write-protected file without asking.
    if (fs::exists(status) && faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
        fail(file, system_reason(errno));
}

void check_directory(const std::string& file, const fs::path& directory) {
    std::error_code error;
    const fs::file_status status = fs::status(directory, error);
    const std::string name = directory.string();
    if (fs::is_directory(status)) return;
    if (fs::exists(status)) fail(file, "'" + name + "' is not a directory");
    if (status.type() == fs::file_type::not_found) fail(file, "there is no directory '" + name + "'");
    fail(file, error.message());
}

/// Creates a file that did not exist, with the permissions any new file gets.
std::string create_beside(const std::string& file, const fs::path& target, const fs::path& directory) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        std::string name = ".";
        name.append(target.filename().string()).append(".").append(std::to_string(getpid()));
        name.append("-").append(std::to_string(counter++)).append(".part");
        const fs::path path = directory / name;
        const int descriptor = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            close(descriptor);
            return path.string();
        }
        if (errno != EEXIST) fail(file, system_reason(errno));
    }
}

}  // namespace

ReplacedFile::ReplacedFile(const std::string& file) : file_(file) {
    const fs::path target = follow_link(file);
    const fs::path directory = target.has_parent_path() ? target.parent_path() : fs::path(".");
    check_directory(file, directory);
    check_target(file, target);
    target_ = target.string();
    temporary_ = create_beside(file, target, directory);
}

ReplacedFile::~ReplacedFile() {
    if (!committed_) unlink(temporary_.c_str());
}

void ReplacedFile::commit() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) fail(file_, error.message());
    committed_ = true;
}

}  // namespace etendue
