/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_threads.c - two threads that compute at once get the same bits as one.
*/
#include <pthread.h>
#include <stdlib.h>

#include "check.h"
#include "fourlink.h"

#define POSITIONS 20000

typedef struct answer {
    int status;
    fourlink_state state;
    fourlink_forces forces;
} answer;

typedef struct work {
    uint64_t seed;
    answer *answers;
} work;

static void *compute(void *data)
{
    work *w = data;
    uint64_t seed = w->seed;
    int n, i;

    for (n = 0; n < POSITIONS; n++) {
        fourlink_load load = {4, FOURLINK_FRAME_LINK, {3, 4}, {0.1, 0.2}, 5};
        fourlink_design d;
        fourlink_mechanism m;
        fourlink_crank crank;

        memset(&d, 0, sizeof d);
        d.kind = n % 2 ? FOURLINK_FOUR_BAR : FOURLINK_SLIDER_CRANK;
        for (i = 1; i <= 4; i++) {
            d.link[i].length = uniform(&seed, 0.1, 1);
            d.link[i].mass = uniform(&seed, 0, 2);
        }
        crank.theta2 = uniform(&seed, -7, 7);
        crank.omega2 = uniform(&seed, -7, 7);
        crank.alpha2 = uniform(&seed, -7, 7);
        memset(&w->answers[n], 0, sizeof w->answers[n]);
        fourlink_prepare(&d, &m);
        w->answers[n].status =
            fourlink_analyse(&m, n % 3 ? FOURLINK_OPEN : FOURLINK_CROSSED, &crank, &load, 1,
                             &w->answers[n].state, &w->answers[n].forces);
    }
    return NULL;
}

/* The members that a result has, one by one: padding and unused links may differ. */
static int same(const answer *x, const answer *y)
{
    int i;

    if (x->status != y->status)
        return 0;
    if (x->status != FOURLINK_OK)
        return 1;
    for (i = 2; i <= 4; i++)
        if (memcmp(&x->state.link[i], &y->state.link[i], sizeof x->state.link[i]) != 0)
            return 0;
    return memcmp(&x->forces, &y->forces, sizeof x->forces) == 0;
}

TEST(test_two_threads)
{
    work alone[2] = {{1, NULL}, {2, NULL}}, together[2] = {{1, NULL}, {2, NULL}};
    pthread_t threads[2];
    int i, n, good = 0;

    for (i = 0; i < 2; i++) {
        alone[i].answers = calloc(POSITIONS, sizeof(answer));
        together[i].answers = calloc(POSITIONS, sizeof(answer));
        assert_non_null(alone[i].answers);
        assert_non_null(together[i].answers);
        compute(&alone[i]);
    }
    for (i = 0; i < 2; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, compute, &together[i]), 0);
    for (i = 0; i < 2; i++)
        pthread_join(threads[i], NULL);
    for (i = 0; i < 2; i++)
        for (n = 0; n < POSITIONS; n++) {
            assert_true(same(&alone[i].answers[n], &together[i].answers[n]));
            good += alone[i].answers[n].status == FOURLINK_OK;
        }
    assert_true(good > POSITIONS / 2); /* and not all of them refused */
    assert_false(same(&alone[0].answers[0], &alone[1].answers[0]));
    for (i = 0; i < 2; i++) {
        free(alone[i].answers);
        free(together[i].answers);
    }
}

/* The last crank torque of 200 readings of one deck; NaN if one of them failed. */
static void *read_decks(void *data)
{
    static const char text[] = "mechanism = four-bar\n[ground]\nlength = 80.5 mm\n"
                               "[crank]\nlength = 2.0e1 mm\n[coupler]\nlength = 66 mm\n"
                               "[rocker]\nlength = 56 mm\n[load]\nlink = rocker\n"
                               "torque = 0 deg 1.25 N m, 90 deg 2 N m, 200 deg -3 N m\n";
    double *result = data;
    int i;

    for (i = 0; i < 200; i++) {
        fourlink_deck *deck;
        fourlink_load load;

        if (fourlink_deck_read(text, sizeof text - 1, NULL, NULL, 0, &deck, NULL, NULL) !=
            FOURLINK_OK) {
            *result = NAN;
            return NULL;
        }
        fourlink_deck_loads(deck, FOURLINK_OPEN, i * DEG, &load, NULL);
        *result = load.torque;
        fourlink_deck_free(deck);
    }
    return NULL;
}

TEST(test_decks_in_two_threads)
{
    double alone, together[2];
    pthread_t threads[2];
    int i;

    read_decks(&alone);
    assert_true(-3 < alone && alone < 0);
    for (i = 0; i < 2; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, read_decks, &together[i]), 0);
    for (i = 0; i < 2; i++) {
        pthread_join(threads[i], NULL);
        assert_near(together[i], alone, 0);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
