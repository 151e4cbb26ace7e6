// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace txn;
namespace fs = std::filesystem;

namespace {

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace

class TestOutputFiles : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_dir = std::make_unique<QTemporaryDir>();
        QVERIFY(m_dir->isValid());
        m_path = m_dir->path().toStdString();
    }

    void commitPutsAllFilesInPlace() {
        write(m_path / "old.txt", "old");
        OutputFiles files;
        QVERIFY(bool(files.addText(m_path / "old.txt", "new")));
        const auto temporary = files.add(m_path / "data.bin");
        QVERIFY(bool(temporary));
        write(*temporary, "data");
        QCOMPARE(contentOf(m_path / "old.txt"), std::string("old"));
        QVERIFY(!fs::exists(m_path / "data.bin"));

        QVERIFY(bool(files.commit()));
        QCOMPARE(contentOf(m_path / "old.txt"), std::string("new"));
        QCOMPARE(contentOf(m_path / "data.bin"), std::string("data"));
        QCOMPARE(entries(), 2);
    }

    void nothingIsLeftWithoutCommit() {
        write(m_path / "old.txt", "old");
        {
            OutputFiles files;
            QVERIFY(bool(files.addText(m_path / "old.txt", "new")));
            QVERIFY(bool(files.addText(m_path / "other.txt", "new")));
            QCOMPARE(contentOf(m_path / "old.txt"), std::string("old"));
        }
        QCOMPARE(entries(), 1);
        QCOMPARE(contentOf(m_path / "old.txt"), std::string("old"));
    }

    void movedFromOwnsNothing() {
        OutputFiles files;
        QVERIFY(bool(files.addText(m_path / "a.txt", "a")));
        OutputFiles other = std::move(files);
        OutputFiles third;
        QVERIFY(bool(third.addText(m_path / "b.txt", "b")));
        third = std::move(other); // drops b
        QVERIFY(bool(third.commit()));
        QVERIFY(fs::exists(m_path / "a.txt"));
        QVERIFY(!fs::exists(m_path / "b.txt"));
        QCOMPARE(entries(), 1);
    }

    void linksAreFollowed() {
        fs::create_directory(m_path / "real");
        write(m_path / "real" / "file.txt", "old");
        fs::create_symlink("real/file.txt", m_path / "link.txt");
        OutputFiles files;
        QVERIFY(bool(files.addText(m_path / "link.txt", "new")));
        QVERIFY(bool(files.commit()));
        QVERIFY(fs::is_symlink(m_path / "link.txt"));
        QCOMPARE(contentOf(m_path / "real" / "file.txt"), std::string("new"));
    }

    void linksToNothingAreFollowed() {
        fs::create_directory(m_path / "real");
        fs::create_symlink("real/none.txt", m_path / "dangling.txt");
        OutputFiles files;
        QVERIFY(bool(files.addText(m_path / "dangling.txt", "first")));
        QVERIFY(bool(files.commit()));
        QVERIFY(fs::is_symlink(m_path / "dangling.txt"));
        QCOMPARE(contentOf(m_path / "real" / "none.txt"), std::string("first"));
    }

    void permissionsAreKept() {
        write(m_path / "old.txt", "old");
        QCOMPARE(::chmod((m_path / "old.txt").c_str(), 0640), 0);
        const mode_t mask = ::umask(022);
        OutputFiles files;
        const bool added = bool(files.addText(m_path / "old.txt", "new")) &&
                           bool(files.addText(m_path / "new.txt", "new"));
        ::umask(mask);
        QVERIFY(added);
        QVERIFY(bool(files.commit()));
        struct stat info {};
        QCOMPARE(::stat((m_path / "old.txt").c_str(), &info), 0);
        QCOMPARE(info.st_mode & 0777U, 0640U);
        QCOMPARE(::stat((m_path / "new.txt").c_str(), &info), 0);
        QCOMPARE(info.st_mode & 0777U, 0644U);
    }

    void refusals_data() {
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("says");
        QTest::newRow("folder") << "folder"
                                << "folder";
        QTest::newRow("missing folder") << "none/file.txt"
                                        << "no folder";
        QTest::newRow("below a file") << "plain/file.txt"
                                      << "no folder";
        QTest::newRow("pipe") << "pipe"
                              << "not a plain file";
        QTest::newRow("no name") << "folder/"
                                 << "folder";
    }

    void refusals() {
        QFETCH(QString, target);
        QFETCH(QString, says);
        fs::create_directory(m_path / "folder");
        write(m_path / "plain", "x");
        QCOMPARE(::mkfifo((m_path / "pipe").c_str(), 0600), 0);
        const int before = entries();
        OutputFiles files;
        const auto result = files.add(m_path / target.toStdString());
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Unwritable);
        const QString message = QString::fromStdString(result.error().message);
        QVERIFY2(message.contains(says), qPrintable(message));
        QVERIFY(!message.contains('\n'));
        QCOMPARE(entries(), before);
    }

    void aReadOnlyFileIsNotReplaced() {
        if (::geteuid() == 0)
            QSKIP("the superuser may write everything");
        write(m_path / "fixed.txt", "old");
        QCOMPARE(::chmod((m_path / "fixed.txt").c_str(), 0400), 0);
        OutputFiles files;
        QVERIFY(!files.add(m_path / "fixed.txt"));
    }

    void anyNameWillDo() {
        const fs::path longest = m_path / std::string(255, 'n');
        const fs::path strange = m_path / "a b\n'\xc3\xa9%s.txt";
        OutputFiles files;
        QVERIFY(bool(files.addText(longest, "1")));
        QVERIFY(bool(files.addText(strange, "2")));
        QVERIFY(bool(files.commit()));
        QCOMPARE(contentOf(longest), std::string("1"));
        QCOMPARE(contentOf(strange), std::string("2"));
    }

    void aKillLeavesNothing() {
        const pid_t child = ::fork();
        if (child == 0) {
            OutputFiles files;
            const bool added = bool(files.addText(m_path / "new.txt", "half of it"));
            ::raise(added ? SIGKILL : SIGTERM);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFSIGNALED(status));
        QCOMPARE(WTERMSIG(status), SIGKILL);
        QCOMPARE(entries(), 0);
    }

    void tooLongANameIsToldBeforeTheWork() {
        OutputFiles files;
        const auto result = files.add(m_path / std::string(256, 'n'));
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Unwritable);
    }

    void oneFileTwiceIsRefused() {
        OutputFiles files;
        QVERIFY(bool(files.add(m_path / "a.txt")));
        QVERIFY(!files.add(m_path / "." / "a.txt"));
    }

    void quotedStaysOnOneLine() {
        QCOMPARE(quoted("a\nb\tc.png"), std::string("'a?b?c.png'"));
        QCOMPARE(quoted("plain.png"), std::string("'plain.png'"));
    }

  private:
    int entries() const {
        int count = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(m_path))
            ++count;
        return count;
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    fs::path m_path;
};

QTEST_GUILESS_MAIN(TestOutputFiles)
#include "TestOutputFiles.moc"
