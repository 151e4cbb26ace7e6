// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtTest>

namespace txn::test {

/// For what surely comes, also on a machine that is busy with other things.
inline constexpr int kPatienceMs = 60000;

} // namespace txn::test

/// Fails unless the condition comes true.
#define TXN_COMES_TRUE(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, txn::test::kPatienceMs)

/// Fails unless the two become equal.
#define TXN_BECOMES(value, expected)                                                               \
    QTRY_COMPARE_WITH_TIMEOUT(value, expected, txn::test::kPatienceMs)

/// Fails unless value <= limit, also for NaN, and says both numbers. Define TXN_SHOW_ERRORS to see
/// how close the passing ones are.
#define TXN_AT_MOST(value, limit)                                                                  \
    do {                                                                                           \
        const double value_ = (value);                                                             \
        const double limit_ = (limit);                                                             \
        const QByteArray text_ = QByteArray(#value " is ") + QByteArray::number(value_, 'g', 6) +  \
                                 ", allowed are " + QByteArray::number(limit_, 'g', 6);            \
        TXN_SHOW_ERROR(text_);                                                                     \
        QVERIFY2(value_ <= limit_, text_.constData());                                             \
    } while (false)

#ifdef TXN_SHOW_ERRORS
#define TXN_SHOW_ERROR(text) qInfo("%s: %s", QTest::currentDataTag(), (text).constData())
#else
#define TXN_SHOW_ERROR(text) static_cast<void>(0)
#endif

/// Fails unless the Result holds a value; shows its message otherwise.
#define TXN_OK(result) QVERIFY2(bool(result), (result) ? "" : (result).error().message.c_str())

/// Fails unless the Result holds the error with that code and a message of one line.
#define TXN_FAILS_WITH(result, expected)                                                           \
    do {                                                                                           \
        const auto& result_ = (result);                                                            \
        QVERIFY2(!result_, "it should have failed");                                               \
        QCOMPARE(static_cast<int>(result_.error().code), static_cast<int>(expected));              \
        QVERIFY(!result_.error().message.empty());                                                 \
        QVERIFY(result_.error().message.find('\n') == std::string::npos);                          \
    } while (false)
