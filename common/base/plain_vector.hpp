// A growing array of plain records, for inner loops: what std::vector does, without setting new
// elements to zero first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace spoctree {

/// Storage is kept by `clear`, and by assignment where it suffices.
template <class T>
class PlainVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  using value_type = T;

  PlainVector() = default;
  PlainVector(const PlainVector& other) { *this = other; }
  PlainVector(PlainVector&& other) noexcept { swap(other); }
  PlainVector& operator=(const PlainVector& other) {
    if (this == &other) return *this;
    resize_unset(other.size_);
    if (size_ > 0) std::memcpy(static_cast<void*>(data_), other.data_, size_ * sizeof(T));
    return *this;
  }
  PlainVector& operator=(PlainVector&& other) noexcept {
    swap(other);
    return *this;
  }
  ~PlainVector() { std::free(data_); }

  void swap(PlainVector& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  const T* begin() const { return data_; }
  T* end() { return data_ + size_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& front() { return data_[0]; }
  const T& front() const { return data_[0]; }
  T& back() { return data_[size_ - 1]; }
  const T& back() const { return data_[size_ - 1]; }

  void clear() { size_ = 0; }
  /// New elements are left unset: the caller writes them before anybody reads them.
  void resize_unset(std::size_t size) {
    if (size > capacity_) grow(size);
    size_ = size;
  }
  void push_back(T value) {
    if (size_ == capacity_) grow(size_ + 1);
    data_[size_++] = value;
  }
  void pop_back() { --size_; }
  /// Appends some that are stored elsewhere.
  void append(const T* items, std::size_t count) {
    if (count == 0) return;
    const std::size_t before = size_;
    resize_unset(before + count);
    std::memcpy(static_cast<void*>(data_ + before), items, count * sizeof(T));
  }
  /// Gives storage back that is not in use. Most often nothing is moved.
  void shrink_to_fit() {
    if (size_ == 0) {
      std::free(std::exchange(data_, nullptr));
      capacity_ = 0;
    } else if (size_ < capacity_) {
      reallocate(size_);
    }
  }

 private:
  void grow(std::size_t wanted) { reallocate(std::max<std::size_t>({wanted, 2 * capacity_, 16})); }
  void reallocate(std::size_t capacity) {
    void* const data = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
    if (data == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(data);
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace spoctree
