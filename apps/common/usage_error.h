#pragma once

#include "meshalyzer/base/error.h"

namespace meshalyzer {

/// The command line is wrong; what() explains it to the user.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace meshalyzer
