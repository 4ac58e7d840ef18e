// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Terms_h
#define Lumitree_Accel_Exact_Terms_h

#include <algorithm>
#include <cstddef>
#include <memory>

namespace lumitree::exact
{

/// A growing list of doubles whose first 32 need no memory from the heap: an expansion is short nearly always.
class Terms
{
public:
  Terms() = default;
  Terms(const Terms& other)
  {
    this->reserve(other.size_);
    std::copy_n(other.data(), other.size_, this->data());
    this->size_ = other.size_;
  }
  Terms(Terms&& other) noexcept
    : heap_(std::move(other.heap_))
    , size_(other.size_)
    , capacity_(other.capacity_)
  {
    if (!this->heap_)
    {
      std::copy_n(other.inline_, other.size_, this->inline_);
    }
    other.size_ = 0;
    other.capacity_ = inlineCapacity;
  }
  Terms& operator=(Terms other) noexcept
  {
    this->heap_ = std::move(other.heap_);
    this->size_ = other.size_;
    this->capacity_ = other.capacity_;
    if (!this->heap_)
    {
      std::copy_n(other.inline_, other.size_, this->inline_);
    }
    return *this;
  }
  ~Terms() = default;

  void reserve(std::size_t capacity)
  {
    if (capacity > this->capacity_)
    {
      std::unique_ptr<double[]> larger(new double[capacity]);
      std::copy_n(this->data(), this->size_, larger.get());
      this->heap_ = std::move(larger);
      this->capacity_ = capacity;
    }
  }

  void push(double value)
  {
    if (this->size_ == this->capacity_)
    {
      this->reserve(2 * this->capacity_);
    }
    this->data()[this->size_++] = value;
  }

  [[nodiscard]] std::size_t size() const { return this->size_; }
  [[nodiscard]] bool empty() const { return this->size_ == 0; }
  [[nodiscard]] double operator[](std::size_t i) const { return this->data()[i]; }
  [[nodiscard]] double back() const { return this->data()[this->size_ - 1]; }
  [[nodiscard]] const double* begin() const { return this->data(); }
  [[nodiscard]] const double* end() const { return this->data() + this->size_; }

private:
  static constexpr std::size_t inlineCapacity = 32;

  [[nodiscard]] double* data() { return this->heap_ ? this->heap_.get() : this->inline_; }
  [[nodiscard]] const double* data() const
  {
    return this->heap_ ? this->heap_.get() : this->inline_;
  }

  double inline_[inlineCapacity];
  std::unique_ptr<double[]> heap_;
  std::size_t size_ = 0;
  std::size_t capacity_ = inlineCapacity;
};

} // namespace lumitree::exact

#endif
