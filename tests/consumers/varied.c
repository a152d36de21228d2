/* SPDX-License-Identifier: GPL-3.0-or-later
**
** varied.c - a deck in, the largest torque for several cranks out, in strict C90: the deck is read once.
*/
#include <stdio.h>
#include <fourlink.h>

int main(void)
{
    static char text[10000];
    static fourlink_source source; /* what stays zero is absent */
    fourlink_results *results;
    fourlink_mistake mistake;
    fourlink_value crank, torque;
    double length;
    int i;

    source.text = text;
    source.length = (unsigned long)fread(text, 1, sizeof text, stdin);
    if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK)
        return 1;
    if (fourlink_results_find(results, "crank.length", &crank) != FOURLINK_OK ||
        fourlink_results_find(results, "max(Ts)", &torque) != FOURLINK_OK)
        return 1;
    for (i = 0; i < 3; i++) {
        length = 18 + 2 * i; /* in the unit of its line */
        if (fourlink_results_put(results, 1, &crank.handle, &length, NULL) == FOURLINK_OK &&
            fourlink_results_get(results, torque.handle, FOURLINK_OPEN, 0, &torque) == FOURLINK_OK)
            printf("%g %s: %s = %.9f %s\n", length, crank.line_unit, torque.name, torque.value,
                   torque.unit);
    }
    if (fourlink_results_set(results, "crank.length", -1, &mistake) == FOURLINK_BAD_DECK)
        printf("%s\n", mistake.message);
    fourlink_results_free(results);
    return 0;
}
