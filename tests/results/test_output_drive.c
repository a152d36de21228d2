/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_output_drive.c - what drives acts on an output: its slider or rocker, a load of unknown size on any link, an actuator.
**
** Random machines with outputs, by both solvers.  The effort has the power that the crank would have, if there is no
** friction; and the same effort as a load, with the crank as the drive, leaves the crank no torque, and all pin forces as
** they were.
*/
#include "check.h"
#include "fourlink.h"
#include "random_outputs.h"

#define SAME 1e-9 /* of the largest force of the row, N; of torques, N m, too */

enum { THE_OUTPUT, A_LOAD, AN_ACTUATOR, SORTS };

static char text[20000];
static long n_rows[SORTS], n_powers[SORTS], n_failed;
static double worst;

/* The deck with a section before its [motion], and with a drive and a solver. */
static fourlink_results *open_deck(const char *section, const char *drive, int dyad)
{
    const char *motion = strstr(deck_text, "[motion]");
    fourlink_results *results = NULL;
    fourlink_change changes[2];
    char assignment[40];
    fourlink_mistake mistake;
    fourlink_source source;

    assert_non_null(motion);
    snprintf(text, sizeof text, "%.*s%s%.*s", (int)(motion - deck_text), deck_text, section,
             (int)(length - (size_t)(motion - deck_text)), motion);
    memset(&source, 0, sizeof source);
    memset(changes, 0, sizeof changes);
    snprintf(assignment, sizeof assignment, "motion.drive=%s", drive);
    changes[0].origin = changes[1].origin = "--set";
    changes[0].assignment = assignment;
    changes[1].assignment = dyad ? "solver=dyad" : "solver=matrix";
    source.text = text;
    source.length = strlen(text);
    source.changes = changes;
    source.n_changes = 2;
    if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK)
        fail_msg("line %ld: %s\n%s", mistake.line, mistake.message, text);
    return results;
}

static double value_of(fourlink_results *results, const char *name, int branch, double angle)
{
    fourlink_value value;
    int status = fourlink_results_value(results, name, (fourlink_branch)branch, angle, &value);

    if (status != FOURLINK_OK)
        fail_msg("%s at %g: %s\n%s", name, angle, fourlink_status_text(status), text);
    return value.value * value.to_si;
}

/* The largest pin force of the row. */
static double size_of_forces(fourlink_results *results, int branch, double angle)
{
    static const char *const pins[] = {"F12", "F23", "F34", "P.FP"};
    double largest = 0;
    size_t i;

    for (i = 0; i < COUNT(pins); i++)
        largest = fmax(largest, value_of(results, pins[i], branch, angle));
    return largest;
}

static void same(double x, double y, double size, const char *what)
{
    double error = fabs(x - y) / size;

    worst = fmax(worst, error);
    if (!(error <= SAME))
        fail_msg("%s: %.15g, not %.15g, of %.3g\n%s", what, x, y, size, text);
}

/* The same forces where the effort is a load and the crank drives; F14x of a guide is its friction. */
static void check_as_load(fourlink_results *driven, fourlink_results *loaded, int branch,
                          double angle, fourlink_vector ground)
{
    static const char *const pins[] = {"F12x", "F12y", "F23x",  "F23y",
                                       "F34x", "F34y", "P.FPx", "P.FPy"};
    double size = size_of_forces(driven, branch, angle);
    size_t i;

    for (i = 0; i < COUNT(pins); i++)
        same(value_of(loaded, pins[i], branch, angle), value_of(driven, pins[i], branch, angle),
             size, pins[i]);
    same(value_of(loaded, "Fsx", branch, angle) - ground.x, value_of(driven, "Fsx", branch, angle),
         size, "Fsx");
    same(value_of(loaded, "Fsy", branch, angle) - ground.y, value_of(driven, "Fsy", branch, angle),
         size, "Fsy");
    same(value_of(loaded, "Ts", branch, angle), 0, size, "Ts");
    same(value_of(driven, "Ts", branch, angle), 0, size, "Ts of the drive");
}

/* A section, with the effort or without. */
static const char *section_of(int sort, const fourlink_group *g, const fourlink_vector at[2],
                              const double *effort, char out[400])
{
    *out = '\0';
    if (sort == AN_ACTUATOR)
        sprintf(
            out,
            "[actuator D]\nlink = P\nat = (%.6g, %.6g) m\nto = ground\nto_at = (%.6g, %.6g) m\n",
            at[0].x, at[0].y, at[1].x, at[1].y);
    else if (sort == A_LOAD && effort)
        sprintf(out, "[load D]\nlink = P\nat = (%.6g, %.6g) m\nforce = %.17g N at 30 deg\n",
                at[0].x, at[0].y, *effort);
    else if (sort == A_LOAD)
        sprintf(out, "[load D]\nlink = P\nat = (%.6g, %.6g) m\nforce = unknown at 30 deg\n",
                at[0].x, at[0].y);
    else if (effort && g->end == FOURLINK_GROUP_SLIDES)
        sprintf(out, "[load D]\nlink = P\nat = 0 m\nforce = (%.17g, %.17g) N\n",
                *effort * g->direction.x, *effort * g->direction.y);
    else if (effort)
        sprintf(out, "[load D]\nlink = P\ntorque = %.17g N m\n", *effort);
    return out;
}

/* A load with the opposite torque on the link with the pin of a rocker. */
static void add_opposite(const fourlink_group *g, double effort, char out[800])
{
    if (g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND)
        sprintf(out + strlen(out), "[load E]\nlink = %s\ntorque = %.17g N m\n",
                machine_links[machine][g->to - 2], -effort);
}

static const char *rate_of(int sort, const fourlink_group *g)
{
    return sort == AN_ACTUATOR ? "D.speed" : g->end == FOURLINK_GROUP_SLIDES ? "P.v" : "P.omega";
}

static void check_instant(fourlink_results *driven, int sort, const fourlink_vector at[2],
                          int branch, double angle, int dyad)
{
    const fourlink_deck *deck = fourlink_results_deck(driven);
    fourlink_problem problem;
    const fourlink_group *g;
    fourlink_results *other;
    fourlink_instant now;
    fourlink_load loads[64];
    char section[800];
    double effort;
    int has_friction;

    fourlink_deck_problem(deck, &problem);
    g = &problem.mechanism.design.group[0];
    if (fourlink_results_at(driven, (fourlink_branch)branch, angle, NULL, &now, loads) !=
            FOURLINK_OK ||
        fabs(now.state.sine) < 0.1 || now.state.group_sine < 0.1) {
        n_failed++;
        return;
    }
    effort = value_of(driven, "drive", branch, angle);
    has_friction = problem.has_friction;
    if (sort != A_LOAD && !has_friction) {
        double power, rate = value_of(driven, rate_of(sort, g), branch, angle);

        if (sort == THE_OUTPUT && g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND)
            rate -= now.state.link[g->to].omega;
        other = open_deck(section_of(sort, g, at, NULL, section), "crank", dyad);
        power = value_of(other, "Ts", branch, angle) * now.row.crank.omega2;
        same(effort * rate, power,
             fmax(fabs(power),
                  size_of_forces(other, branch, angle) * fabs(now.row.crank.omega2) * 0.1),
             "power");
        fourlink_results_free(other);
        n_powers[sort]++;
    }
    if (sort != AN_ACTUATOR) {
        fourlink_vector ground = {0, 0}; /* with a slider, the ground has its drive */

        if (sort == THE_OUTPUT && g->end == FOURLINK_GROUP_SLIDES) {
            ground.x = effort * g->direction.x;
            ground.y = effort * g->direction.y;
        }
        section_of(sort, g, at, &effort, section);
        if (sort == THE_OUTPUT)
            add_opposite(g, effort, section);
        other = open_deck(section, "crank", dyad);
        check_as_load(driven, other, branch, angle, ground);
        fourlink_results_free(other);
    }
    n_rows[sort]++;
}

TEST(drives_on_outputs)
{
    static const char *const drives[SORTS] = {"P", "D", "D"};
    int number, n = some_of(2000), i;

    for (number = 0; number < n; number++) {
        int sort = number % SORTS, dyad = number / SORTS % 2, branch;
        fourlink_results *driven;
        fourlink_problem problem;
        fourlink_vector at[2];
        char section[800];

        begin_chance(72, number);
        make_machine_with_outputs(number, number / 6 % 2);
        at[0].x = between(-0.05, 0.1);
        at[0].y = between(-0.05, 0.05);
        at[1].x = between(-0.3, 0.3);
        at[1].y = between(0.4, 0.6);
        driven = open_deck(section_of(sort, NULL, at, NULL, section), drives[sort], dyad);
        fourlink_deck_problem(fourlink_results_deck(driven), &problem);
        for (branch = 1; branch >= -1; branch -= 2)
            for (i = 0; i < 3 && (branch > 0 ? problem.open : problem.crossed); i++)
                check_instant(driven, sort, at, branch, between(0, 360), dyad);
        fourlink_results_free(driven);
    }
    for (i = 0; i < SORTS; i++)
        assert_true(n_rows[i] > n / 10);
    assert_true(n_powers[THE_OUTPUT] > n / 10 && n_powers[AN_ACTUATOR] > n / 10);
    printf("%ld, %ld, %ld rows of outputs, loads and actuators, worst %.1e\n", n_rows[0], n_rows[1],
           n_rows[2], worst);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
