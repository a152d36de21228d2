/* SPDX-License-Identifier: GPL-3.0-or-later
**
** standstill.c - Ts_static of random machines against their driving torque at a crawl, where inertia is nothing.
**
**    standstill DECKS [FIRST]
**
** Most machines have friction in pins, guide and slot; they run either way, on either branch, some by a motor, some from
** rest.  At random crank angles Ts_static is Ts of the same machine at a crawl in the same sense, to 1e-9, or undefined where friction locks the machine at a crawl.  Ts_static and
** Ts_inertia make Ts, and the superposition is exact, to 1e-11.  Decks that fail are left as standstill-NUMBER.deck.
*/
#include "fourlink.h"
#include "random_machine.h"

#define ARM 0.01   /* m: the shortest crank */
#define CRAWL 1e-9 /* rad/s */
#define PLACES 12  /* of a deck */
#define CLOSE 1e-9
#define EXACT 1e-11

static long n_decks, with_friction, compared, backward, locked, apart, failed, number;
static double worst, worst_sum, worst_superposition;
static int at_rest; /* the crank starts, in the sense of [friction] direction */

/* Friction of all kinds, light or heavy; a pin but B without it now and then. */
static void write_much_friction(void)
{
    static const char *const pins[] = {"ABC", "ABC", "ABD", "AB"};
    double most = seldom(0.3) ? 0.9 : 0.2;
    const char *pin;

    write("[friction]\n");
    for (pin = pins[machine]; *pin; pin++)
        if (*pin == 'B' || !seldom(0.15))
            write("%c = %.6g\nradius_%c = %.6g mm\n", *pin, between(0, most), *pin, between(2, 12));
    if (machine != A_FOUR_BAR && !seldom(0.15)) {
        write("guide = %.6g\n", between(0, most));
        if (machine == A_YOKE || seldom(0.5))
            write("guide_length = %.6g mm\n", between(10, 80));
    }
    if (machine == A_YOKE && !seldom(0.15)) {
        write("slot = %.6g\n", between(0, most));
        if (seldom(0.5))
            write("slot_length = %.6g mm\n", between(10, 40));
    }
    if (at_rest)
        write("direction = %s\n", sense < 0 ? "backward" : "forward");
}

/* The machine, without a motion and what drives it. */
static void make_machine(void)
{
    static const char *const names[] = {"K", "L", "M"};
    int loads, i;

    choose_machine(number);
    write_machine();
    for (loads = one_of(4), i = 0; i < loads; i++) {
        const char *link = machine_links[machine][one_of(3)];

        if (seldom(0.3)) {
            write_load_over_position(names[i]);
        } else {
            write("[load %s]\nlink = %s\n", names[i], link);
            write_load(link);
        }
    }
    if (seldom(0.3))
        write("[spring S]\nlink = crank\nto = ground\nstiffness = %.6g N m/rad\n", between(0.1, 5));
    if (seldom(0.15))
        write("[gravity]\nacceleration = 0 m/s2\n");
    has_friction = !seldom(0.2);
    at_rest = has_friction && seldom(0.15);
    sense = seldom(0.5) ? -1 : 1;
    if (has_friction)
        write_much_friction();
    write("[table]\nbranch = %s\ncolumns = Ts, Ts_static, Ts_inertia, superposition, F12\n",
          machine == A_YOKE ? "open" : "both");
}

static void write_quick_motion(void)
{
    double speed = sense * power_of_ten(-0.5, 2);

    if (!at_rest && has_friction && seldom(0.15)) {
        write("[motor]\nstall_torque = %.6g N m\nno_load_speed = %.6g rad/s\n", sense * 500.0,
              speed);
        write("[flywheel]\ninertia = 1 kg m2\n[motion]\nmode = free\nspeed = %.6g rad/s\n", speed);
        return;
    }
    write("[motion]\nspeed = %.6g rad/s\n", at_rest ? 0 : speed);
    if (at_rest || seldom(0.4))
        write("acceleration = %.6g rad/s2\nhold = yes\n", sense * power_of_ten(0, 3));
}

static fourlink_results *opened(void)
{
    fourlink_results *results = NULL;
    fourlink_source source;
    fourlink_mistake mistake;

    memset(&source, 0, sizeof source);
    source.text = deck_text;
    source.length = length;
    if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK)
        printf("deck %ld: line %ld: %s\n", number, mistake.line, mistake.message);
    return results;
}

enum { TS, STATIC, INERTIA, SUPERPOSITION, F12 };

/* Compare at a crank angle; returns whether all is well. */
static int compare(fourlink_results *moving, fourlink_results *crawling, fourlink_branch branch,
                   double angle)
{
    double m[5], c[5], off, sum, size;
    int status;

    if (fourlink_results_at(moving, branch, angle, m, NULL, NULL) != FOURLINK_OK)
        return 1;
    status = fourlink_results_at(crawling, branch, angle, c, NULL, NULL);
    if (status == FOURLINK_LOCKED) {
        locked++;
        return isnan(m[STATIC]) && isnan(m[INERTIA]) && isnan(m[SUPERPOSITION]);
    }
    compared++;
    backward += sense < 0;
    size = fmax(fmax(fabs(c[TS]), ARM * c[F12]), 1e-6 * fabs(m[INERTIA]));
    apart += fabs(m[TS] - m[STATIC]) > 1e-3 * size;
    off = fabs(m[STATIC] - c[TS]) / size;
    sum = fabs(m[STATIC] + m[INERTIA] - m[TS]) / fmax(fabs(m[STATIC]), fabs(m[INERTIA]));
    worst = fmax(worst, off);
    worst_sum = fmax(worst_sum, sum);
    worst_superposition = fmax(worst_superposition, m[SUPERPOSITION]);
    if (status == FOURLINK_OK && off <= CLOSE && sum <= EXACT && m[SUPERPOSITION] <= EXACT)
        return 1;
    printf(
        "deck %ld at %.17g on %d: Ts_static %.17g, at a crawl %.17g; Ts_inertia %.17g, Ts %.17g, "
        "superposition %.2g\n",
        number, angle, (int)branch, m[STATIC], c[TS], m[INERTIA], m[TS], m[SUPERPOSITION]);
    return 0;
}

static int check(void)
{
    static const char range[] = "from = %d deg\nto = %d deg\n";
    size_t machine_length;
    fourlink_results *moving, *crawling;
    int agrees = 1, k;

    make_machine();
    machine_length = length;
    write_quick_motion();
    write(range, sense < 0 ? 360 : 0, sense < 0 ? 0 : 360);
    moving = opened();
    length = machine_length;
    write("[motion]\nspeed = %.17g rad/s\n", sense * CRAWL);
    write(range, sense < 0 ? 360 : 0, sense < 0 ? 0 : 360);
    crawling = opened();
    if (!moving || !crawling)
        return 0;
    for (k = 0; k < PLACES && agrees; k++)
        agrees =
            compare(moving, crawling, k % 2 || machine == A_YOKE ? FOURLINK_OPEN : FOURLINK_CROSSED,
                    between(0, 360));
    fourlink_results_free(moving);
    fourlink_results_free(crawling);
    return agrees;
}

int main(int argc, char **argv)
{
    long n = argc > 1 ? atol(argv[1]) : 1000, first = argc > 2 ? atol(argv[2]) : 0;

    for (number = first; number < first + n; number++) {
        begin_chance(67, number);
        n_decks++;
        with_friction += has_friction;
        if (check())
            continue;
        failed++;
        leave_deck("standstill", number);
    }
    printf("%ld decks, %ld with friction: %ld rows compared, %ld of them backward, %ld with "
           "another Ts; %ld locked at a "
           "crawl; worst %.2g, sum %.2g, superposition %.2g; %ld decks failed\n",
           n_decks, with_friction, compared, backward, apart, locked, worst, worst_sum,
           worst_superposition, failed);
    return failed || 2 * apart < compared;
}
