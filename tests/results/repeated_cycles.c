/* SPDX-License-Identifier: GPL-3.0-or-later
**
** repeated_cycles.c - a steady motion repeats: a row of a random machine is that one cycle later, in every column.
**
**    repeated_cycles DECKS [FIRST]
**
** The decks have random `from`, `to` and intervals, in degrees or radians, run either way, on either branch; some begin
** where a load does.  The first row and rows at random angles are compared with those one cycle later and, over two
** cycles, those two cycles later: to 1e-10 of the largest value of the column in the cycle, angles but for whole turns.  The
** time is later by the fact `period` for each cycle.  Decks that fail are left as cycles-NUMBER.deck.
*/
#include "fourlink.h"
#include "random_machine.h"

#define COLUMNS 300
#define SAMPLES 24 /* rows of a cycle, for the size of a column */
#define PLACES 6   /* that are compared */
#define CLOSE 1e-10
#define POLE \
    1e10 /* of the largest value: there a column has a pole, with a sign that is rounding */
#define LEAST \
    1e-4 /* of the largest of its quantity: less is rounding error, such as that of a force that is 0 */

static long n_decks, without_motion, compared, failed;
static double worst;
static char worst_of[200];

/* The angle at which some load of the deck begins to act; 0 if there is none. */
static int begin_of_load(void)
{
    const char *at = strstr(deck_text, "\nfrom = ");

    return at ? atoi(at + strlen("\nfrom = ")) : 0;
}

/* The decimals of an angle that is written: whole degrees, or all digits. */
static double some_digits(double x)
{
    double unit = pow(10, one_of(8));

    return floor(x * unit + 0.5) / unit;
}

static void make(long number)
{
    int whole_cycles, in_radians = seldom(0.2);
    double from, cycle, unit = in_radians ? PI / 180 : 1;
    const char *name = in_radians ? "rad" : "deg";

    choose_machine(number);
    sense = seldom(0.4) ? -1 : 1;
    mode = STEADY;
    typical_speed = power_of_ten(0.6, 2.1);
    typical_torque = power_of_ten(0.3, 2.2);
    has_friction = seldom(0.3);
    write_machine();
    write_loads_of_motor();
    from = some_digits(seldom(0.2) ? begin_of_load() : between(-1000, 1000));
    cycle = seldom(0.2) ? 720 : 360;
    whole_cycles = 1 + one_of(3);
    if (write_motor() == MOTOR_CONSTANT)
        write("[flywheel]\ninertia = %.6g kg m2\n[motion]\nmean_speed = %.6g rad/s\n",
              power_of_ten(-2, 0.5), sense * typical_speed);
    else
        write("[flywheel]\ninertia = %.6g kg m2\n[motion]\n", power_of_ten(-2, 0.5));
    write("mode = steady\ncycle = %g deg\nfrom = %.17g %s\nto = %.17g %s\ninterval = %.17g %s\n",
          cycle, from * unit, name, (from + sense * cycle * whole_cycles) * unit, name,
          some_digits(between(1, 170)) * unit, name);
    write("[table]\nbranch = %s\ncolumns = all\n",
          machine == A_YOKE || seldom(0.5) ? "open" : "crossed");
    if (in_radians)
        write("[units]\nangle = rad\n");
}

/* --------------------------------------------------------------------------------------------- one deck */

static fourlink_results *results;
static const fourlink_value *columns;
static unsigned long n_columns;
static fourlink_branch branch;
static double size[COLUMNS], cycle; /* in the deck's unit, in the sense of the motion */
static long number;

static void take_sizes(double from)
{
    double values[COLUMNS];
    unsigned long c;
    int k;

    memset(size, 0, sizeof size);
    for (k = 0; k < SAMPLES; k++)
        if (fourlink_results_at(results, branch, from + cycle * (k + 0.5) / SAMPLES, values, NULL,
                                NULL) == FOURLINK_OK)
            for (c = 0; c < n_columns; c++)
                if (fabs(values[c]) < 1e300)
                    size[c] = fmax(size[c], fabs(values[c]));
    for (c = 0; c < n_columns; c++)
        for (k = 0; k < (int)n_columns; k++)
            if (strcmp(columns[c].quantity, columns[k].quantity) == 0)
                size[c] = fmax(size[c], LEAST * size[k]);
}

/* How far a column is from its value a number of cycles before, of its size. */
static double difference(unsigned long c, double before, double after, double cycles, double period)
{
    const fourlink_value *column = &columns[c];
    double turn = 2 * PI / column->to_si, d = after - before;
    double of = fmax(size[c], fmin(fabs(before), fabs(after)));

    if (before == after || (isnan(before) && isnan(after)) || of > POLE * size[c] ||
        (column->flags & FOURLINK_CRANK_ANGLE))
        return 0;
    if (strcmp(column->name, "time") == 0)
        return fabs(d - cycles * period) / (cycles * period);
    if (strcmp(column->quantity, "angle") == 0) {
        d -= turn * floor(d / turn + 0.5);
        of = turn;
    }
    if (column->flags & FOURLINK_OF_ROUNDING)
        of = 1;
    return fabs(d) / of;
}

/* Compare the rows at two angles; returns whether they agree. */
static int compare(const double *before, const double *after, double at, double cycles,
                   double period)
{
    int agrees = 1;
    unsigned long c;

    compared++;
    for (c = 0; c < n_columns; c++) {
        double d = difference(c, before[c], after[c], cycles, period);

        if (!(d <= worst)) {
            worst = d;
            snprintf(worst_of, sizeof worst_of, "%s of deck %ld at %.17g, %g cycles later",
                     columns[c].name, number, at, cycles);
        }
        if (!(d <= CLOSE)) {
            printf("deck %ld: %s at %.17g: %.17g, %g cycles later %.17g\n", number, columns[c].name,
                   at, before[c], cycles, after[c]);
            agrees = 0;
        }
    }
    return agrees;
}

static int compare_at(double at, double cycles, double period)
{
    double before[COLUMNS], after[COLUMNS];

    if (fourlink_results_at(results, branch, at, before, NULL, NULL) != FOURLINK_OK ||
        fourlink_results_at(results, branch, at + cycles * cycle, after, NULL, NULL) != FOURLINK_OK)
        return 1;
    return compare(before, after, at, cycles, period);
}

static int check_rows(const fourlink_problem *p)
{
    double from = p->motion.from, whole = (p->motion.to - from) / cycle, first[COLUMNS],
           last[COLUMNS];
    fourlink_value period;
    int agrees, i;

    if (fourlink_results_value(results, "period", branch, 0, &period) != FOURLINK_OK ||
        fourlink_results_row(results, branch, 0, first, NULL, NULL) != FOURLINK_OK ||
        fourlink_results_row(results, branch, p->n_rows - 1, last, NULL, NULL) != FOURLINK_OK) {
        without_motion++;
        return 1;
    }
    take_sizes(from);
    agrees = compare(first, last, from, floor(whole + 0.5), period.value * period.to_si);
    for (i = 0; i < PLACES && whole > 1.5; i++) {
        double cycles = 1 + one_of((int)(whole - 0.5)), at;

        at = i == 0 ? from : from + between(0, whole - cycles) * cycle;
        agrees &= compare_at(at, cycles, period.value * period.to_si);
    }
    return agrees;
}

static int check(void)
{
    fourlink_source source;
    fourlink_mistake mistake;
    fourlink_problem p;
    int agrees;

    memset(&source, 0, sizeof source);
    source.text = deck_text;
    source.length = length;
    if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK) {
        printf("deck %ld: line %ld: %s\n", number, mistake.line, mistake.message);
        return 0;
    }
    fourlink_deck_problem(fourlink_results_deck(results), &p);
    branch = p.open ? FOURLINK_OPEN : FOURLINK_CROSSED;
    cycle = sense * p.cycle / p.motion.angle_unit;
    fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n_columns);
    agrees = n_columns <= COLUMNS && check_rows(&p);
    fourlink_results_free(results);
    return agrees;
}

int main(int argc, char **argv)
{
    long n = argc > 1 ? atol(argv[1]) : 100, first = argc > 2 ? atol(argv[2]) : 0;

    for (number = first; number < first + n; number++) {
        begin_chance(66, number);
        make(number);
        n_decks++;
        if (check())
            continue;
        failed++;
        leave_deck("cycles", number);
    }
    printf("%ld decks, %ld of them without a steady motion: %ld rows compared, worst %.2g, %s; %ld "
           "decks "
           "failed\n",
           n_decks, without_motion, compared, worst, worst_of, failed);
    return failed || 2 * without_motion > n_decks;
}
