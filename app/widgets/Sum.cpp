// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/Sum.h"

#include <cmath>

namespace txn::app {
namespace {

/// By recursive descent; depth is bounded, so that no text can exhaust the stack.
class Parser {
  public:
    explicit Parser(const QString& text) : m_text(text) {}

    std::optional<double> parse() {
        const double value = sum(0);
        skipSpaces();
        if (m_failed || m_at != m_text.size() || !std::isfinite(value))
            return std::nullopt;
        return value;
    }

  private:
    static constexpr int kDeepest = 64;

    void skipSpaces() {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
    }
    bool take(char wanted) {
        skipSpaces();
        if (m_at >= m_text.size() || m_text[m_at] != QLatin1Char(wanted))
            return false;
        ++m_at;
        return true;
    }
    double sum(int depth) {
        double value = product(depth);
        while (!m_failed) {
            if (take('+'))
                value += product(depth);
            else if (take('-'))
                value -= product(depth);
            else
                break;
        }
        return value;
    }
    double product(int depth) {
        double value = factor(depth);
        while (!m_failed) {
            if (take('*'))
                value *= factor(depth);
            else if (take('/'))
                value /= factor(depth);
            else
                break;
        }
        return value;
    }
    double factor(int depth) {
        if (depth > kDeepest) {
            m_failed = true;
            return 0.0;
        }
        if (take('-'))
            return -factor(depth + 1);
        if (take('+'))
            return factor(depth + 1);
        if (take('(')) {
            const double value = sum(depth + 1);
            m_failed = m_failed || !take(')');
            return value;
        }
        return number();
    }
    double number() {
        skipSpaces();
        QString digits;
        while (m_at < m_text.size() &&
               (m_text[m_at].isDigit() || m_text[m_at] == QLatin1Char('.') ||
                m_text[m_at] == QLatin1Char(','))) {
            const QChar c = m_text[m_at++];
            digits += c == QLatin1Char(',') ? QLatin1Char('.')
                      : c.isDigit()         ? QChar('0' + c.digitValue())
                                            : c;
        }
        bool ok = false;
        const double value = digits.toDouble(&ok);
        m_failed = m_failed || !ok;
        return value;
    }

    const QString& m_text;
    qsizetype m_at = 0;
    bool m_failed = false;
};

} // namespace

std::optional<double> evaluateSum(const QString& text) {
    return Parser(text).parse();
}

} // namespace txn::app
