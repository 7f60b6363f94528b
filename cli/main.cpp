// The command `durer`.
#include <string>
#include <vector>

#include "cli/run.h"

int main(int count, char** arguments) {
  return durer::run(std::vector<std::string>(arguments + 1, arguments + count));
}
