/* golden.c without arguments, for a core with newlib and semihosting: the table is TABLE. */
#define main golden_main
#include "golden.c"
#undef main

void initialise_monitor_handles(void);

int main(void)
{
    static char name[] = "golden", table[] = TABLE;
    char *arguments[] = {name, table, NULL};
    initialise_monitor_handles();
    return golden_main(2, arguments);
}
