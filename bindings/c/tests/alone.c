/* A program of one function, to be linked and looked at: -DCALL='…', which writes to or reads from volatile memory. */
#include "microwarp.h"

volatile float to[4];
volatile uint32_t words[4];

int main(void)
{
    CALL;
    return 0;
}
