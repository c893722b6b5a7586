/*
 * From reset to main, and the way out: a Cortex-M or a 32-bit RISC-V core without a C library.
 *
 * Output goes by semihosting, which emulators and debug probes have. Without either, an exit is a fault.
 */
#include "board.h"

#include <stdint.h>

extern uint32_t data_start[], data_end[], bss_start[], bss_end[];
extern const uint32_t data_load[];

int main(void);

static int semihosting(int operation, const void *argument)
{
#ifdef __arm__
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
#else
    register int a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    __asm__ volatile(".balign 16\n"
                     ".option push\n"
                     ".option norvc\n"
                     "slli x0, x0, 0x1f\n"
                     "ebreak\n"
                     "srai x0, x0, 7\n"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
#endif
}

void board_write(const char *text)
{
    semihosting(0x04, text); /* SYS_WRITE0 */
}

void board_exit(bool success)
{
    /* SYS_EXIT, by ADP_Stopped_ApplicationExit or ADP_Stopped_InternalError. */
    semihosting(0x18, (const void *)(uintptr_t)(success ? 0x20026 : 0x20024));
    for (;;) {
    }
}

static void fault(void)
{
    board_exit(false);
}

static void started(void)
{
    const uint32_t *from = data_load;
    for (uint32_t *to = data_start; to < data_end; ++to) {
        *to = *from++;
    }
    for (uint32_t *to = bss_start; to < bss_end; ++to) {
        *to = 0;
    }
    board_exit(main() == 0);
}

#ifdef __arm__

void reset(void)
{
#ifdef __ARM_FP
    /* CPACR: the floating-point unit is off after a reset, and a C compiler may use it anywhere. */
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20;
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    started();
}

/* The first word is the initial stack pointer, an address in a table of functions. */
extern void stack_top(void);

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    stack_top, reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault,
};

#else

__attribute__((naked, section(".vectors"))) void reset(void)
{
    __asm__ volatile("la sp, stack_top\n"
                     "la t0, %0\n"
                     "csrw mtvec, t0\n"
                     "tail %1" ::"s"(fault), "s"(started));
}

#endif
