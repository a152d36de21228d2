/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - a program that keeps its input as a deck, in strict C90: data/me3491-matrix.deck at its
** row of 40 deg.  With an argument the deck has mistakes.
*/
#include <stdio.h>
#include <string.h>

#include <fourlink.h>

static const char good[] = "mechanism = four-bar\n"
                           "[units]\n"
                           "length = mm\n"
                           "[ground]\n"
                           "length = 80\n"
                           "[crank]\n"
                           "length = 20\n"
                           "mass = 0.1 kg\n"
                           "gyration = 8\n"
                           "cg = 10\n"
                           "[coupler]\n"
                           "length = 66\n"
                           "mass = 0.3 kg\n"
                           "gyration = 25\n"
                           "cg = 30 mm at 10 deg\n"
                           "[rocker]\n"
                           "length = 56\n"
                           "mass = 0.25 kg\n"
                           "gyration = 20\n"
                           "cg = 28 mm at -5 deg\n"
                           "[load Tl]\n"
                           "link = rocker\n"
                           "torque = 0.5 N m\n"
                           "[motion]\n"
                           "speed = 10.5 rad/s\n"
                           "interval = 40 deg\n";

static const char bad[] = "mechanism = four-bar\n"
                          "[ground]\n"
                          "length = 80 parsec\n"
                          "[krank]\n";

#define MOST_MISTAKES 10
#define MOST_LOADS 4

static int print_mistakes(const fourlink_mistake *mistakes, unsigned long n)
{
    unsigned long i;

    for (i = 0; i < n && i < MOST_MISTAKES; i++)
        printf("%s:%ld: error: %s\n", mistakes[i].file[0] ? mistakes[i].file : "deck",
               mistakes[i].line, mistakes[i].message);
    return 1;
}

int main(int argc, char **argv)
{
    const char *text = argc > 1 ? bad : good;
    fourlink_mistake mistakes[MOST_MISTAKES];
    unsigned long n_mistakes;
    fourlink_deck *deck;
    fourlink_problem problem;
    fourlink_range range;
    fourlink_row row;
    fourlink_load loads[MOST_LOADS];
    fourlink_state state;
    fourlink_forces forces;
    int status;

    (void)argv;
    status = fourlink_deck_read(text, (unsigned long)strlen(text), NULL, NULL, MOST_MISTAKES, &deck,
                                mistakes, &n_mistakes);
    if (status == FOURLINK_BAD_DECK)
        return print_mistakes(mistakes, n_mistakes);
    if (status == FOURLINK_OK) {
        status = fourlink_deck_problem(deck, &problem);
        if (problem.n_loads > MOST_LOADS)
            return 1;
        if (status == FOURLINK_OK)
            status = fourlink_motion_range(&problem.motion, &range);
        if (status == FOURLINK_OK)
            status = fourlink_motion_row(&problem.motion, &range, 1, &row);
        if (status == FOURLINK_OK)
            status = fourlink_deck_loads(deck, FOURLINK_OPEN, row.crank.theta2, loads, NULL);
        if (status == FOURLINK_OK)
            status = fourlink_analyse(&problem.mechanism, FOURLINK_OPEN, &row.crank, loads,
                                      problem.n_loads, &state, &forces);
        fourlink_deck_free(deck);
    }
    if (status != FOURLINK_OK) {
        puts(fourlink_status_text(status));
        return 1;
    }
    printf("theta4 = %.6f deg\n", state.link[FOURLINK_FOLLOWER].theta / problem.motion.angle_unit);
    printf("Ts = %.12f N m\n", forces.Ts);
    return 0;
}
