/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sizes.c - the sizes of the structs that fourlink.f90 has, in bytes; sizes.f90 has to print the same.
*/
#include <stdio.h>

#include <fourlink.h>

#define PRINT_SIZE(type) printf("%s %lu\n", #type, (unsigned long)sizeof(type))

int main(void)
{
    PRINT_SIZE(fourlink_vector);
    PRINT_SIZE(fourlink_link);
    PRINT_SIZE(fourlink_design);
    PRINT_SIZE(fourlink_mechanism);
    PRINT_SIZE(fourlink_crank);
    PRINT_SIZE(fourlink_link_state);
    PRINT_SIZE(fourlink_state);
    PRINT_SIZE(fourlink_load);
    PRINT_SIZE(fourlink_forces);
    PRINT_SIZE(fourlink_motion);
    PRINT_SIZE(fourlink_mistake);
    PRINT_SIZE(fourlink_change);
    PRINT_SIZE(fourlink_source);
    PRINT_SIZE(fourlink_value);
    return 0;
}
