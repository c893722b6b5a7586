/* Programs with something that the library must not bring: -DF64, -DALLOC or -DPANIC. */
#include "microwarp.h"

static volatile float x = 0.5f;

#ifdef F64
#define WRONG(y) ((float)((double)(y) * 1.1))
#endif

#ifdef ALLOC
void *malloc(size_t size);

__attribute__((noinline)) void *malloc(size_t size)
{
    static char memory[8];
    return memory + (size & 4);
}
#define WRONG(y) ((y) + *(volatile char *)malloc((size_t)(y)))
#endif

#ifdef PANIC
float rust_panic(float y);

__attribute__((noinline)) float rust_panic(float y)
{
    return x + y;
}
#define WRONG(y) rust_panic(y)
#endif

int main(void)
{
    x = WRONG(x);
    return 0;
}
