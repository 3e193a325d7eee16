#include <rosy.h>

main = simulate (drive 50)
