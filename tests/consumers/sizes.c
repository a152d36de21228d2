/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sizes.c - the sizes of the public structs, in bytes; sizes.f90 has to print the same.
*/
#include <stdio.h>

#include <fourlink.h>

#define PRINT_SIZE(type) printf("%s %lu\n", #type, (unsigned long)sizeof(type))

int main(void)
{
    PRINT_SIZE(fourlink_vector);
    PRINT_SIZE(fourlink_link);
    PRINT_SIZE(fourlink_joint);
    PRINT_SIZE(fourlink_kind_facts);
    PRINT_SIZE(fourlink_design);
    PRINT_SIZE(fourlink_mechanism);
    PRINT_SIZE(fourlink_crank);
    PRINT_SIZE(fourlink_link_state);
    PRINT_SIZE(fourlink_state);
    PRINT_SIZE(fourlink_load);
    PRINT_SIZE(fourlink_forces);
    PRINT_SIZE(fourlink_friction);
    PRINT_SIZE(fourlink_losses);
    PRINT_SIZE(fourlink_spring);
    PRINT_SIZE(fourlink_spring_state);
    PRINT_SIZE(fourlink_balance);
    PRINT_SIZE(fourlink_motor);
    PRINT_SIZE(fourlink_reach);
    PRINT_SIZE(fourlink_limits);
    PRINT_SIZE(fourlink_series);
    PRINT_SIZE(fourlink_rod);
    PRINT_SIZE(fourlink_engine);
    PRINT_SIZE(fourlink_klein);
    PRINT_SIZE(fourlink_motion);
    PRINT_SIZE(fourlink_range);
    PRINT_SIZE(fourlink_row);
    PRINT_SIZE(fourlink_mistake);
    PRINT_SIZE(fourlink_load_info);
    PRINT_SIZE(fourlink_problem);
    PRINT_SIZE(fourlink_unit);
    PRINT_SIZE(fourlink_change);
    PRINT_SIZE(fourlink_source);
    PRINT_SIZE(fourlink_value);
    PRINT_SIZE(fourlink_instant);
    PRINT_SIZE(fourlink_area);
    PRINT_SIZE(fourlink_turning);
    PRINT_SIZE(fourlink_check);
    PRINT_SIZE(fourlink_precision);
    PRINT_SIZE(fourlink_solution);
    PRINT_SIZE(fourlink_function_task);
    PRINT_SIZE(fourlink_dyad);
    PRINT_SIZE(fourlink_motion_task);
    PRINT_SIZE(fourlink_path_task);
    PRINT_SIZE(fourlink_quick_return_task);
    PRINT_SIZE(fourlink_cognate_task);
    return 0;
}
