/* What the programs of this folder need of a board. */
#ifndef BOARD_H
#define BOARD_H

#include <stdbool.h>

void board_write(const char *text);

/* Ends the run; a product never does. */
void board_exit(bool success);

#endif
