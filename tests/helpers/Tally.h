// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdio>
#include <map>

namespace txn::test {

/// Whether to do all that docs/RELIABILITY.md speaks of, or a short form of it.
inline bool isLong() {
    return qEnvironmentVariable("TXN_TORTURE") == QLatin1String("long");
}

/// How often each promise was put to the test, and how often it was broken: a line of JSON for
/// each, as script/torture reads them, when it ends.
class Tally {
  public:
    Tally() = default;
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;
    ~Tally() {
        for (const auto& [name, count] : m_counts)
            std::printf("{\"name\": \"%s\", \"runs\": %d, \"bad\": %d}\n",
                        qPrintable(name),
                        count.runs,
                        count.bad);
        std::fflush(stdout);
    }

    /// One try; problem: empty if all was well. where: which try that was.
    void count(const QString& name, const QString& problem, const QString& where = {}) {
        Count& count = m_counts[name];
        ++count.runs;
        if (problem.isEmpty())
            return;
        ++count.bad;
        std::fprintf(stderr,
                     "%s: %s: %s\n",
                     qPrintable(name),
                     qPrintable(where),
                     qPrintable(problem.trimmed()));
    }
    int bad() const {
        int sum = 0;
        for (const auto& [name, count] : m_counts)
            sum += count.bad;
        return sum;
    }

  private:
    struct Count {
        int runs = 0;
        int bad = 0;
    };
    std::map<QString, Count> m_counts;
};

} // namespace txn::test
