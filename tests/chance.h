/* SPDX-License-Identifier: GPL-3.0-or-later
**
** chance.h - random numbers, the same of each compiler.
*/
#ifndef CHANCE_H
#define CHANCE_H

#include <math.h>

#define PI 3.14159265358979323846

static unsigned long long chance_state;

static double chance(void)
{
    chance_state ^= chance_state << 13;
    chance_state ^= chance_state >> 7;
    chance_state ^= chance_state << 17;
    return (double)(chance_state >> 11) / 9007199254740992.0;
}

/* Begin again, for case i of a seed. */
static void begin_chance(long seed, long i)
{
    int k;

    chance_state = 0x9E3779B97F4A7C15ULL * (unsigned long long)(seed * 1000003 + i + 1);
    for (k = 0; k < 10; k++)
        chance();
}

static double between(double low, double high)
{
    return low + (high - low) * chance();
}

static int one_of(int n)
{
    return (int)(n * chance());
}

static inline int between_whole(int low, int high) /* low ... high - 1 */
{
    return low + one_of(high - low);
}

static int seldom(double share)
{
    return chance() < share;
}

static inline double power_of_ten(double low, double high)
{
    return pow(10, between(low, high));
}

#endif
