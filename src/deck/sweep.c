/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.c - [sweep]: the designs of a deck that varies its quantities.
**
** A design is a list of assignments, like those of --set.  All combinations of ranges and lists are taken;
** the last changes fastest.  Quantities varied in step, joined by &, count as one.  With tolerances, each
** combination has the number of samples that the deck gives.  A design depends only on its index: its random
** numbers are the first of a generator seeded with the deck's seed and the index.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include "base/number.h"
#include "numbers.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "sweep.h"
#include "values.h"

#define MOST_VARIABLES 1000
#define MOST_DESIGNS 4e9 /* fits an unsigned long on every machine */

/* How one quantity is varied. */
typedef struct variation {
    enum { VARY_LIST, VARY_RANGE, VARY_TOLERANCE } form;
    text name, value;
    text_place place;
    target target;
    const key_info *key; /* the key, or its vector */
    quantity q;
    quantity_value first; /* the range's first value, or the nominal one */
    quantity_value *list; /* the values of a list */
    text unit;            /* as written after the first value */
    double step, size;    /* step of a range, and its larger end, in the unit of the first value */
    double tolerance;     /* in the unit of the nominal value */
    int is_normal;
    double count;         /* of values; 1 for a tolerance */
    unsigned long repeat; /* of combinations with the same value, one after the other */
    int piece, n_pieces;  /* in step with others: the index of its own values between the & */
} variation;

static text next_item(text *rest)
{
    text item = {"", 0};

    flk_text_split(rest, ',', &item);
    return flk_text_trim(item);
}

/* Piece i of a text between its &, from 0; empty if there are fewer. */
static text piece_of(text t, int i)
{
    text piece = {"", 0};

    while (flk_text_split(&t, '&', &piece) && i > 0)
        i--;
    piece = flk_text_trim(piece);
    piece.length = i > 0 ? 0 : piece.length;
    return piece;
}

static int count_pieces(text t)
{
    text piece;
    int n = 0;

    while (flk_text_split(&t, '&', &piece))
        n++;
    return n;
}

/* A value of a list, or the piece of it that belongs to the variation. */
static text own_piece(const variation *v, text item)
{
    return v->n_pieces > 1 ? piece_of(item, v->piece) : item;
}

static int read(parser *p, const variation *v, text t, quantity_value *value)
{
    return flk_piece_quantity(p, v->place, t, t, v->q, value);
}

static double in_unit(const quantity_value *value, const unit *u)
{
    return flk_number_converted(value->number, value->unit, *u);
}

/* Read the first value of a range, or the nominal value. */
static int read_first(parser *p, variation *v, text t)
{
    v->unit = flk_quantity_after_number(t);
    return read(p, v, t, &v->first);
}

/* Read a quantity in a unit. */
static int read_in(parser *p, const variation *v, text t, const unit *u, double *number)
{
    quantity_value value;

    if (!read(p, v, t, &value))
        return 0;
    *number = in_unit(&value, u);
    return 1;
}

/* 1 if both have a unit, or neither; otherwise 0 and a mistake: "100 to 300 rpm" does not mean 100 rad/s to
** 300 rpm. */
static int units_agree(parser *p, const variation *v, text x, text y)
{
    if ((flk_quantity_unit_text(x).length > 0) == (flk_quantity_unit_text(y).length > 0))
        return 1;
    return flk_mistake(p->mistakes, v->place,
                       "either all values of a quantity have a unit or none has");
}

static int refuse_range(parser *p, const variation *v, const char *what)
{
    return flk_mistake(p->mistakes, v->place,
                       "a range needs %s, '20 mm to 30 mm step 2 mm', or the number of its "
                       "values, '20 mm to 30 mm in 6'",
                       what);
}

/* A to B step S; A to B in N */
static int read_range(parser *p, variation *v)
{
    text first, rest, last, step, number;
    double end, steps;
    int in_steps;

    flk_text_range(v->value, &first, &rest);
    in_steps = !flk_text_cut(rest, " step ", &last, &step);
    if (in_steps &&
        !flk_text_cut_last(rest, " in ", &last, &number)) /* the last " in ": 1 in to 2 in in 3 */
        return refuse_range(p, v, "its step");
    v->form = VARY_RANGE;
    if (!read_first(p, v, first) || !units_agree(p, v, first, last) ||
        !read_in(p, v, last, &v->first.unit, &end))
        return 0;
    v->size = fabs(end) > fabs(v->first.number) ? fabs(end) : fabs(v->first.number);
    if (in_steps) {
        if (flk_number_read(&number, &steps) != NUMBER_OK || flk_text_trim(number).length ||
            steps < 2 || steps != floor(steps))
            return flk_mistake(
                p->mistakes, v->place,
                "the number of values of a range must be a whole number, at least 2");
        v->count = steps;
        v->step = (end - v->first.number) / (steps - 1);
        return v->step != 0 ||
               flk_mistake(p->mistakes, v->place, "the range begins and ends at the same value");
    }
    if (!units_agree(p, v, first, step) || !read_in(p, v, step, &v->first.unit, &v->step))
        return 0;
    if (!((end - v->first.number) * v->step > 0))
        return flk_mistake(p->mistakes, v->place,
                           "the step does not lead to the last value of the range");
    v->count = floor((end - v->first.number) / v->step * (1 + 1e-12) + 1e-9) + 1;
    return 1;
}

static int refuse_tolerance(parser *p, const variation *v, text t)
{
    return flk_mistake(p->mistakes, v->place,
                       "expected a tolerance, such as 0.1 mm or 0.5 %%, not '%t'", t);
}

/* A +- T, A +- T normal */
static int read_tolerance(parser *p, text nominal, text t, variation *v)
{
    text before, after;

    v->form = VARY_TOLERANCE;
    v->count = 1;
    if (flk_text_cut_last(t, " ", &before, &after) &&
        (flk_text_equal(after, "normal") || flk_text_equal(after, "uniform"))) {
        v->is_normal = flk_text_equal(after, "normal");
        t = before;
    }
    if (memchr(nominal.start, ',', nominal.length) || flk_text_range(nominal, &before, &after))
        return flk_mistake(p->mistakes, v->place,
                           "a tolerance applies to one value, not to a list or a range");
    if (!read_first(p, v, nominal))
        return 0;
    if (!t.length)
        return refuse_tolerance(p, v, t);
    if (t.start[t.length - 1] == '%') {
        before = t;
        if (flk_number_read(&before, &v->tolerance) != NUMBER_OK ||
            !flk_text_same(flk_text_trim(before), "%"))
            return refuse_tolerance(p, v, t);
        if (v->first.number == 0)
            return flk_mistake(p->mistakes, v->place,
                               "a tolerance in per cent needs a value other than 0");
        v->tolerance *= fabs(v->first.number) / 100;
    } else if (!units_agree(p, v, nominal, t) || !read_in(p, v, t, &v->first.unit, &v->tolerance)) {
        return 0;
    }
    if (!(v->tolerance > 0))
        return flk_mistake(p->mistakes, v->place, "the tolerance must be positive, not %t", t);
    if (v->target.part == PART_NONE && v->key->sign != SIGN_ANY && v->tolerance >= v->first.number)
        return flk_mistake(p->mistakes, v->place,
                           "the tolerance, %t, is not smaller than the %s, %t", t, v->key->name,
                           nominal);
    return 1;
}

/* One value of a list, the first of which is `first`. */
static int read_item(parser *p, const variation *v, text first, text item, quantity_value *value)
{
    text own = own_piece(v, item);

    if (v->n_pieces > 1 && count_pieces(item) != v->n_pieces)
        return flk_mistake(p->mistakes, v->place,
                           "expected %ld values in step, such as 18 mm & 60 mm, not '%t'",
                           (long)v->n_pieces, item);
    return read(p, v, own, value) && units_agree(p, v, own_piece(v, first), own);
}

/* A, B, C */
static int read_list(parser *p, variation *v)
{
    text rest = v->value, first = next_item(&rest), item = first;

    v->form = VARY_LIST;
    v->list = flk_reader_keep(p, (flk_text_count(v->value, ',') + 1) * sizeof *v->list);
    while (v->list) {
        if (!read_item(p, v, first, item, &v->list[(size_t)v->count]))
            return 0;
        v->count++;
        if (!rest.start)
            return 1;
        item = next_item(&rest);
        if (!item.length && !rest.start)
            return 1; /* a comma at the very end */
    }
    return 0;
}

static int read_variation(parser *p, variation *v)
{
    static const char *const signs[] = {"\302\261", "+/-", "+-"};
    static const char *const others[] = {":", " - "}; /* of a range, elsewhere */
    text before, after;
    size_t i;

    if (v->n_pieces > 1)
        return read_list(p, v);
    for (i = 0; i < sizeof signs / sizeof signs[0]; i++)
        if (flk_text_cut(v->value, signs[i], &before, &after))
            return read_tolerance(p, before, after, v);
    if (flk_text_range(v->value, &before, &after))
        return read_range(p, v);
    for (i = 0; i < sizeof others / sizeof others[0]; i++)
        if (flk_text_cut(v->value, others[i], &before, &after))
            return refuse_range(p, v, "'to' and its step");
    return read_list(p, v);
}

/* The generator of a design, in the caller's memory: GSL would call its error handler if out of memory. */
#define GENERATOR gsl_rng_mt19937
#define STATE_SIZE 5120

typedef struct generator {
    gsl_rng rng;
    double state[STATE_SIZE / sizeof(double)];
} generator;

#define BITS 0xffffffffUL

/* The last steps of MurmurHash3 (A. Appleby, 2011): a one-to-one map of 32 bits that removes patterns. */
static unsigned long mixed(unsigned long x)
{
    x ^= x >> 16;
    x = x * 0x85ebca6bUL & BITS;
    x ^= x >> 13;
    x = x * 0xc2b2ae35UL & BITS;
    return x ^ x >> 16;
}

/* Draw a value within the tolerance: uniform, or normal with a third of the tolerance as standard deviation,
** redrawn while outside. */
static double draw(const variation *v, const gsl_rng *rng)
{
    double x;

    if (!v->is_normal)
        return v->tolerance * (2 * gsl_rng_uniform(rng) - 1);
    do
        x = gsl_ran_gaussian(rng, v->tolerance / 3);
    while (fabs(x) > v->tolerance);
    return x;
}

/* Round to 15 digits of the range's size: 3 * 0.1 to 0.3, and 5e-17 to 0. */
static double rounded(double x, double size)
{
    int digits = 14 - (int)floor(log10(size));
    double power = digits >= 0 && digits <= 22 ? pow(10, digits) : 0;

    return power > 0 && size * power < 1e16 ? floor(x * power + 0.5) / power : x;
}

/* The value with index `i`. */
static quantity_value value_at(const variation *v, unsigned long i, const gsl_rng *rng)
{
    quantity_value value;

    if (v->form == VARY_LIST)
        return v->list[i];
    value = v->first;
    value.number = v->form == VARY_RANGE ? rounded(v->first.number + (double)i * v->step, v->size)
                                         : v->first.number + draw(v, rng);
    value.si = flk_unit_to_si(value.number, value.unit);
    return value;
}

/* The same as the deck writes it. */
static text text_at(parser *p, const variation *v, unsigned long i, double number)
{
    text rest = v->value, item;

    if (v->form != VARY_LIST)
        return flk_setting_text(p, number, v->unit);
    do
        item = next_item(&rest);
    while (i-- > 0);
    return own_piece(v, item);
}

/* Find what a name in [sweep] means; 0 and a mistake if it is not a quantity. */
static int find_quantity(parser *p, variation *v)
{
    const key_info *key;
    setting *s;
    int is_vector;

    if (!v->name.length)
        return flk_mistake(p->mistakes, v->place,
                           "expected a quantity before and after '&', such as "
                           "'crank.length & coupler.length'");
    if (!memchr(v->name.start, '.', v->name.length))
        return flk_mistake(
            p->mistakes, v->place,
            "unknown key '%t' in [sweep]; a quantity is named with its section, such as "
            "crank.length",
            v->name);
    if (!flk_setting_target(p, v->place, v->name, &v->target))
        return 0;
    v->key = key = &flk_key_table[v->target.key == KEY_COUNT ? KEY_TOP_TITLE : v->target.key];
    if (v->target.key != KEY_COUNT) { /* no other reports about it until it has a value */
        v->q = flk_target_quantity(p, &v->target);
        s = flk_setting_of(&p->uses[v->target.use], v->target.key);
        s->is_pending = 1;
        if (v->target.part == PART_NONE)
            s->place = v->place;
    }
    if (flk_target_is_number(&v->target))
        return 1; /* an indicator card is always a curve */
    is_vector = key->form == FORM_POINT || key->form == FORM_VECTOR || key->form == FORM_PLACE;
    return flk_mistake(p->mistakes, v->place,
                       is_vector ? "'%t' has parts: vary its .x, .y, .size or .angle"
                                 : "'%t' is not a quantity that can be varied",
                       v->name);
}

/* 1, and a mistake, if an earlier variation has the same quantity: the same part, or a part that conflicts
** with it. */
static int is_twice(parser *p, const variation *list, const variation *v)
{
    const variation *w;

    for (w = list; w < v; w++) {
        if (w->target.use != v->target.use || w->target.key != v->target.key)
            continue;
        if (w->target.part == v->target.part)
            flk_mistake(p->mistakes, v->place, "'%t' is varied twice", v->name);
        else if ((w->target.part >= PART_SIZE) != (v->target.part >= PART_SIZE))
            flk_mistake(
                p->mistakes, v->place,
                "'%t' does not go with another part that varies: use x and y, or size and angle",
                v->name);
        else
            continue;
        return 1;
    }
    return 0;
}

/* Check that samples and tolerances go together. */
static void check_samples(parser *p, text_place place, int has_tolerance)
{
    const setting *samples = flk_setting_find(p, KEY_SWEEP_SAMPLES),
                  *seed = flk_setting_find(p, KEY_SWEEP_SEED);

    if (seed->si[0] > (double)BITS)
        flk_mistake(p->mistakes, seed->place, "the seed must be less than 4294967296");
    if (has_tolerance && !IS_SET(samples))
        flk_mistake(p->mistakes, place, "a tolerance needs 'samples = NUMBER' in [sweep]");
    if (!has_tolerance && IS_SET(samples))
        flk_mistake(p->mistakes, samples->place,
                    "'samples' needs a tolerance, such as 66 mm +- 0.1 mm");
    if (!p->d->sweep.n_variables)
        flk_mistake(p->mistakes, place,
                    "[sweep] varies nothing: add a line such as 'crank.length = 20 mm to "
                    "30 mm step 2 mm'");
}

/* Leave a quantity without a value, so that its section is not checked further. */
static void leave_out(parser *p, const variation *v)
{
    if (v->key)
        p->uses[v->target.use].is_mistaken = 1;
}

/* Read a line of [sweep], whose quantities vary together.  Returns the number of values, 0 if it has
** mistakes. */
static double read_line(parser *p, const named_value *named)
{
    deck_sweep *sweep = &p->d->sweep;
    int n = count_pieces(named->name), i;
    double count = 0;

    for (i = 0; i < n; i++) {
        variation *list = flk_reader_grow(p, p->variations, &p->variations_capacity,
                                          sweep->n_variables, sizeof *list);
        variation *v;

        if (!list)
            return 0;
        p->variations = list;
        v = &list[sweep->n_variables];
        memset(v, 0, sizeof *v);
        v->name = piece_of(named->name, i);
        v->value = named->value;
        v->place = named->place;
        v->piece = i;
        v->n_pieces = n;
        if (sweep->n_variables == MOST_VARIABLES) {
            flk_mistake(p->mistakes, v->place, "[sweep] varies more than 1000 quantities");
            return 0;
        }
        if (!find_quantity(p, v) || is_twice(p, list, v) || !read_variation(p, v)) {
            leave_out(p, v);
            return 0;
        }
        sweep->n_variables++;
        count = v->count;
    }
    return count;
}

/* Read the lines of [sweep]; returns the number of designs. */
static double read_variations(parser *p, int *has_tolerance)
{
    deck_sweep *sweep = &p->d->sweep;
    double designs = p->samples, count;
    size_t i;

    for (i = 0; i < p->n_named && !p->out_of_memory; i++) {
        if (p->uses[p->named[i].use].section != SECTION_SWEEP)
            continue;
        count = read_line(p, &p->named[i]);
        designs *= count > 0 ? count : 1;
        *has_tolerance |= count > 0 && p->variations[sweep->n_variables - 1].form == VARY_TOLERANCE;
    }
    return designs;
}

/* How many combinations with the same value of a quantity follow each other: the last changes fastest. */
static void set_repeats(variation *list, size_t n)
{
    unsigned long repeat = 1;
    size_t i;

    for (i = n; i-- > 0;) {
        list[i].repeat = repeat;
        if (list[i].piece == 0)
            repeat *= (unsigned long)list[i].count;
    }
}

static unsigned long index_in(const variation *v, const parser *p, unsigned long design)
{
    return design / (unsigned long)p->samples / v->repeat % (unsigned long)v->count;
}

/* Start the generator of a design if it has tolerances. */
static int start_generator(parser *p, unsigned long design, generator *g)
{
    double seed = flk_setting_or(p, KEY_SWEEP_SEED, 1);

    g->rng.type = GENERATOR;
    g->rng.state = g->state;
    if (!IS_SET(flk_setting_find(p, KEY_SWEEP_SAMPLES)))
        return 1;
    if (g->rng.type->size > sizeof g->state)
        return 0;
    gsl_rng_set(&g->rng,
                mixed((mixed(design & BITS) + mixed(((unsigned long)seed + 1) & BITS)) & BITS));
    return 1;
}

void flk_deck_variables(const deck *d, unsigned long design, size_t max, double *values,
                        double *low, double *high)
{
    parser *p = d->settings;
    generator g;
    size_t i;

    if (!start_generator(p, design, &g))
        return;
    for (i = 0; i < d->sweep.n_variables && i < max; i++) {
        const variation *v = &p->variations[i];
        const unit *u = &d->units[v->q].unit;
        unsigned long at = index_in(v, p, design);
        quantity_value value = value_at(v, at, &g.rng), before = value, after = value;

        if (v->form == VARY_RANGE && at > 0)
            before = value_at(v, at - 1, NULL);
        if (v->form == VARY_RANGE && at + 1 < (unsigned long)v->count)
            after = value_at(v, at + 1, NULL);
        values[i] = in_unit(&value, u);
        if (low)
            low[i] = in_unit(&before, u);
        if (high)
            high[i] = in_unit(&after, u);
    }
}

void flk_sweep_assign(parser *p, unsigned long design)
{
    deck_sweep *sweep = &p->d->sweep;
    size_t n = sweep->n_variables, i;
    generator g;

    sweep->variables = flk_reader_keep(p, n * sizeof *sweep->variables);
    if (!sweep->variables)
        return;
    if (!start_generator(p, design, &g)) {
        p->out_of_memory = 1;
        return;
    }
    sweep->design = design;
    for (i = 0; i < n && !p->out_of_memory; i++) {
        const variation *v = &p->variations[i];
        unsigned long at = index_in(v, p, design);
        quantity_value value = value_at(v, at, &g.rng);
        deck_variable *variable = &sweep->variables[i];

        variable->name = v->name;
        variable->q = v->q;
        variable->number = flk_target_number(&v->target);
        variable->value = in_unit(&value, &p->d->units[v->q].unit);
        flk_setting_vary(p, v->place, &v->target, &value, text_at(p, v, at, value.number));
    }
}

/* Read the outputs of each design, and the conditions of the yield. */
static void read_outputs(parser *p)
{
    deck_sweep *sweep = &p->d->sweep;
    const setting *output = flk_setting_find(p, KEY_SWEEP_OUTPUT),
                  *yield = flk_setting_find(p, KEY_SWEEP_YIELD);

    sweep->output.names = output->value;
    sweep->output.place = output->place;
    sweep->yield.names = yield->value;
    sweep->yield.place = yield->place;
}

void flk_sweep_read(parser *p)
{
    section_use *use = flk_section_find(p, SECTION_SWEEP, NULL);
    deck_sweep *sweep = &p->d->sweep;
    size_t before = p->mistakes->count, keys;
    int has_tolerance = 0;
    double designs;
    text_place place;

    if (!use)
        return;
    place = use->place;
    flk_values_read_section(p, use);
    p->samples = GSL_MAX(flk_setting_find(p, KEY_SWEEP_SAMPLES)->si[0], 1);
    keys = p->mistakes->count;
    designs = read_variations(p, &has_tolerance);
    if (p->mistakes->count == keys) {
        check_samples(p, place, has_tolerance);
        if (designs > MOST_DESIGNS)
            flk_mistake(p->mistakes, place, "more than 4e9 designs");
    }
    if (p->mistakes->count == before)
        sweep->n_designs = (unsigned long)designs;
    set_repeats(p->variations, sweep->n_designs ? sweep->n_variables : 0);
    while (sweep->n_variables && !sweep->n_designs)
        leave_out(p, &p->variations[--sweep->n_variables]);
    read_outputs(p);
}
