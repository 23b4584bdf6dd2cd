#pragma once

#include <string>

namespace etendue {

/// Writes a file by way of a temporary one in the same directory, so that its name never shows half a file and what was
/// there before survives a failure.
class ReplacedFile {
public:
    /// Creates the temporary file. Throws FileError naming `file` and the reason.
    explicit ReplacedFile(const std::string& file);
    /// Removes the temporary file unless it was committed.
    ~ReplacedFile();
    ReplacedFile(const ReplacedFile&) = delete;
    ReplacedFile& operator=(const ReplacedFile&) = delete;

    [[nodiscard]] const std::string& temporary() const { return temporary_; }

    /// Gives the temporary file its name. Throws FileError.
    void commit();

private:
    std::string file_;    ///< as asked for, for messages
    std::string target_;  ///< the same with a symbolic link followed
    std::string temporary_;
    bool committed_ = false;
};

}  // namespace etendue
