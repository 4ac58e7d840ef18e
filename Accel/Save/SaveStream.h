// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Save_SaveStream_h
#define Lumitree_Accel_Save_SaveStream_h

#include "Accel/Save.h"

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lumitree
{

/// Numbers into bytes, as this machine orders them.
class SaveWriter
{
public:
  template <class T>
  void put(T value)
  {
    static_assert(std::is_arithmetic_v<T>);
    this->append(&value, sizeof(T));
  }

  /// Without their number.
  template <class T>
  void putAll(const std::vector<T>& values)
  {
    static_assert(std::is_arithmetic_v<T>);
    this->append(values.data(), values.size() * sizeof(T));
  }

  void append(const void* data, std::size_t size)
  {
    if (size > 0)
    {
      this->bytes_.append(static_cast<const char*>(data), size);
    }
  }

  [[nodiscard]] const std::string& bytes() const { return this->bytes_; }

private:
  std::string bytes_;
};

/// The same the other way round. Throws SaveError where the bytes end too early, before any memory
/// is taken for what they do not hold.
class SaveReader
{
public:
  explicit SaveReader(std::string_view bytes)
    : bytes_(bytes)
  {
  }

  template <class T>
  [[nodiscard]] T get()
  {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, this->take(1, sizeof(T)), sizeof(T));
    return value;
  }

  template <class T>
  [[nodiscard]] std::vector<T> getAll(std::uint64_t count)
  {
    static_assert(std::is_arithmetic_v<T>);
    const char* const from = this->take(count, sizeof(T));
    std::vector<T> values(static_cast<std::size_t>(count));
    if (count > 0)
    {
      std::memcpy(values.data(), from, values.size() * sizeof(T));
    }
    return values;
  }

  [[nodiscard]] std::size_t left() const { return this->bytes_.size(); }

private:
  const char* take(std::uint64_t count, std::size_t size)
  {
    if (count > this->bytes_.size() / size)
    {
      throw SaveError("it ends too early");
    }
    const char* const from = this->bytes_.data();
    this->bytes_.remove_prefix(static_cast<std::size_t>(count) * size);
    return from;
  }

  std::string_view bytes_;
};

/// Throws SaveError with what is wrong unless the condition holds.
inline void require(bool condition, const char* problem)
{
  if (!condition)
  {
    throw SaveError(problem);
  }
}

} // namespace lumitree

#endif
