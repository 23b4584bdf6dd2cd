#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include <etendue/error.h>
#include <etendue/image_io.h>

#include "core/io/temporary_directory.h"
#include "core/io/test_image.h"
#include "io/replaced_file.h"

namespace etendue {
namespace {

namespace fs = std::filesystem;

/// Permissions do not bind root: for the life of the object the process is somebody else, if it was root.
class OrdinaryUser {
public:
    OrdinaryUser() {
        constexpr uid_t nobody = 65534;
        if (was_root_ && seteuid(nobody) != 0) ADD_FAILURE() << "cannot become another user";
    }
    ~OrdinaryUser() {
        if (was_root_ && seteuid(0) != 0) ADD_FAILURE() << "cannot become root again";
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

private:
    bool was_root_ = geteuid() == 0;
};

std::string refusal(const std::string& file) {
    try {
        check_writable(file);
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

void write_text(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

std::string read_text(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ImageFileKind, IsInTheExtension) {
    EXPECT_EQ(image_file_kind("a/b.c/x.exr"), ImageFileKind::SceneLinear);
    EXPECT_EQ(image_file_kind("X.EXR"), ImageFileKind::SceneLinear);
    for (const char* file : {"x.png", "x.tif", "x.tiff", "x.jpg", "x.y.JPEG"}) {
        EXPECT_EQ(image_file_kind(file), ImageFileKind::Display) << file;
    }
    for (const char* file : {"x", "x.", "x.gif", "exr", ".exr", "dir.exr/x", ""}) {
        EXPECT_THROW((void)image_file_kind(file), SettingsError) << file;
    }
}

TEST(CheckWritable, LeavesNothingBehind) {
    const TemporaryDirectory directory;
    check_writable(directory.file("x.exr"));
    EXPECT_EQ(directory.count(), 0);
    write_text(directory.file("old.exr"), "old");
    check_writable(directory.file("old.exr"));
    EXPECT_EQ(directory.count(), 1);
    EXPECT_EQ(read_text(directory.file("old.exr")), "old");
}

TEST(CheckWritable, SaysWhyNot) {
    const TemporaryDirectory directory;
    const std::string no_directory = directory.file("no/x.exr");
    EXPECT_EQ(refusal(no_directory),
              "cannot write '" + no_directory + "': there is no directory '" + directory.file("no") + "'");
    EXPECT_EQ(refusal(directory.path().string()),
              "cannot write '" + directory.path().string() + "': it is a directory");
    write_text(directory.file("plain"), "");
    const std::string below_file = directory.file("plain/x.exr");
    EXPECT_EQ(refusal(below_file),
              "cannot write '" + below_file + "': '" + directory.file("plain") + "' is not a directory");
    ASSERT_EQ(mkfifo(directory.file("pipe.exr").c_str(), 0600), 0);
    EXPECT_EQ(refusal(directory.file("pipe.exr")),
              "cannot write '" + directory.file("pipe.exr") + "': it exists and is not a regular file");
    EXPECT_EQ(refusal(""), "cannot write '': the name is empty");
    EXPECT_EQ(directory.count(), 2);
}

TEST(CheckWritable, RespectsPermissions) {
    const TemporaryDirectory directory;
    const std::string in_locked = directory.file("locked/x.exr");
    fs::create_directory(directory.file("locked"));
    const std::string protected_file = directory.file("open/x.exr");
    fs::create_directory(directory.file("open"));
    write_text(protected_file, "old");
    fs::permissions(directory.path(), fs::perms(0755));
    fs::permissions(directory.file("locked"), fs::perms(0555));
    fs::permissions(directory.file("open"), fs::perms(0777));
    fs::permissions(protected_file, fs::perms(0444));
    std::string locked;
    std::string write_protected;
    std::string allowed;
    {
        const OrdinaryUser user;
        locked = refusal(in_locked);
        write_protected = refusal(protected_file);
        allowed = refusal(directory.file("open/y.exr"));
    }
    fs::permissions(directory.file("locked"), fs::perms(0755));
    EXPECT_EQ(locked, "cannot write '" + in_locked + "': Permission denied");
    EXPECT_EQ(write_protected, "cannot write '" + protected_file + "': Permission denied");
    EXPECT_EQ(allowed, "accepted");
}

TEST(WriteExr, FailsAsCheckWritableSays) {
    const TemporaryDirectory directory;
    const RenderedImage image = numbered_image(1, 1, {Aov::Color});
    EXPECT_THROW(write_exr(directory.file("no/x.exr"), image, {}), FileError);
    fs::create_directory(directory.file("x.exr"));
    EXPECT_THROW(write_exr(directory.file("x.exr"), image, {}), FileError);
    EXPECT_EQ(directory.count(), 1);
}

TEST(ReplacedFile, KeepsTheOldFileUntilCommitted) {
    const TemporaryDirectory directory;
    const std::string file = directory.file("x.exr");
    write_text(file, "old");
    {
        const ReplacedFile abandoned(file);
        write_text(abandoned.temporary(), "half");
        EXPECT_EQ(read_text(file), "old");
    }
    EXPECT_EQ(read_text(file), "old");
    EXPECT_EQ(directory.count(), 1);
    {
        ReplacedFile finished(file);
        write_text(finished.temporary(), "new");
        finished.commit();
    }
    EXPECT_EQ(read_text(file), "new");
    EXPECT_EQ(directory.count(), 1);
}

TEST(ReplacedFile, TwoWritersDoNotShareATemporaryFile) {
    const TemporaryDirectory directory;
    const ReplacedFile first(directory.file("x.exr"));
    const ReplacedFile second(directory.file("x.exr"));
    EXPECT_NE(first.temporary(), second.temporary());
    EXPECT_EQ(fs::path(first.temporary()).parent_path(), directory.path());
}

TEST(ReplacedFile, FollowsALink) {
    const TemporaryDirectory directory;
    fs::create_directory(directory.file("elsewhere"));
    write_text(directory.file("elsewhere/real.exr"), "old");
    fs::create_symlink("elsewhere/real.exr", directory.file("link.exr"));
    ReplacedFile replaced(directory.file("link.exr"));
    write_text(replaced.temporary(), "new");
    replaced.commit();
    EXPECT_TRUE(fs::is_symlink(directory.file("link.exr")));
    EXPECT_EQ(read_text(directory.file("elsewhere/real.exr")), "new");
}

TEST(ReplacedFile, HasThePermissionsOfAnyNewFile) {
    const TemporaryDirectory directory;
    const mode_t before = umask(022);
    ReplacedFile replaced(directory.file("x.exr"));
    replaced.commit();
    umask(before);
    EXPECT_EQ(fs::status(directory.file("x.exr")).permissions(), fs::perms(0644));
}

TEST(ReplacedFile, NamesWithoutADirectoryMeanTheCurrentOne) {
    const TemporaryDirectory directory;
    const fs::path before = fs::current_path();
    fs::current_path(directory.path());
    EXPECT_EQ(refusal("x.exr"), "accepted");
    write_exr("x.exr", numbered_image(1, 1, {Aov::Color}), {});
    fs::current_path(before);
    EXPECT_TRUE(fs::exists(directory.file("x.exr")));
}

}  // namespace
}  // namespace etendue
