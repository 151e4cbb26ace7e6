// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace txn {

enum class ErrorCode {
    InvalidArgument, ///< a value out of its range
    NotFound,        ///< no such file
    Unreadable,      ///< the file exists and cannot be read as what it should be
    Unwritable,      ///< the output cannot be written
    TooLarge,        ///< more samples or memory than can be dealt with
    OverBudget,      ///< more than was allowed, and the caller may allow more
    Unsupported,     ///< a valid request that this file type or method cannot serve
    SizeMismatch,    ///< two inputs do not fit together
    Degenerate,      ///< the data has no variance, or is not finite
    Cancelled,       ///< the caller asked to stop; never shown as an error
};

/// What went wrong. message is one line in plain English: what, which file, what to do.
struct Error {
    ErrorCode code = ErrorCode::InvalidArgument;
    std::string message;
};

/// A value or an Error, for everything that a user or a file can cause. Broken preconditions
/// of the program itself are assertions instead.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return m_state.index() == 0; }

    T& value() & { return *std::get_if<0>(&m_state); }
    const T& value() const& { return *std::get_if<0>(&m_state); }
    T&& value() && { return std::move(*std::get_if<0>(&m_state)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const Error& error() const {
        assert(!*this);
        return *std::get_if<1>(&m_state);
    }

  private:
    std::variant<T, Error> m_state;
};

template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : m_error(std::move(error)), m_failed(true) {}

    explicit operator bool() const { return !m_failed; }
    const Error& error() const { return m_error; }

  private:
    Error m_error;
    bool m_failed = false;
};

} // namespace txn
