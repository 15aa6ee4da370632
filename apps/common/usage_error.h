#pragma once

#include "meshalyzer/base/error.h"

namespace meshalyzer {

/// The command line does not say something that can be done. what() is for the user.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace meshalyzer
