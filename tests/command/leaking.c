/* SPDX-License-Identifier: GPL-3.0-or-later
**
** leaking.c - leaves three blocks of memory, to be found by live_blocks.c.
*/
#include <stdlib.h>

static void *volatile block;

int main(void)
{
    block = malloc(10);
    free(block);
    block = malloc(20);
    block = realloc(block, 30);
    block = calloc(3, 4);
    block = malloc(50);
    return 0;
}
