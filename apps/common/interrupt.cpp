#include "interrupt.h"

#include <csignal>
#include <initializer_list>

namespace meshalyzer {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void mark(int) {
  g_interrupted = 1;
}

void handle(int signal_number, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal_number, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  g_interrupted = 0;
  for (const int signal_number : {SIGINT, SIGTERM}) {
    handle(signal_number, mark, SA_RESTART | SA_RESETHAND);
  }
}

InterruptGuard::~InterruptGuard() {
  for (const int signal_number : {SIGINT, SIGTERM}) {
    handle(signal_number, SIG_DFL, 0);
  }
}

bool InterruptGuard::is_interrupted() {
  return g_interrupted != 0;
}

}  // namespace meshalyzer
