#include "cli.h"

#include <iostream>

int main(int argc, char** argv) {
  return meshalyzer::fixer::run(argc, argv, std::cout, std::cerr);
}
