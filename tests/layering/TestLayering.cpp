// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Include {
    fs::path file;      ///< relative to the root
    std::string folder; ///< "core/noise", "cli", ...
    std::string top;    ///< "core", "gl", "decoder", "app" or "cli"
    std::string target; ///< between the quotes or brackets
    bool quoted = false;
    int line = 0;

    QByteArray text() const {
        return QByteArray::fromStdString(file.string() + ":" + std::to_string(line) + " includes " +
                                         target);
    }
};

/// Every #include of the program's own folders, those of system headers too.
std::vector<Include> allIncludes() {
    const fs::path root = TXN_SOURCE_DIR;
    const std::regex pattern(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
    std::vector<Include> includes;
    for (const std::string top : {"core", "gl", "decoder", "app", "cli"}) {
        if (!fs::exists(root / top))
            continue; // not written yet
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const auto ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp")
                continue;
            std::ifstream stream(entry.path());
            std::string text;
            for (int line = 1; std::getline(stream, text); ++line) {
                std::smatch match;
                if (!std::regex_search(text, match, pattern))
                    continue;
                const fs::path file = fs::relative(entry.path(), root);
                includes.push_back({file,
                                    file.parent_path().generic_string(),
                                    top,
                                    match[2],
                                    match[1] == "\"",
                                    line});
            }
        }
    }
    return includes;
}

bool startsWithAny(const std::string& text, std::initializer_list<const char*> starts) {
    return std::any_of(starts.begin(), starts.end(), [&](const char* start) {
        return text.starts_with(start);
    });
}

/// <vector>, <cmath>, ...: neither a folder nor an ending, and lower case (Qt's are not).
bool isStandard(const std::string& target) {
    return target.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

bool isPosix(const std::string& target) {
    static const std::set<std::string> known{"dirent.h",
                                             "fcntl.h",
                                             "unistd.h",
                                             "pthread.h",
                                             "signal.h",
                                             "termios.h",
                                             "poll.h",
                                             "sched.h",
                                             "spawn.h",
                                             "malloc.h"};
    return known.contains(target) || target.starts_with("sys/");
}

using Edges = std::map<std::string, std::set<std::string>>;

/// What the folders of core and of app may include of one another. A new edge is a decision: it
/// belongs here and in docs/ARCHITECTURE.md, and must not close a circle.
const Edges& coreEdges() {
    static const Edges edges{
        {"base", {}},
        {"image", {"base"}},
        {"mesh", {"base"}},
        {"spectral", {"base", "image"}},
        {"material", {"base", "image"}},
        {"gaussian", {"base", "image", "material", "spectral"}},
        {"texton", {"base", "image", "spectral", "gaussian"}},
        {"mixing", {"base", "image", "spectral", "texton"}},
        {"noise", {"base", "image", "spectral", "texton", "mixing"}},
        {"qa", {"base", "image", "spectral", "gaussian", "texton"}},
        {"compute", {"base", "image", "gaussian", "texton", "qa"}},
        {"export",
         {"base", "image", "material", "spectral", "gaussian", "texton", "mixing", "noise"}},
        {"bake", {"base", "image", "material", "noise"}},
        {"sheet", {"base", "image", "texton"}},
        {"samples", {"base", "image", "spectral", "gaussian"}},
    };
    return edges;
}

/// The files beside these folders (Application, MainWindow, main) put everything together and may
/// include all of it.
const Edges& appEdges() {
    static const Edges edges{
        {"settings", {}},
        {"memory", {}},
        {"threads", {}},
        {"document", {"threads"}},
        {"display", {"memory"}},
        {"look", {"settings"}},
        {"jobs", {"threads", "document", "display"}},
        {"pipeline", {"threads", "document", "jobs", "look"}},
        {"export", {"settings", "document", "jobs"}},
        {"mixing", {"document", "jobs", "look", "pipeline"}},
        {"files", {"settings", "document", "display", "jobs", "look"}},
        {"widgets", {"settings", "document", "look"}},
        {"views",
         {"memory",
          "threads",
          "settings",
          "document",
          "display",
          "jobs",
          "look",
          "pipeline",
          "mixing"}},
        {"panels",
         {"settings",
          "document",
          "display",
          "export",
          "jobs",
          "look",
          "mixing",
          "pipeline",
          "views",
          "widgets"}},
    };
    return edges;
}

/// "noise" of "core/noise/NoiseGrid.h" or "core/noise"; empty for files beside the folders.
std::string folderWithin(const std::string& path, bool isFile) {
    const auto first = path.find('/');
    if (first == std::string::npos)
        return {};
    const auto second = path.find('/', first + 1);
    if (second == std::string::npos && isFile)
        return {};
    return path.substr(first + 1, second - first - 1);
}

} // namespace

/// Who may include what: docs/ARCHITECTURE.md, by the letter of the #include lines.
class TestLayering : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        m_includes = allIncludes();
        // The scan itself works: well-known lines are found.
        QVERIFY(m_includes.size() > 200);
        QVERIFY(std::any_of(m_includes.begin(), m_includes.end(), [](const Include& i) {
            return i.file == "core/spectral/Fft.cpp" && i.target == "fftw3.h" && !i.quoted;
        }));
        QVERIFY(std::any_of(m_includes.begin(), m_includes.end(), [](const Include& i) {
            return i.folder == "core/noise" && i.target == "core/texton/Texton.h" && i.quoted;
        }));
    }

    void ownHeadersAreNamedFromTheRoot() {
        for (const Include& include : m_includes) {
            if (!include.quoted)
                continue;
            // Qt's generated code is named as moc wants it.
            if (include.target.ends_with(".moc") && include.top == "app")
                continue;
            QVERIFY2(startsWithAny(include.target, {"core/", "gl/", "app/", "cli/"}),
                     include.text());
            QVERIFY2(fs::exists(fs::path(TXN_SOURCE_DIR) / include.target), include.text());
        }
        for (const Include& include : m_includes)
            QVERIFY2(include.quoted ||
                         !startsWithAny(include.target, {"core/", "gl/", "app/", "cli/", "txn"}),
                     include.text());
    }

    void nothingIncludesUpward() {
        const std::map<std::string, std::set<std::string>> allowed{{"core", {"core"}},
                                                                   {"gl", {"core", "gl"}},
                                                                   {"decoder", {"core"}},
                                                                   {"cli", {"core", "gl", "cli"}},
                                                                   {"app", {"core", "gl", "app"}}};
        for (const Include& include : m_includes) {
            if (include.quoted && !include.target.ends_with(".moc"))
                QVERIFY2(allowed.at(include.top)
                             .contains(include.target.substr(0, include.target.find('/'))),
                         include.text());
        }
    }

    /// A list of what is allowed, so that Qt, OpenGL and everything else new is noticed.
    void coreUsesTheAgreedLibrariesOnly() {
        for (const Include& include : m_includes) {
            if (include.top != "core" || include.quoted)
                continue;
            const std::string& target = include.target;
            const bool agreed =
                isStandard(target) || isPosix(target) ||
                startsWithAny(target, {"Eigen/", "tbb/", "oneapi/tbb", "nlohmann/", "glm/"}) ||
                (target == "fftw3.h" && include.folder == "core/spectral") ||
                ((target.starts_with("OpenImageIO/") || target == "lcms2.h" ||
                  target == "seccomp.h") &&
                 include.folder == "core/image") ||
                (target == "tiny_obj_loader.h" && include.folder == "core/mesh") ||
                (target == "lbfgs.h" && include.folder == "core/texton");
            QVERIFY2(agreed, include.text());
        }
    }

    /// The caller owns the context; gl only draws. Its public headers are free of OpenGL's, so that
    /// they may be included beside Qt's.
    void glUsesTheAgreedLibrariesOnly() {
        for (const Include& include : m_includes) {
            if (include.top != "gl" || include.quoted)
                continue;
            const std::string& target = include.target;
            const bool source = include.file.extension() == ".cpp";
            QVERIFY2(isStandard(target) || target.starts_with("glm/") ||
                         (source && (target == "epoxy/gl.h" || target == "epoxy/egl.h")),
                     include.text());
        }
    }

    void openGlAndQtStayWhereTheyBelong() {
        for (const Include& include : m_includes) {
            if (include.quoted)
                continue;
            const std::string& target = include.target;
            const bool gl =
                startsWithAny(target, {"GL/", "GLES", "EGL/", "epoxy/", "glad/", "KHR/"});
            const bool qt = target.starts_with("Qt") || (target.size() > 1 && target[0] == 'Q' &&
                                                         target[1] >= 'A' && target[1] <= 'Z');
            QVERIFY2(!gl || include.top == "gl", include.text());
            QVERIFY2(!qt || include.top == "app", include.text());
            // One place for each of these libraries.
            QVERIFY2(target != "fftw3.h" || include.folder == "core/spectral", include.text());
            QVERIFY2(target != "tiny_obj_loader.h" || include.folder == "core/mesh",
                     include.text());
            QVERIFY2((!target.starts_with("OpenImageIO/") && target != "lcms2.h") ||
                         include.folder == "core/image",
                     include.text());
        }
    }

    void foldersFollowTheTables_data() {
        QTest::addColumn<QString>("top");
        QTest::newRow("core") << "core";
        QTest::newRow("app") << "app";
    }
    void foldersFollowTheTables() {
        QFETCH(QString, top);
        const Edges& edges = top == "core" ? coreEdges() : appEdges();
        for (const Include& include : m_includes) {
            if (include.top != top.toStdString() || !include.quoted ||
                !include.target.starts_with(include.top + "/"))
                continue;
            const std::string from = folderWithin(include.folder, false);
            const std::string to = folderWithin(include.target, true);
            if (from == to || from.empty())
                continue;
            QVERIFY2(edges.contains(from), include.text());
            QVERIFY2(edges.at(from).contains(to), include.text());
        }
    }

    void theTablesHaveNoCircles_data() { foldersFollowTheTables_data(); }
    void theTablesHaveNoCircles() {
        QFETCH(QString, top);
        // Taking away folders that need nothing but what is gone already leaves nothing.
        auto edges = top == "core" ? coreEdges() : appEdges();
        std::set<std::string> done;
        for (bool moved = true; moved;) {
            moved = false;
            for (auto it = edges.begin(); it != edges.end();) {
                const bool free =
                    std::all_of(it->second.begin(), it->second.end(), [&](const auto& name) {
                        return done.contains(name);
                    });
                if (free) {
                    done.insert(it->first);
                    it = edges.erase(it);
                    moved = true;
                } else {
                    ++it;
                }
            }
        }
        QVERIFY2(edges.empty(), edges.empty() ? "" : edges.begin()->first.c_str());
    }

  private:
    std::vector<Include> m_includes;
};

QTEST_APPLESS_MAIN(TestLayering)
#include "TestLayering.moc"
