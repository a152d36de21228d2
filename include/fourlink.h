/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fourlink.h - kinematics and kinetostatics of four-link mechanisms.
**
** The public interface of the library: results of a deck, by name.  Most hosts need ten functions only:
**
**    fourlink_results_open, _free     a deck, from its text
**    fourlink_results_value           any number by its name: Ts at an angle, max(Ts), mu_min, crank.length
**    fourlink_results_find, _get      the same without a search
**    fourlink_results_list, _facts    what there is: columns, inputs; facts
**    fourlink_results_row             all columns of a row
**    fourlink_results_input, _set     a number of the deck, and another value for it, in the unit of its line
**
** They stand first.  fourlink/structures.h, which this header includes, has mechanisms, motions, forces and
** synthesis as structures; fourlink/fortran77.h the calls for FORTRAN 77.
**
** The headers are strict C90 and compile as C++98.  The library keeps no state, prints nothing and never ends
** the process.  Memory is taken where a deck or a design is opened or a number is set, where a motion is
** integrated, and where a slip is sought (fourlink_results_open, note 3).
**
** Who owns what, and until when
**
**   what the host passes in              the host; the call does not keep it
**   what its loader returns              the host; until the loader is called again, or the deck is read
**   results                              the host, until it gives them to fourlink_results_free.  Those of
**                                        fourlink_results_design and _open_like are freed before those that
**                                        they are from
**   a deck of fourlink_deck_read         the host, until it gives it to fourlink_deck_free
**   the deck of fourlink_results_deck,   the results, until a number of them is set or they are freed
**   lists, texts of values and checks
**   the list of fourlink_results_facts   the results, until the next call of it, a number is set, or they are
**                                        freed; its texts as those of values
**   names of loads, points, springs      the deck that they are from, as long as that is valid
**   structures, mistakes, notes, slips   the host: they are copies
**   what fourlink_..._text return, and   constants
**   fourlink_version
**   handles                              numbers, valid as long as the results; those of columns, facts and
**                                        variables for all designs
**
** A number is set by fourlink_results_set, _set_text and _put; if that fails, all stays valid.
**
** Which calls may run at once
**
**   on different results, decks, structures   all
**   on the same results or deck               those that take it as const; another one needs it alone
**   on results and their fourlink_results_deck, or on those of fourlink_results_open_like and `like`
**                                             as on the same results
**   on results and those of fourlink_results_design from them, or two of these
**                                             all but fourlink_results_free of those that they are from
**
** Conventions
**
**   Links    1 ground (A-D), 2 crank (A-B), 3 coupler or connecting rod (B-C), 4 rocker (D-C) or
**            piston (at C).  In an inverted slider-crank link 3 is the slider, pinned to the crank at
**            B, and link 4 the lever, which turns about D; the slider slides along the lever.  Arrays
**            over links are indexed by the link's number.
**   Frame    Right-handed, fixed to link 1: origin A, x along A->D (four-bar, inverted slider-crank)
**            or along the line of stroke from the crankshaft to the piston (slider-crank), z out of
**            the paper.  Results by name, and the crank angles given to functions on them, are in the
**            axes of the deck: with `axes = page` those of a page, in which x of link 1 has a direction
**            (fourlink_problem).  Structures are always in this frame, theta2 too.
**   Units    Results by name are in the units of the deck's results, which each value tells; structures
**            are in SI units and radians.  Angles, angular speeds and torques are positive
**            counter-clockwise.
**   Forces   F_ij is the force that link i exerts ON link j.  Ts is the torque that the ground (the
**            motor) exerts on the crank; a machine that delivers torque has Ts < 0.
**   Status   Every function that can fail returns a status: FOURLINK_OK (0), or one of the codes of
**            FOURLINK_STATUS_LIST.  If it is not 0, the outputs are unchanged.
**
** Sources, by the short names used in the code
**
**   Alvi     N. G. Alvi, S. V. Deshmukh, R. R. Wayzode, "Computer Aided Analysis of Four bar Chain
**            Mechanism".
**   ME3491   "ME3491 Theory of Machines", chapter 2, Dynamic Force Analysis (course material,
**            Rohini College of Engineering & Technology).
**   DFA      "Dynamic Force Analysis: Analytical Method" (lecture notes).
**
** All three contain misprints and errors; data/ERRATA.md lists them.
*/
#ifndef FOURLINK_H
#define FOURLINK_H

#ifdef __cplusplus
extern "C" {
#endif

#if defined(FOURLINK_BUILDING) && defined(__GNUC__) && __GNUC__ >= 4
#define FOURLINK_API __attribute__((visibility("default")))
#else
#define FOURLINK_API
#endif

#define FOURLINK_VERSION "0.3.0"

/* ---------------------------------------------------------------------------------------------
** A deck and its results: what the functions take and return
** ------------------------------------------------------------------------------------------- */

/* The two assembly modes.
**
** Four-bar:     open, C lies to the left of the directed line B->D; crossed, to the right.
** Slider-crank: open, the piston is on the +x side of the crank pin; crossed, on the -x side.
** Inverted:     open, B lies on the positive side of the foot of the perpendicular from D, looking along
**               the slide; crossed, on the negative side.
** Scotch yoke:  one mode, called open.
**
** A mechanism whose links can all lie in one line (a change point, at crank angle 0 or 180 deg; for a
** slider-crank at +90 or -90 deg, for an inverted one at 0) passes smoothly from one side to the other.  The
** label follows the smooth motion that is on the named side just after crank angle 0 (four-bar, inverted), or
** at crank angle 0 (slider-crank).  It depends only on the lengths and on the angle, which is not reduced by
** 360 deg here.
*/
typedef enum fourlink_branch { FOURLINK_OPEN = 1, FOURLINK_CROSSED = -1 } fourlink_branch;

/* The side on which an input is, another coordinate than the crank angle: it rises while the crank turns
** counter-clockwise, or falls. */
enum { FOURLINK_RISING = 1, FOURLINK_FALLING = -1 };

/* A deck that has been read. */
typedef struct fourlink_deck fourlink_deck;

/* A mistake in a deck, which the command prints as "FILE:LINE: error: MESSAGE", or a note on something that
** is allowed but probably not meant: "FILE:LINE: note: MESSAGE".  The line is 0 for an assignment from
** outside the deck. */
typedef struct fourlink_mistake {
    char file[1024];   /* a file that the deck names, the answers, or the origin of a change; "":
                          the deck */
    long line;         /* from 1; 0: in a change, not in a file */
    char message[400]; /* null-terminated */
} fourlink_mistake;

/* Loads a file that a deck names, such as an indicator card.
**
** Given:
**    host       as given to fourlink_deck_read
**    file_name  as written in the deck
** Returned:
**    length     of the file, in bytes
** Returned (function value):
**    the file's text, which must stay valid until the next call or the end of fourlink_deck_read;
**    null if there is no such file
*/
typedef const char *fourlink_loader(void *host, const char *file_name, unsigned long *length);

/* An assignment from outside a deck.  It replaces that of the deck, or is added. */
typedef struct fourlink_change {
    const char *origin;     /* named in messages as its place, such as "--set" */
    const char *assignment; /* [SECTION[ NAME].]KEY=VALUE */
} fourlink_change;

/* For fourlink_results_open: the first design without mistakes.  The first thousand designs are tried, and a
** thousand spread over all; if all of these have mistakes, the first design is used.  For a deck of more than
** 100,000 bytes only the first design is tried. */
#define FOURLINK_ANY_DESIGN 0xffffffffUL

/* The source of a deck.  Set it to zero first: members that stay 0 are absent. */
typedef struct fourlink_source {
    const char *name;      /* the deck's name in messages; null: "" */
    const char *text;      /* the deck's text, as in a file */
    unsigned long length;  /* its length in bytes */
    fourlink_loader *load; /* loads the files that the deck names; null if it may not name any */
    void *host;            /* for `load` */
    const fourlink_change *changes;
    unsigned long n_changes;
    const char *answers_name; /* as `name`, for `answers` */
    const char *answers; /* [expect] and [misprint] sections instead of the deck's; may be null */
    unsigned long answers_length;
    unsigned long design; /* which design of a [sweep], from 0, or FOURLINK_ANY_DESIGN */
    const char
        *units; /* units of results, such as "mm, kg, rpm", or "SI", in place of those of the deck,
                             whose bare numbers keep theirs; null: the deck's */
    int deck_units; /* 1: for people; without a unit of length in the deck or in `units`, what has no
                             unit there is in that of the crank's length and in SI or, where that is in
                             or ft, in customary units: in/s, lbf, lbf in, lb, psi, hp ... */
    unsigned long
        synthesis;   /* K: for a deck with [synthesis], the linkage of solution K of its task,
                                from 1; 0: such a deck has a mistake */
    int whole_cycle; /* for fourlink_results_open; 1: a deck with one crank angle is run over the
                             cycle that has it, from a whole number of cycles, with the same speed and
                             acceleration at every row */
    unsigned long effort; /* a search of [synthesis] from many starts has so many times the usual
                             number of them; 0: once */
    const struct fourlink_solution *near; /* it starts from this linkage alone, found for as many
                             positions; null: from many starts */
} fourlink_source;

/* A deck opened for results; it owns all memory that columns, searches and lists need. */
typedef struct fourlink_results fourlink_results;

/* A named number or text: a column, an extreme, a fact, an input.  Its texts belong to the results. */
typedef struct fourlink_value {
    const char *name;     /* Ts, max(Ts), mu_min, crank.length */
    const char *unit;     /* as the deck names it; "1": a plain number; "": words */
    const char *quantity; /* length, torque ..., as in [units]; "number" */
    const char *meaning;
    const char *source; /* its name in the sources; "": none */
    const char *words;  /* a value in words; null: a number */
    double value;       /* in its unit; infinite: unbounded */
    double to_si;       /* value * to_si is the value in SI units and radians */
    int has_angle;      /* 1: it belongs to a crank angle */
    double angle;       /* the crank angle, in the deck's unit */
    int branch;         /* FOURLINK_OPEN, FOURLINK_CROSSED; 0: the same on both */
    int flags;          /* of a column, an extreme, a mean: FOURLINK_OF_CRANK ...; of a condition:
                           FOURLINK_ABOVE ... */
    int handle;         /* for fourlink_results_get */
    const char
        *line_unit; /* of an input or a variable that is a number: the unit of its line, in which
                              fourlink_results_set takes it; null: it cannot be set */
} fourlink_value;

enum {
    FOURLINK_OF_CRANK = 1,      /* depends on the crank alone: has a value at every crank angle */
    FOURLINK_CRANK_ANGLE = 2,   /* the crank angle itself, which has no extremes */
    FOURLINK_OF_ROUNDING = 4,   /* a measure of rounding */
    FOURLINK_OF_FORCES = 8,     /* needs the forces, or the engine method */
    FOURLINK_FRICTIONLESS = 16, /* of the forces, has no friction of this motion in it */
    FOURLINK_DIRECTION = 32     /* whole turns do not count */
};

/* Add one of these to the handle of a column to get the handle of its statistic. */
enum { FOURLINK_MAX = 1, FOURLINK_MIN = 2, FOURLINK_MEAN = 3, FOURLINK_RMS = 4 };

/* Conditions: above or below the value, or equal to it. */
enum { FOURLINK_ABOVE = 1, FOURLINK_BELOW = 2, FOURLINK_OR_EQUAL = 4 };

/* The lists of fourlink_results_list. */
enum {
    FOURLINK_COLUMNS = 1,     /* the columns that the deck requests, or the usual ones */
    FOURLINK_ALL_COLUMNS = 2, /* all columns that it can have, without the opposite forces, such as
                                 F32x, which it has by name */
    FOURLINK_INPUTS = 3,      /* the inputs as the reader understood them */
    FOURLINK_VARIABLES = 4,   /* the quantities that its [sweep] varies, with this design's
                                 values */
    FOURLINK_OUTPUTS = 5,     /* the outputs that its [sweep] names */
    FOURLINK_CONDITIONS = 6   /* the conditions of its yield: outputs with limits; `meaning` is the
                                 text */
};

/* Groups of facts; add them to combine them. */
enum {
    FOURLINK_FACTS_LIMITS = 1,   /* type, reach, limits, masses: always present */
    FOURLINK_FACTS_EXTREMES = 2, /* max() and min() of the columns */
    FOURLINK_FACTS_TURNING = 4,  /* turning moment and flywheel */
    FOURLINK_FACTS_MOTION = 8,   /* actual motion: mean speed, fluctuation, run-up */
    FOURLINK_FACTS_NAMES = 16    /* alone: all that any deck can have but max() and min(), by name,
                                    without values; nothing is computed */
};

/* Of fourlink/structures.h. */
typedef struct fourlink_load fourlink_load;
typedef struct fourlink_instant fourlink_instant;
typedef struct fourlink_turning fourlink_turning;

/* ---------------------------------------------------------------------------------------------
** Ten functions
** ------------------------------------------------------------------------------------------- */

/* Open a deck for results: read it, check it, and allocate the memory that results need.
**
** Given:
**    source        the deck's text, and changes to it
**    max_mistakes  size of `mistakes`
** Returned:
**    results       to be given to fourlink_results_free
**    mistakes      only with FOURLINK_BAD_DECK: the first of them, in the order of the lines; may be
**                  null if max_mistakes is 0
**    n_mistakes    only with FOURLINK_BAD_DECK: how many there are, which may exceed max_mistakes;
**                  may be null
** Returned (function value):
**    FOURLINK_OK, FOURLINK_BAD_DECK; FOURLINK_NULL, FOURLINK_NO_MEMORY; with [synthesis], as
**    FOURLINK_BAD_DECK, why there is no linkage: FOURLINK_DEPENDENT to FOURLINK_NONE_FOUND
** Notes:
** 1) The text is not needed after the call.
** 2) In addition to what fourlink_deck_read checks, the names of columns and of a sweep's outputs
**    are checked.
** 3) The functions below allocate nothing, with three exceptions.  fourlink_results_check opens the deck
**    again, once with each, as slips may have changed it: without weights, in other axes.  The first
**    extreme, mean or crossing takes room for searches.  A motion that is not given is integrated on a
**    branch when something is first asked that follows from it, which can take seconds.  Facts of a run-up
**    need the steady motion that it approaches, which is sought when one is first asked.  A call that does
**    this can return FOURLINK_NO_MEMORY, and nothing else; it may be called again.  fourlink_results_end
**    integrates the motion, fourlink_results_facts with FOURLINK_FACTS_MOTION also finds its facts, with
**    FOURLINK_FACTS_EXTREMES takes room for searches, for programs that must not fail later.  Inputs, lists
**    and facts of FOURLINK_FACTS_LIMITS need no motion.  No result depends on earlier calls.
*/
FOURLINK_API int fourlink_results_open(const fourlink_source *source, unsigned long max_mistakes,
                                       fourlink_results **results, fourlink_mistake *mistakes,
                                       unsigned long *n_mistakes);

/* Open a deck that may be the same as an open one, but for its answers or the units of its results.  Where
** all settings and the unit of angles are the same, so is its motion: it is that of `like`.  To integrate
** it again could take seconds.  All else is as from fourlink_results_open.
**
** Given:
**    like          results of a deck; null is allowed.  Before `results` is freed it must neither be freed
**                  nor have numbers set
**    others        as for fourlink_results_open
** Returned:
**    as from fourlink_results_open
** Returned (function value):
**    as from fourlink_results_open
*/
FOURLINK_API int fourlink_results_open_like(const fourlink_source *source, fourlink_results *like,
                                            unsigned long max_mistakes, fourlink_results **results,
                                            fourlink_mistake *mistakes, unsigned long *n_mistakes);

/* Free results; null is allowed. */
FOURLINK_API void fourlink_results_free(fourlink_results *results);

/* Get any number by its name: fourlink_results_find and fourlink_results_get in one call.
**
** Given:
**    name       as for fourlink_results_find
**    others     as for fourlink_results_get
** Returned:
**    as from fourlink_results_get
** Returned (function value):
**    as from fourlink_results_get
*/
FOURLINK_API int fourlink_results_value(fourlink_results *results, const char *name,
                                        fourlink_branch branch, double angle,
                                        fourlink_value *value);

/* Look up a name: a column, an extreme or mean of one, a fact, an input or a variable.
**
** Given:
**    results    from fourlink_results_open
**    name       a column such as Ts; max(Ts), min(Ts), mean(Ts), rms(Ts); "Ts at 30 deg"; a fact such as
**               mu_min; an input such as crank.length
** Returned:
**    found      name, unit, quantity, meaning, flags, the handle for fourlink_results_get, and has_angle:
**               1 for a column, which has a value at every crank angle; of "Ts at 30 deg" 0, and its angle
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_NAME
** Notes:
** 1) The name is looked up once; reading values by the handle needs no search.
** 2) The handle is valid for these results; that of a column, fact or variable is valid for all designs
**    of the deck's sweep; that of "Ts at 30 deg", for those opened later.  It is never 0.  At most 256
**    names with an angle, of less than 64 letters, have handles; fourlink_results_value takes any.
** 3) Entries of lists and facts have handles too.  FOURLINK_MAX, _MIN, _MEAN or _RMS may be added to the
**    handle of a column.
** 4) A fact is found even if this design does not have it: for example, the stroke of a four-bar linkage.
*/
FOURLINK_API int fourlink_results_find(fourlink_results *results, const char *name,
                                       fourlink_value *found);

/* Get the value that a handle stands for.
**
** Given:
**    results    from fourlink_results_open
**    handle     from fourlink_results_find, a list, facts or another value
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
**    angle      of a column: crank angle in the deck's unit; else not used
** Returned:
**    value      with name, unit, meaning, and the crank angle at which it occurs if it has one
** Returned (function value):
**    FOURLINK_OK; 1 to 19 or 63, why a column has no value, or why the actual motion ends before a fact is
**    known; FOURLINK_NULL, FOURLINK_BAD_BRANCH, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_FACT,
**    FOURLINK_NO_SUCH_ANGLE
** Notes:
** 1) Extremes are those of the deck's motion, refined between its rows.
** 2) FOURLINK_NO_SUCH_FACT means that only other mechanisms have this fact, such as the stroke of a four-bar
**    linkage.  FOURLINK_NO_SUCH_NAME means that the handle does not belong to these results, or is that of a
**    column that this design of a sweep does not have.
** 3) If several facts have the same name, such as the ends of two ranges, this is the first.
** 4) Mean and rms are taken over the crank angle, not over time, for the part of the deck's motion in which
**    the column has a value: (integral of y dtheta2) / c, and the root of (integral of y^2 dtheta2) / c.  An
**    angle is continued beyond 180 deg.  Mean and rms are infinite where the integral is: at a dead position
**    velocities grow as 1 / sqrt(distance), so they have a mean but an infinite rms; at a change point forces
**    grow as 1 / distance and have neither.  If the integral is infinite in both directions, as that of
**    mechanical_advantage, the status is FOURLINK_NO_MEAN.
*/
FOURLINK_API int fourlink_results_get(fourlink_results *results, int handle, fourlink_branch branch,
                                      double angle, fourlink_value *value);

/* A list of names: columns, inputs, variables and outputs of a sweep.
**
** Given:
**    results    from fourlink_results_open
**    which      FOURLINK_COLUMNS ... FOURLINK_CONDITIONS
** Returned:
**    list       the entries, which belong to the results; `value` is set for inputs, variables and
**               conditions, 0 for columns and outputs
**    n          how many
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_LIST
*/
FOURLINK_API int fourlink_results_list(fourlink_results *results, int which,
                                       const fourlink_value **list, unsigned long *n);

/* A row of the deck's columns.
**
** Given:
**    results    from fourlink_results_open
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
**    i          0 ... problem.n_rows - 1
** Returned (each may be null):
**    values     of the list FOURLINK_COLUMNS, in their units; NaN where a column has no value
**    instant    the motion and the forces of the row
**    loads      the problem.n_loads loads at its crank angle, including springs and friction
** Returned (function value):
**    FOURLINK_OK; 1 to 19 or 63, why only the crank has values in this row; FOURLINK_NULL,
**    FOURLINK_BAD_BRANCH, FOURLINK_NO_SUCH_ROW
** Note:
**    The crank's columns, `instant->row` and `instant->status` are returned with codes 1 to 19 and 63 too.
*/
FOURLINK_API int fourlink_results_row(fourlink_results *results, fourlink_branch branch,
                                      unsigned long i, double *values, fourlink_instant *instant,
                                      fourlink_load *loads);

/* The facts of a deck: results that are single numbers or words.
**
** Given:
**    results    from fourlink_results_open
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED; 0: the branches that the deck requests
**    groups     sum of FOURLINK_FACTS_LIMITS ...
** Returned:
**    facts      they belong to the results, until the next call of this function
**    n          how many
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_BRANCH, FOURLINK_NO_MEMORY
*/
FOURLINK_API int fourlink_results_facts(fourlink_results *results, int branch, int groups,
                                        const fourlink_value **facts, unsigned long *n);

/* A number of the deck in the unit of its line, in which fourlink_results_set takes it.
**
** Given:
**    results    from fourlink_results_open or fourlink_results_design
**    name       of a number, such as crank.length or "load L.force.size": SECTION[ NAME].KEY, for a force or
**               a point with .x, .y, .size or .angle; its section must be in the deck
** Returned:
**    input      value, unit, quantity, to_si, handle.  The value is NaN if the deck does not give the number
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NO_SUCH_NAME, FOURLINK_NOT_A_NUMBER, FOURLINK_NULL
** Notes:
** 1) The unit of a line `length = 45 mm` is mm, of `speed = 60 rpm` rpm, of a force `50 N at 30 deg` N, and
**    deg for its .angle.  A bare number, and a key that the deck does not give, have the unit of [units],
**    SI and degrees without it.
** 2) fourlink_results_value gives the same number in the unit of results.
*/
FOURLINK_API int fourlink_results_input(fourlink_results *results, const char *name,
                                        fourlink_value *input);

/* Set a number of the deck.  All results are then those of the deck with this value; its text is not read
** again.
**
** Given:
**    results    from fourlink_results_open or fourlink_results_design
**    name       as for fourlink_results_input
**    value      in the unit that its line has in the deck, as fourlink_results_input tells it: 45 for
**               `length = 40 mm` is 45 mm
** Returned:
**    mistake    if the deck has a mistake with this value, the first one; may be null
** Returned (function value):
**    FOURLINK_OK, FOURLINK_BAD_DECK; FOURLINK_NO_SUCH_NAME, FOURLINK_NOT_A_NUMBER, FOURLINK_BAD_NUMBER,
**    FOURLINK_NULL, FOURLINK_NO_MEMORY
** Notes:
** 1) What depends on the number follows it: uniform links, points given in per cent, counterweights.
** 2) Unless the status is FOURLINK_OK, the results stay as they were.
** 3) Numbers set before keep their values.
** 4) Lists, texts, facts and the deck got from the results before are no longer valid.  Handles are.
** 5) fourlink_results_notes gives only notes on the design that is built, not notes on the text.
** 6) fourlink_deck_write writes the deck with the numbers set.
*/
FOURLINK_API int fourlink_results_set(fourlink_results *results, const char *name, double value,
                                      fourlink_mistake *mistake);

/* ---------------------------------------------------------------------------------------------
** Other functions
** ------------------------------------------------------------------------------------------- */

/* The result of comparing a printed value with the computed one. */
typedef enum fourlink_verdict {
    FOURLINK_AGREES = 0,
    FOURLINK_DIFFERS = 1,
    FOURLINK_MISPRINT = 2,    /* [misprint]: it differs, as expected */
    FOURLINK_NO_MISPRINT = 3, /* [misprint]: it agrees, unexpectedly */
    FOURLINK_NO_VALUE = 4     /* nothing to compare; the message says why */
} fourlink_verdict;

/* Where the tolerance of a comparison is from. */
enum {
    FOURLINK_FROM_DIGIT = 1,   /* half of the last digit */
    FOURLINK_FROM_SECTION = 2, /* `tolerance` beside the value */
    FOURLINK_FROM_GRADING = 3, /* [grading] in the deck's text */
    FOURLINK_FROM_CHANGE = 4   /* [grading] by a change, such as an option */
};

/* The comparison of a value of [expect] or [misprint]. */
typedef struct fourlink_check {
    fourlink_verdict verdict;
    const char *file; /* where it is written */
    long line;
    char name[64];                       /* of the column or fact; cut off if longer */
    char printed_text[64];               /* the value as written; cut off if longer */
    double printed, computed, tolerance; /* in `unit`; 0 if there is no value, or for words */
    const char *unit;                    /* "": words */
    char words[100];                     /* a fact in words, as computed; "": a number */
    int has_angle;                       /* 1: a column, at the crank angle `angle` */
    double angle;                        /* in the deck's unit of angle */
    int has_place; /* 1: at a place of what the rows go over, such as a time, when the crank is at `angle`; */
    double place; /* ... in this unit */
    const char *place_unit;
    fourlink_branch branch;
    int side; /* FOURLINK_RISING, FOURLINK_FALLING, of such a place where the rows have both; else 0 */
    long message_line; /* FOURLINK_NO_VALUE: line of the mistake in `file` */
    char message[400]; /* FOURLINK_NO_VALUE: why */
    char hint[200]; /* FOURLINK_DIFFERS: a possible reason, or ""; FOURLINK_AGREES: in which unit */
    int tolerance_from; /* FOURLINK_FROM_DIGIT ...; 0 for words */
    double marks;       /* that it is worth, of [grading]; otherwise 1 */
    double part; /* of these, what it gets: 1; 0; 0.5 with a hint where [grading] has hint = half */
    int is_misprint; /* 1: of [misprint] */
    int is_short;    /* 1: it has fewer digits than [grading] asks for */
} fourlink_check;

/* Set a number with a unit: "motion.speed = 60 rpm".  The unit of the line stays as it was: a number set
** without a unit afterwards is in that.
**
** Given:
**    results    as for fourlink_results_set
**    words      NAME = NUMBER UNIT; without a unit the number is in that of its line
** Returned:
**    mistake    of the deck with this value, or of the words, with line 0; may be null
** Returned (function value):
**    as from fourlink_results_set; FOURLINK_BAD_NUMBER for another unit than one of its quantity
*/
FOURLINK_API int fourlink_results_set_text(fourlink_results *results, const char *words,
                                           fourlink_mistake *mistake);

/* Set several numbers at once, by their handles: in one step, so that no deck with only some of them is
** built.
**
** Given:
**    results    as for fourlink_results_set
**    n          how many
**    handles    of the numbers, from fourlink_results_find
**    values     in the units of their lines: `line_unit` of the lists and of fourlink_results_find
** Returned:
**    mistake    as from fourlink_results_set
** Returned (function value):
**    as from fourlink_results_set
*/
FOURLINK_API int fourlink_results_put(fourlink_results *results, unsigned long n,
                                      const int *handles, const double *values,
                                      fourlink_mistake *mistake);

/* A row without its forces, which take most of the time of one: they are computed only for columns, and
** with friction, where they decide whether the machine moves.
**
** Given:
**    as for fourlink_results_row
** Returned (each may be null):
**    values     as from fourlink_results_row
**    instant    the motion of the row; forces, losses and gas_force are 0
** Returned (function value):
**    as from fourlink_results_row; that forces have no solution is found only where they are computed
*/
FOURLINK_API int fourlink_results_motion(fourlink_results *results, fourlink_branch branch,
                                         unsigned long i, double *values,
                                         fourlink_instant *instant);

/* The same at any place of what the rows go over.
**
** Given:
**    place      as for fourlink_results_along
**    others     as for fourlink_results_motion
** Returned, also as function value:
**    as from fourlink_results_motion, with FOURLINK_NO_SUCH_ANGLE instead of FOURLINK_NO_SUCH_ROW
*/
FOURLINK_API int fourlink_results_motion_along(fourlink_results *results, fourlink_branch branch,
                                               double place, double *values,
                                               fourlink_instant *instant);

/* A row in brief, for tables: its values, and of the instant what says where and how it is.
**
** Given:
**    as for fourlink_results_motion
** Returned (each may be null):
**    values     as from fourlink_results_row
**    instant    branch, status and row; of the state mu, sine and group_sine.  The rest is not set
** Returned (function value):
**    as from fourlink_results_motion
*/
FOURLINK_API int fourlink_results_brief(fourlink_results *results, fourlink_branch branch,
                                        unsigned long i, double *values, fourlink_instant *instant);

/* The same as fourlink_results_row at any crank angle of the motion.
**
** Given:
**    angle      in the deck's unit of angle; turns are not counted
**    others     as for fourlink_results_row
** Returned:
**    as from fourlink_results_row
** Returned (function value):
**    as from fourlink_results_row, with FOURLINK_NO_SUCH_ANGLE instead of FOURLINK_NO_SUCH_ROW
*/
FOURLINK_API int fourlink_results_at(fourlink_results *results, fourlink_branch branch,
                                     double angle, double *values, fourlink_instant *instant,
                                     fourlink_load *loads);

/* The same at any place of what the rows go over (fourlink_abscissa), by angle as fourlink_results_at.
**
** Given:
**    place      an angle in the deck's unit or, of rows by time, a time in s; of an input its value, rad or
**               m, on its rising side if the deck asks for both
**    others     as for fourlink_results_row
** Returned, also as function value:
**    as from fourlink_results_at
*/
FOURLINK_API int fourlink_results_along(fourlink_results *results, fourlink_branch branch,
                                        double place, double *values, fourlink_instant *instant,
                                        fourlink_load *loads);

/* The same on a side of an input, of a deck with [motion] side = both.
**
** Given:
**    side       FOURLINK_RISING or FOURLINK_FALLING
**    others     as for fourlink_results_along
** Returned, also as function value:
**    as from fourlink_results_along; FOURLINK_NO_SUCH_ANGLE on a side that the deck does not ask for
*/
FOURLINK_API int fourlink_results_on_side(fourlink_results *results, fourlink_branch branch,
                                          int side, double place, double *values,
                                          fourlink_instant *instant, fourlink_load *loads);

/* What the rounding error of a column is a small part of in a row, where that does not follow from the
** machine: of a spring, which can be far weaker than the machine, or far stronger.
**
** Given:
**    handle     of a column of a spring, or of its extremes
**    instant    of a row, as from fourlink_results_row
** Returned:
**    size       in the unit of the column
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_NAME: another column, for which there is none, or no row
*/
FOURLINK_API int fourlink_results_size(fourlink_results *results, int handle,
                                       const fourlink_instant *instant, double *size);

/* Many rows of any columns, by their handles.
**
** Given:
**    results    from fourlink_results_open or fourlink_results_design
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
**    first, n   the rows: from this one, counted from 0
**    n_columns  how many columns
**    handles    of the columns, from fourlink_results_find or a list
** Returned:
**    values     n rows of n_columns numbers, in the units of the columns; NaN where a column has no value
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_BRANCH, FOURLINK_NO_SUCH_ROW if the motion has fewer rows,
**    FOURLINK_NO_SUCH_NAME for a handle that is not that of a column
*/
FOURLINK_API int fourlink_results_rows(fourlink_results *results, fourlink_branch branch,
                                       unsigned long first, unsigned long n,
                                       unsigned long n_columns, const int *handles, double *values);

/* The crank angles at which a column has a value, such as theta4 = 120 deg.
**
** Given:
**    results    from fourlink_results_open; not with rows by time
**    column     its name, as in a list of columns
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
**    value      in the column's unit; angles that differ by whole turns count as equal
**    max        size of `angles`
** Returned:
**    angles     of the crank, also where the rows go over another input, in the deck's unit of angle and
**               the order of the motion; may be null if max is 0
**    n          how many there are, which may exceed max
** Returned (function value):
**    FOURLINK_OK; FOURLINK_CONSTANT, FOURLINK_LONG_SEARCH, FOURLINK_TOO_LONG; FOURLINK_NO_SUCH_NAME,
**    FOURLINK_NO_SUCH_ANGLE (rows by time), FOURLINK_BAD_BRANCH, FOURLINK_BAD_NUMBER, FOURLINK_NULL
** Note:
**    Touching the value counts.  Jumping over it does not: at the edge of a load, through infinity, from 180
**    to -180 deg.  Of a stretch in which the column keeps the value, the ends count.  If a revolution ends
**    where it began, that angle is counted once.
*/
FOURLINK_API int fourlink_results_crossings(fourlink_results *results, const char *column,
                                            fourlink_branch branch, double value, unsigned long max,
                                            double *angles, unsigned long *n);

/* Where the actual motion of the machine ends.
**
** Given:
**    results    from fourlink_results_open
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
** Returned:
**    angle      crank angle at which it ends, in the deck's unit; that of the last row if it does not end
**               earlier
** Returned (function value):
**    FOURLINK_OK: the machine moves through all rows, or its motion is given;
**    1 to 19, why it does not: FOURLINK_DOES_NOT_START, FOURLINK_STALLS, FOURLINK_NO_STEADY ...;
**    FOURLINK_NULL, FOURLINK_BAD_BRANCH
** Note:
**    `angle` is returned with codes 1 to 19 and 63 too.  The rows from there on have the same status.
*/
FOURLINK_API int fourlink_results_end(fourlink_results *results, fourlink_branch branch,
                                      double *angle);

/* The turning moment over a cycle, with its areas.
**
** Given:
**    results    from fourlink_results_open
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
** Returned:
**    turning    in SI units
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_BRANCH, FOURLINK_NO_TURNING_MOMENT
** Reference:
**    ME3491, "Turning moment diagrams"; see mean.c.
*/
FOURLINK_API int fourlink_results_turning(fourlink_results *results, fourlink_branch branch,
                                          fourlink_turning *turning);

/* Compare a value of [expect] or [misprint] with the computed one.
**
** Given:
**    results    from fourlink_results_open
**    i          0 ... problem.n_expected - 1, in the order of the deck
** Returned:
**    check      the printed value, the computed one, and whether they agree
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_ROW; FOURLINK_NO_MEMORY as all functions on a branch; a
**    value that differs is sought on the other one, and in the deck as slips may have changed it
*/
FOURLINK_API int fourlink_results_check(fourlink_results *results, unsigned long i,
                                        fourlink_check *check);

/* Open another design of the [sweep] of an open deck, as new results beside those; of a deck with
** [synthesis] and no [sweep], another solution of its task.  The text is not read again, nor the task solved,
** which saves most of the time of fourlink_results_open.
**
** Given:
**    from          results of the deck, or of a design; must not be freed before `results`
**    design        its number, from 0: below n_designs of fourlink_problem; of solutions, below the number
**                  that is kept, see fourlink_deck_solutions
**    max_mistakes  size of `mistakes`
** Returned:
**    results       a new handle, to be given to fourlink_results_free as that of `from` is
**    mistakes      as from fourlink_results_open
**    n_mistakes    as from fourlink_results_open
** Returned (function value):
**    FOURLINK_OK, FOURLINK_BAD_DECK; FOURLINK_BAD_NUMBER if there is no such design, FOURLINK_NULL,
**    FOURLINK_NO_MEMORY
** Notes:
** 1) `from` is not changed, and numbers set there are not set in the design.
** 2) fourlink_results_notes gives only notes on the design that is built, not notes on the text.
*/
FOURLINK_API int fourlink_results_design(const fourlink_results *from, unsigned long design,
                                         unsigned long max_mistakes, fourlink_results **results,
                                         fourlink_mistake *mistakes, unsigned long *n_mistakes);

/* The values of the quantities that a sweep varies, in any design, and in its neighbours on the grid.
**
** Given:
**    results    of the deck, or of a design
**    design     its number, from 0; it may have mistakes
**    max        size of `values`, `low` and `high`
** Returned:
**    values     of the list FOURLINK_VARIABLES, in the deck's units
**    low, high  the values before and after them in their ranges; the same value at an end of a range, and
**               for a list.  May be null
** Returned (function value):
**    FOURLINK_OK; FOURLINK_BAD_NUMBER if there is no such design, FOURLINK_NULL
*/
FOURLINK_API int fourlink_results_variables(const fourlink_results *results, unsigned long design,
                                            unsigned long max, double *values, double *low,
                                            double *high);

/* The notes on a deck: things that are allowed but probably not meant, such as a link with a mass but no
** centre of mass.
**
** Given:
**    results    from fourlink_results_open
**    max_notes  size of `notes`
** Returned:
**    notes      the first of them, in the order of the lines; may be null if max_notes is 0
**    n_notes    how many there are, which may exceed max_notes; may be null
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
*/
FOURLINK_API int fourlink_results_notes(const fourlink_results *results, unsigned long max_notes,
                                        fourlink_mistake *notes, unsigned long *n_notes);

/* The lines of the answers of a source that are not read, and why; each costs the values in it alone.
**
** Given:
**    results    from fourlink_results_open
**    max_slips  size of `slips`
** Returned:
**    slips      the first of them, in the order of the lines; may be null if max_slips is 0
**    n_slips    how many there are, which may exceed max_slips; may be null
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
*/
FOURLINK_API int fourlink_results_slips(const fourlink_results *results, unsigned long max_slips,
                                        fourlink_mistake *slips, unsigned long *n_slips);

/* The column that another name means: Ts for torque, omega4 for w4, F12 for force12.  Null if there is
** none. */
FOURLINK_API const char *fourlink_results_meant(const fourlink_results *results, const char *name);

/* The deck of results, for the functions fourlink_deck_...  It belongs to the results.  Null for null. */
FOURLINK_API const fourlink_deck *fourlink_results_deck(const fourlink_results *results);

/* The text of a status code: a constant string in English, never null. */
FOURLINK_API const char *fourlink_status_text(int status);

/* "open" or "crossed", by fourlink_branch: a constant string, never null. */
FOURLINK_API const char *fourlink_branch_text(int branch);

/* "rising" or "falling", by FOURLINK_RISING and FOURLINK_FALLING, the side of an input: the same. */
FOURLINK_API const char *fourlink_input_side_text(int side);

/* The version of the library, such as "0.3.0": compare it with FOURLINK_VERSION. */
FOURLINK_API const char *fourlink_version(void);

/* ---------------------------------------------------------------------------------------------
** Status codes
** ------------------------------------------------------------------------------------------- */

/* The codes and their texts come from one list.  1 to 19 and 63 concern one crank position; others may still
** succeed.  Others from 20 mean that the call or its data are wrong. */
#define FOURLINK_STATUS_LIST(X)                                                                   \
    X(FOURLINK_OK, 0, "ok")                                                                       \
    X(FOURLINK_TOO_FAR, 1, "cannot be assembled: B and D are too far apart")                      \
    X(FOURLINK_TOO_NEAR, 2, "cannot be assembled: B and D are too close together")                \
    X(FOURLINK_ROD_TOO_SHORT, 3, "the rod does not reach the line of stroke")                     \
    X(FOURLINK_DEAD_POSITION, 4, "dead position: the motion is not determined by the crank")      \
    X(FOURLINK_CHANGE_POINT, 5, "change point: the motion can continue in two ways")              \
    X(FOURLINK_SINGULAR, 6, "the nine equations have no reliable solution here")                  \
    X(FOURLINK_LOST_IN_ROUNDING, 7, "link lengths too unequal: the position is lost in rounding") \
    X(FOURLINK_NOT_REACHED, 8, "the linkage cannot be assembled at any angle of the motion")      \
    X(FOURLINK_NO_MEAN, 9, "no mean: the column is unbounded to both sides")                      \
    X(FOURLINK_LOCKED, 10, "friction locks the mechanism")                                        \
    X(FOURLINK_NO_DIRECTION, 11, "the ends of a spring meet: its force has no direction")         \
    X(FOURLINK_DOES_NOT_START, 12, "does not start: the torque does not turn the crank")          \
    X(FOURLINK_STALLS, 13, "stalls: the crank comes to rest")                                     \
    X(FOURLINK_NO_STEADY, 14, "no steady motion: none was found that repeats and is stable")      \
    X(FOURLINK_NO_INERTIA, 15, "nothing that moves has a mass or a moment of inertia")            \
    X(FOURLINK_TOO_LONG, 16,                                                                      \
      "the motion takes too many steps: give fewer turns or less time, or parts less stiff or "   \
      "less light")                                                                               \
    X(FOURLINK_OVERFLOW, 17, "a speed or a torque grows beyond all numbers")                      \
    X(FOURLINK_LONG_SEARCH, 18,                                                                   \
      "the search takes too many rows: give fewer turns, less time or fewer columns")             \
    X(FOURLINK_GROUP_APART, 19, "an output cannot be assembled: its rod or slot does not reach")  \
    X(FOURLINK_INPUT_DEAD_CENTRE, 63,                                                             \
      "dead centre: the input or the drive stands still while the crank turns")                   \
    X(FOURLINK_NULL, 20, "a null pointer was passed")                                             \
    X(FOURLINK_BAD_NUMBER, 21, "a number is not finite or out of range")                          \
    X(FOURLINK_BAD_KIND, 22, "there is no such kind of mechanism")                                \
    X(FOURLINK_BAD_LENGTH, 23, "a length is not positive")                                        \
    X(FOURLINK_BAD_MASS, 24, "a mass or a moment of inertia is negative")                         \
    X(FOURLINK_BAD_BRANCH, 25, "the branch is neither open nor crossed")                          \
    X(FOURLINK_BAD_LINK, 26, "a load or a point is on a link that does not move")                 \
    X(FOURLINK_BAD_FRAME, 27, "the frame of a load is neither ground nor link")                   \
    X(FOURLINK_BAD_INTERVAL, 28, "the interval of the crank angle is not positive")               \
    X(FOURLINK_BAD_RANGE, 29, "the range runs against the rotation of an accelerated crank")      \
    X(FOURLINK_NO_RUN_UP, 30, "a run-up from rest needs an acceleration")                         \
    X(FOURLINK_TOO_MANY_ROWS, 31, "the range has too many rows")                                  \
    X(FOURLINK_NO_SUCH_ROW, 32, "there is no such row")                                           \
    X(FOURLINK_NOT_AN_ENGINE, 33, "the mechanism is not a slider-crank")                          \
    X(FOURLINK_NO_SERIES, 34, "the series need a line of stroke through the crankshaft")          \
    X(FOURLINK_ROD_OFF_LINE, 35, "the centre of mass of the rod is not on its line")              \
    X(FOURLINK_BAD_DECK, 36, "the deck has mistakes")                                             \
    X(FOURLINK_NO_MEMORY, 37, "not enough memory")                                                \
    X(FOURLINK_NO_SUCH_POINT, 38, "the deck has no such point")                                   \
    X(FOURLINK_TOO_MANY_LOADS, 39, "the number of loads is negative or above 100")                \
    X(FOURLINK_BAD_APPROXIMATION, 40, "the approximation is not exact, piston or all")            \
    X(FOURLINK_NO_SUCH_NAME, 41, "there is no column, fact or input of this name")                \
    X(FOURLINK_NO_SUCH_FACT, 42, "this design has no such fact")                                  \
    X(FOURLINK_NO_SUCH_ANGLE, 43, "the motion does not reach this crank angle")                   \
    X(FOURLINK_NO_TURNING_MOMENT, 44,                                                             \
      "the turning moment needs forces and a crank that turns fully, at constant speed")          \
    X(FOURLINK_NO_SUCH_LIST, 45, "there is no such list")                                         \
    X(FOURLINK_BAD_FRICTION, 46, "a coefficient, radius or length of friction is negative")       \
    X(FOURLINK_BAD_SPRING, 47,                                                                    \
      "a spring is between a link and itself, or its damping is negative")                        \
    X(FOURLINK_BAD_BALANCE, 48, "the radius of a counterweight is not positive")                  \
    X(FOURLINK_PARALLEL_SLOT, 61, "the slot of the yoke is parallel to its guide")                \
    X(FOURLINK_BAD_MOTOR, 49,                                                                     \
      "a motor has no such kind, no ratio, no power, or a curve whose speeds do not rise")        \
    X(FOURLINK_CONSTANT, 50, "the column is constant: it is not at a value at single angles")     \
    X(FOURLINK_NOT_A_NUMBER, 51, "the input is words, a list or a curve")                         \
    X(FOURLINK_DEPENDENT, 52,                                                                     \
      "no single linkage: two points are equal, or a given value follows from others")            \
    X(FOURLINK_INFINITE_LINK, 53, "no linkage: a link would have to be infinitely long")          \
    X(FOURLINK_NO_LINKAGE, 54, "no linkage: the square of a length would be negative or zero")    \
    X(FOURLINK_NO_LENGTH, 55, "no linkage: two of its pivots would be the same point")            \
    X(FOURLINK_NO_FULL_TURN, 56,                                                                  \
      "no linkage whose crank turns fully has this time ratio with these lengths")                \
    X(FOURLINK_NONE_FOUND, 57, "the search found no linkage without a defect")                    \
    X(FOURLINK_BAD_POINTS, 58, "the number of precision points is below 3 or above 100")          \
    X(FOURLINK_BAD_TIME_RATIO, 59,                                                                \
      "a time ratio is at least 1: slow stroke / quick stroke, in time")                          \
    X(FOURLINK_BAD_GROUP, 62,                                                                     \
      "an output has no such kind or side, is one too many, or hangs on a link after its own")    \
    X(FOURLINK_BAD_CHOICE, 60,                                                                    \
      "too much or too little is given, or a choice that the task does not have")

#define FOURLINK_STATUS_CODE_(name, value, text) name = value,
typedef enum fourlink_status {
    FOURLINK_STATUS_LIST(FOURLINK_STATUS_CODE_) FOURLINK_STATUS_END_ = 99
} fourlink_status;
#undef FOURLINK_STATUS_CODE_

/* The range of numbers that the library accepts.  It is far wider than any machine needs, and within it no
** result overflows.  Numbers outside it, and NaN, give FOURLINK_BAD_NUMBER.
**
** If two links are much longer than the other two, positions lose as many digits as the square of the ratio
** has.  If eight or fewer digits are left, the status is FOURLINK_LOST_IN_ROUNDING.
**
** Without the casts, a compiler for x87 keeps 1e30 with more digits than a double has. */
#define FOURLINK_LENGTH_MIN ((double)1e-15) /* m */
#define FOURLINK_LENGTH_MAX ((double)1e15)  /* m; also of distances: `cg`, `at`, `offset` */
#define FOURLINK_NUMBER_MAX ((double)1e30)  /* all other numbers, in SI units */

#include "fourlink/structures.h"
#include "fourlink/fortran77.h"

#ifdef __cplusplus
}
#endif

#endif
