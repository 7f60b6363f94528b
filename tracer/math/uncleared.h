// Room for a value that is made later, if at all: local variables of this type cost nothing.
#pragma once

#include <new>
#include <type_traits>
#include <utility>

namespace durer {

template <typename T>
union Uncleared {
  static_assert(std::is_trivially_destructible_v<T>);

  Uncleared() {}
  template <typename... Arguments>
  T& emplace(Arguments&&... arguments) {
    return *new (&value) T(std::forward<Arguments>(arguments)...);
  }
  // From what a function returns, without a copy.
  template <typename Make>
  T& emplace_result(Make&& make) {
    return *new (&value) T(make());
  }

  T value;
};

}  // namespace durer
