#include "guarded.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/error.h"
#include "usage_error.h"

#include <exception>
#include <new>
#include <ostream>

namespace meshalyzer {

int run_guarded(const std::string& name, Streams streams,
                const std::function<ExitCode()>& program) {
  try {
    return static_cast<int>(program());
  } catch (const UsageError& error) {
    streams.err << name << ": " << without_controls(error.what()) << "\nTry '" << name
                << " --help'.\n";
    return static_cast<int>(ExitCode::Usage);
  } catch (const IoError& error) {
    streams.err << error.what() << '\n';
    return static_cast<int>(ExitCode::Failure);
  } catch (const std::bad_alloc&) {
    streams.err << name << ": not enough memory\n";
    return static_cast<int>(ExitCode::Failure);
  } catch (const std::exception& error) {
    streams.err << name << ": " << error.what() << '\n';
    return static_cast<int>(ExitCode::Failure);
  }
}

}  // namespace meshalyzer
