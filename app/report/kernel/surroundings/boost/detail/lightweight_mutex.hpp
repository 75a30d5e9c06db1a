/// @file In the place of Boost's header in the kernel of the pages, which has one thread.
#pragma once

namespace boost::detail {

class lightweight_mutex {
 public:
  struct scoped_lock {
    explicit scoped_lock(lightweight_mutex& /*mutex*/) {}
  };
};

}  // namespace boost::detail
