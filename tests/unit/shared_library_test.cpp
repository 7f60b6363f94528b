#include "tracer/system/shared_library.h"

#include <gtest/gtest.h>
#include <math.h>

#include <stdexcept>

namespace durer {
namespace {

struct MathLibrary {
  SharedLibrary library{"libm.so.6"};
  DURER_IMPORT(cbrtl);
};

TEST(SharedLibrary, FindsFunctionsOfTheTypeInTheHeader) {
  EXPECT_EQ(MathLibrary().cbrtl(27.0L), 3.0L);
}

TEST(SharedLibrary, SaysWhatIsMissing) {
  EXPECT_THROW(SharedLibrary("libdurer_not_there.so.1"), std::runtime_error);
  const SharedLibrary math("libm.so.6");
  EXPECT_THROW(math.find<int()>("durer_not_there"), std::runtime_error);
}

}  // namespace
}  // namespace durer
