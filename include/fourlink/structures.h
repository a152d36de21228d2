/* SPDX-License-Identifier: GPL-3.0-or-later
**
** structures.h - mechanisms, their motion and forces, decks and synthesis as structures: a part of
** fourlink.h, which has the conventions, and includes it.
*/
#ifndef FOURLINK_STRUCTURES_H
#define FOURLINK_STRUCTURES_H

#ifndef FOURLINK_H
#error "include fourlink.h"
#endif

/* ---------------------------------------------------------------------------------------------
** The mechanism
** ------------------------------------------------------------------------------------------- */

typedef enum fourlink_kind {
    FOURLINK_FOUR_BAR = 1,
    FOURLINK_SLIDER_CRANK = 2,
    FOURLINK_INVERTED_SLIDER_CRANK = 4,
    FOURLINK_SCOTCH_YOKE = 8
} fourlink_kind;

/* A joint of links `from` and `on`.  It has two of the nine unknowns: what `from` exerts on `on`.
**
** pin      the force F_ij, along x and y
** slider   a couple, and a normal force that acts at the joint, along the left normal of the slide
**
** The joint is at the origin of link `at`, or at its tip, the other end of its length.  A slider is at the
** origin of the sliding link, along its own x axis. */
typedef struct fourlink_joint {
    const char *letter; /* A, B, C, D: the point where it is */
    int from, on, at;   /* links */
    int is_tip;         /* 1: at the tip of link `at` */
    int slider;         /* 0: a pin; otherwise the link that slides */
} fourlink_joint;

/* The outline of a link.
**
** bar      a line from its origin to its other pin
** block    a rectangle around its origin, along its own x axis: a piston or a slider
** lever    a bar with a slot, in which another link slides
** yoke     a block with such a slot
*/
typedef enum fourlink_shape {
    FOURLINK_SHAPE_BAR = 1,
    FOURLINK_SHAPE_BLOCK,
    FOURLINK_SHAPE_LEVER,
    FOURLINK_SHAPE_YOKE
} fourlink_shape;

/* What a kind of mechanism consists of.  Arrays of links are by number; [0] is unused. */
typedef struct fourlink_kind_facts {
    fourlink_kind kind;
    const char *name;    /* as in a deck */
    const char *words;   /* in a sentence */
    const char *link[5]; /* ground, crank; coupler, rod or slider; rocker, piston, lever or yoke */
    int slides_on[5];    /* the link on which it slides; 0: it has only pins */
    int has_one_branch;  /* 1: it has one assembly mode, the open branch */
    fourlink_joint joint[4]; /* in the order of the unknowns: the last is at the origin of link 4 */
    fourlink_shape shape[5]; /* of the moving links */
    int begins[5];           /* the number of the joint at the origin of a moving link */
    int drawn[3];            /* the moving links, each in front of those before */
    int guided;              /* the link in a guide on the ground: a piston or yoke; 0: none */
    int slotted;             /* the link with a slot: a lever or yoke; 0: none */
} fourlink_kind_facts;

enum { FOURLINK_GROUND = 1, FOURLINK_CRANK = 2, FOURLINK_COUPLER = 3, FOURLINK_FOLLOWER = 4 };

typedef struct fourlink_vector {
    double x, y;
} fourlink_vector;

/* One link.  Its own axes: origin at A (crank), B (coupler, rod, slider), D (rocker, lever) or C
** (piston; yoke: where the line of its slot meets the line of its guide); x along its line towards its
** other pin (piston, yoke: parallel to the line of stroke; slider: along the slide; lever: towards C, or
** along the slide if its length is 0), y to the left of that.
*/
typedef struct fourlink_link {
    double length;      /* m; unused for piston, slider and yoke; lever: DC, or 0 */
    double mass;        /* kg; 0 for a massless link */
    double inertia;     /* kg m2, moment of inertia about the centre of mass */
    fourlink_vector cg; /* m, centre of mass in the link's own axes */
} fourlink_link;

#define FOURLINK_MOST_GROUPS 8
#define FOURLINK_LINKS (5 + 2 * FOURLINK_MOST_GROUPS)

/* What the last link of a group does. */
typedef enum fourlink_group_end {
    FOURLINK_GROUP_SLIDES = 1, /* on a fixed line */
    FOURLINK_GROUP_TURNS       /* about a pin */
} fourlink_group_end;

/* How it hangs on the link that carries it. */
typedef enum fourlink_group_hang {
    FOURLINK_HANGS_BY_ROD = 0,  /* from P of that link to Q of slider or rocker */
    FOURLINK_HANGS_BY_OWN_SLOT, /* a pin P of that link runs in a slot of slider or rocker */
    FOURLINK_HANGS_IN_SLOT /* a pin Q of slider or rocker runs in a slot of that link, through P */
} fourlink_group_hang;

/* The numbers of the links of group i, from 0, the rod and the slider or rocker; that of the last link
** of a design. */
#define FOURLINK_ROD_OF(i) (FOURLINK_FOLLOWER + 1 + 2 * (i))
#define FOURLINK_END_OF(i) (FOURLINK_FOLLOWER + 2 + 2 * (i))
#define FOURLINK_LAST_LINK(design) (FOURLINK_FOLLOWER + 2 * (design)->n_groups)

/* A group: a rod on a point P of a moving link, and a slider or a rocker on the other pin Q of the rod.
** It has no degree of freedom of its own.  In a deck it is an [output].  Group i, from 0, has the links
** 5 + 2 i, the rod, and 6 + 2 i.  Their own axes: the rod's from P to Q; the slider's from Q along
** `direction`; the rocker's from its pin D to Q.  With a slot, link 5 + 2 i is a block without mass on
** the pin, its axis that of the slot; Q of a slider with a slot is where the slot meets the line; a
** rocker's slot is along the rocker.  Set it to zero first. */
typedef struct fourlink_group {
    fourlink_group_end end;
    int link;              /* that carries it: 2, 3, 4, or one of a group before it */
    fourlink_vector at;    /* m, P in that link's own axes */
    int to;                /* rocker: the link with its pin, 0 or 1 the ground */
    fourlink_vector pivot; /* m, in the axes of that link: this pin; slider: a point of its line */
    fourlink_vector direction; /* 1, slider: unit vector along its line */
    double rod, length;        /* m, of rod and rocker */
    int side;                  /* slider: 1 ahead of P along `direction`, -1 behind; rocker: Q is to
                                  the left (1) or right (-1) of the line from P to its pin; rocker by a
                                  slot: P, or Q, is ahead (1) of the foot of its pin along the slot or
                                  behind (-1); slider by a slot: 1 */
    fourlink_link body[2];     /* masses of the rod and of slider or rocker */
    fourlink_group_hang hang;
    fourlink_vector
        slot; /* 1, unit vector along the slot: in the slider's own axes, not along its line; in
                             those of the carrying link; unused for a rocker's slot */
    double offset; /* m, rocker with a slot: the slot passes its pin at this distance on its left */
} fourlink_group;

/* The data of a mechanism.  Set it to zero first: members that stay 0 are absent. */
typedef struct fourlink_design {
    fourlink_kind kind;
    fourlink_link
        link[5]; /* by link number; [0] is unused, [1] has only a length (four-bar, inverted) */
    double
        offset; /* m, of either sign; slider-crank: the line of stroke is y = offset; Scotch yoke:
                      that of the guide; inverted: the slide passes D, or C, at this distance on its
                      left */
    fourlink_vector gravity; /* m/s2, in the frame of link 1: (0, -9.81) when x is horizontal */
    double angle; /* rad, inverted, lever with a length: angle of the slide from the line DC; Scotch
                     yoke: angle of the slot from the guide, not a multiple of pi */
    const fourlink_group *group; /* an array of n_groups, kept by the caller */
    int n_groups;                /* up to FOURLINK_MOST_GROUPS */
} fourlink_design;

/* A checked design, with the constants that every crank position needs.  fourlink_prepare fills it; the
** members may be read but not changed. */
typedef struct fourlink_mechanism {
    fourlink_design design;
    double stretched;     /* four-bar: (b + c)^2 - (a + d)^2, m2; slider-crank: l + e - r, m */
    double folded;        /* four-bar: (a - d)^2 - (b - c)^2, m2; slider-crank: l - e - r, m;
                              inverted: (a - d)^2 - h^2, m2 */
    int change_stretched; /* 1: a change point at 180 deg (slider-crank: at +90 deg) */
    int change_folded;    /* 1: a change point at 0 deg (slider-crank: at -90 deg) */
    double dead_centre;   /* m, slider-crank, Scotch yoke: distance of the inner dead centre from A,
                              along x */
    double h;             /* m, inverted: distance at which the slide passes D on its left */
    fourlink_vector lever; /* 1, inverted: axis of the lever in the slider's own axes */
    fourlink_vector slot;  /* 1, Scotch yoke: direction of the slot */
    const struct flk_drive
        *drive; /* of a deck whose drive is not the crank, for the solvers; null after
                                      fourlink_prepare */
} fourlink_mechanism;

/* ---------------------------------------------------------------------------------------------
** One crank position
** ------------------------------------------------------------------------------------------- */

/* The crank at one row: the input of every analysis. */
typedef struct fourlink_crank {
    double theta2; /* rad, from +x; not reduced by 2 pi */
    double omega2; /* rad/s */
    double alpha2; /* rad/s2 */
} fourlink_crank;

/* The motion of one link, a rigid body. */
typedef struct fourlink_link_state {
    double theta;                 /* rad, angle of the link's line from +x, in (-pi, pi]; for the
                                     crank as given */
    double omega;                 /* rad/s */
    double alpha;                 /* rad/s2 */
    double k;                     /* 1, d(theta)/d(theta2): omega for unit crank speed */
    fourlink_vector axis;         /* 1, unit vector along the link's line */
    fourlink_vector origin;       /* m, position of the link's origin */
    fourlink_vector k_origin;     /* m, d(origin)/d(theta2) */
    fourlink_vector velocity;     /* m/s, of the origin */
    fourlink_vector acceleration; /* m/s2, of the origin */
} fourlink_link_state;

/* A crank position, filled in three steps by fourlink_position, fourlink_velocity and fourlink_acceleration,
** or in one by fourlink_analyse. */
typedef struct fourlink_state {
    fourlink_branch branch;
    int last;       /* the number of the last link: 4, with groups 6, 8 ... */
    double sine;    /* 1, four-bar: sin(theta4 - theta3); slider-crank: cos(theta3); inverted:
                       s / BD; Scotch yoke: sine of the slot's angle. Positive on the open branch,
                       negative on the crossed one; beyond a change point the signs are swapped
                       (see fourlink_branch). 0 in a dead position; 1/|sine| is the condition number
                       of the position: the factor by which relative errors of the data can grow */
    double mu;      /* rad, transmission angle, 0 to pi/2 */
    double phi;     /* rad, slider-crank: obliquity of the rod, -pi/2 to pi/2 */
    double x, v, a; /* m, m/s, m/s2, slider-crank, Scotch yoke: displacement of piston or yoke from
                       its inner dead centre, positive away from it, and its derivatives */
    double slide, slide_v,
        slide_a;       /* m, m/s, m/s2, inverted: coordinate of B along the slide, from C or,
                        if the lever has no length, from the foot of the perpendicular
                        from D; its derivatives, the motion of B relative to the lever; Scotch
                        yoke: coordinate of B along the slot from C */
    double coriolis;   /* m/s2, inverted: 2 omega4 slide_v, to the left of the slide */
    double s;          /* m, inverted: coordinate of B from the foot of that perpendicular; Scotch
                        yoke: slide */
    double group_sine; /* 1, of groups: the smallest sine, as `sine`, in size; 1 without */
    fourlink_link_state
        link[FOURLINK_LINKS]; /* by link number; [0], [1] and those after the last are
                        unused */
} fourlink_state;

/* ---------------------------------------------------------------------------------------------
** Loads and forces
** ------------------------------------------------------------------------------------------- */

/* The axes in which a load's force is given. */
typedef enum fourlink_frame {
    FOURLINK_FRAME_GROUND = 0, /* the frame of link 1: the force keeps its direction */
    FOURLINK_FRAME_LINK = 1    /* the link's own axes: the force turns with the link */
} fourlink_frame;

/* A force and a torque on a moving link, in addition to its weight. */
struct fourlink_load {
    int link; /* 2, 3, 4, or one of a group */
    fourlink_frame frame;
    fourlink_vector force; /* N */
    fourlink_vector at;    /* m, the point of the link where it acts, in the link's own axes */
    double torque;         /* N m, counter-clockwise positive */
};

/* A moving link, cut free: its centre of mass G, and what acts on it besides the joints. */
typedef struct fourlink_body {
    fourlink_vector arm;          /* m, from the link's origin to G */
    fourlink_vector k;            /* m, d(G)/d(theta2): velocity of G for unit crank speed */
    fourlink_vector acceleration; /* m/s2, of G */
    fourlink_vector weight;       /* N */
    fourlink_vector force;        /* N, sum of the loads */
    double moment;                /* N m, of the loads about G */
    double work;                  /* N m, power of the loads for unit crank speed */
} fourlink_body;

/* The nine unknowns of a crank position, and the check on them. */
typedef struct fourlink_forces {
    double F12x, F12y; /* N, ground on crank, at A */
    double F23x, F23y; /* N, crank on coupler, at B */
    double F34x, F34y; /* N, coupler on link 4, at C; slider on lever, at B, including friction */
    double F14x,
        F14y; /* N, ground on link 4: at D, or the guide on piston or yoke (then F14x is its friction) */
    double M14;   /* N m, slider-crank, Scotch yoke: couple of the guide on link 4; others: 0 */
    double Ts;    /* N m, ground on crank: the driving torque; 0 if something else drives */
    double drive; /* N or N m, the effort of what drives: Ts, or that of the deck's drive */
    double
        at_crank; /* N m, the torque on the crank that has the same power: Ts, if the crank drives */
    double Ts_work;  /* N m, the same from virtual work, without the nine equations */
    double residual; /* 1, power balance for unit crank speed: at_crank - Ts_work relative to the
                          largest term of the balance, including the products of components in
                          F23.v_B and F34.v_B; 0 if every term is 0 */
    double N34; /* N, inverted, Scotch yoke: normal force of the slider on link 4, at B, to the left
                   of the slide; without friction F34 is this force */
    double M34; /* N m, inverted, Scotch yoke: couple of the slider on link 4 */
} fourlink_forces;

/* Coulomb friction.  Set it to zero first: members that stay 0 are absent. */
typedef struct fourlink_friction {
    double circle[4]; /* m, radius of the friction circles of pins A, B, C, D: coefficient times
                         radius of the pin; unused if the joint is a guide */
    double guide; /* 1, coefficient of friction of piston, slider or yoke in its guide; unused if
                         there is none */
    double guide_length; /* m, length of the block; 0: the couple of the guide causes no friction */
    int direction; /* for a crank at rest: -1, it starts clockwise; otherwise counter-clockwise */
    double slot, slot_length; /* 1, m, the same for the block of a Scotch yoke in its slot */
} fourlink_friction;

#define FOURLINK_FRICTION_LOADS 6

/* The effects of friction at one crank position. */
typedef struct fourlink_losses {
    double Ts0;        /* N m, the driving torque without friction */
    double pin[4];     /* N m, >= 0, friction moments at A, B, C, D */
    double guide;      /* N, >= 0, friction force in the guide */
    double slot;       /* N, >= 0, Scotch yoke: friction force in the slot */
    double power;      /* W, >= 0, lost */
    double efficiency; /* 1, Ts0 / Ts where the crank drives, Ts / Ts0 where it is driven; 0 where
                          friction prevents the load from driving; NaN where both are 0 */
    unsigned long n_loads; /* FOURLINK_FRICTION_LOADS */
    fourlink_load
        load[FOURLINK_FRICTION_LOADS]; /* friction as loads on the two links at B and at C, on the
                                          follower at D, on the crank at A; 0 without friction */
} fourlink_losses;

/* A spring, a damper or both, between two links or between a link and the ground.  Set it to zero first. */
typedef struct fourlink_spring {
    int link, to; /* 1 to 4, not the same */
    int is_torsional;
    fourlink_vector at, to_at; /* m, its ends in the links' own axes, on the ground in the frame of
                                  link 1; torsional: unused */
    double stiffness;          /* N/m; torsional: N m/rad */
    double free_length;        /* m; torsional: rad, theta of `link` minus theta of `to` */
    double preload;            /* N, N m: at the free length */
    double damping;            /* N s/m, N m s/rad; >= 0 */
    double turns[2];           /* rad, for open and crossed; torsional: whole turns, from
                                  fourlink_spring_prepare */
    int only; /* FOURLINK_PUSHES: a buffer, acts only below its free length or angle;
                 FOURLINK_PULLS: a rope, acts only above it; 0: always acts */
} fourlink_spring;

enum { FOURLINK_PUSHES = 1, FOURLINK_PULLS = 2 };

/* A spring at one crank position. */
typedef struct fourlink_spring_state {
    double length; /* m; torsional: rad, theta of `link` minus theta of `to`, not limited to 180
                      deg */
    double rate;   /* m/s, rad/s: derivative of the length */
    double force;  /* N, tension; torsional: N m, -force on `link`, +force on `to` */
    double energy; /* J, k s^2 / 2 + preload s, s beyond the free length */
    double power;  /* W, put into the links: -force rate */
    unsigned long n_loads;
    fourlink_load load[2];  /* on the moving links */
    fourlink_vector ground; /* N, force on the ground */
    double ground_moment;   /* N m, moment on the ground about A */
} fourlink_spring_state;

/* The mass moments that balance the shaking force.  The mass moment of a mass m at z, in the link's own axes,
** is m z. */
typedef struct fourlink_balance {
    fourlink_vector crank;  /* kg m, to be added to the crank */
    fourlink_vector rocker; /* kg m, to be added to rocker or lever; 0 for a slider-crank */
} fourlink_balance;

/* How the torque of a motor depends on its speed. */
typedef enum fourlink_motor_kind {
    FOURLINK_NO_MOTOR = 0,
    FOURLINK_MOTOR_TORQUE = 1, /* a constant torque */
    FOURLINK_MOTOR_LINEAR = 2, /* T = stall_torque (1 - w / no_load_speed), a motor with brushes */
    FOURLINK_MOTOR_CURVE = 3,  /* Steffen's interpolation; constant beyond the ends */
    FOURLINK_MOTOR_POWER = 4,  /* T = power / w, at most max_torque */
    FOURLINK_MOTOR_BALANCE = 5 /* a constant torque that balances the loads over a cycle: only in
                                  decks, where the motion sets `torque` */
} fourlink_motor_kind;

/* A motor.  Set it to zero first.  Torques and speeds are those of its own shaft, counter-clockwise positive;
** they are negative for a motor that drives clockwise. */
typedef struct fourlink_motor {
    fourlink_motor_kind kind;
    double torque;              /* N m, constant */
    double stall_torque;        /* N m */
    double no_load_speed;       /* rad/s, same sign as stall_torque */
    double power, max_torque;   /* W, > 0; N m, with the sign of the rotation */
    const double *curve_speed;  /* rad/s, increasing */
    const double *curve_torque; /* N m */
    unsigned long n_curve;      /* points of the curve, at least 2 */
    double inertia;             /* kg m2, of the rotor */
    double ratio;               /* 1, speed of the motor / speed of the crank; not 0 */
} fourlink_motor;

/* ---------------------------------------------------------------------------------------------
** The mechanism as a whole
** ------------------------------------------------------------------------------------------- */

/* The types of linkages, by the Grashof condition and the position of the shortest link. */
#define FOURLINK_TYPE_LIST(X)                                                               \
    X(FOURLINK_CRANK_ROCKER, 1, "crank-rocker")                                             \
    X(FOURLINK_ROCKER_CRANK, 2, "rocker-crank")                                             \
    X(FOURLINK_DOUBLE_CRANK, 3, "double crank (drag link)")                                 \
    X(FOURLINK_DOUBLE_ROCKER, 4, "double rocker")                                           \
    X(FOURLINK_TRIPLE_ROCKER, 5, "triple rocker (not Grashof)")                             \
    X(FOURLINK_PARALLELOGRAM, 6, "change point: parallelogram")                             \
    X(FOURLINK_DELTOID, 7, "change point: deltoid")                                         \
    X(FOURLINK_RHOMBUS, 8, "change point: rhombus")                                         \
    X(FOURLINK_CHANGE_POINT_LINKAGE, 9, "change point")                                     \
    X(FOURLINK_ENGINE, 10, "slider-crank, the crank turns fully")                           \
    X(FOURLINK_SLIDER_ROCKER, 11, "slider-crank, the crank does not turn fully")            \
    X(FOURLINK_CHANGE_POINT_SLIDER, 12, "slider-crank with change point")                   \
    X(FOURLINK_SLOTTED_LEVER, 13, "crank and slotted lever")                                \
    X(FOURLINK_WHITWORTH, 14, "Whitworth, the lever turns fully")                           \
    X(FOURLINK_INVERTED_ROCKER, 15, "inverted slider-crank, the crank does not turn fully") \
    X(FOURLINK_CHANGE_POINT_INVERTED, 16, "inverted slider-crank with change point")        \
    X(FOURLINK_YOKE, 17, "Scotch yoke")

#define FOURLINK_TYPE_CODE_(name, value, text) name = value,
typedef enum fourlink_type {
    FOURLINK_TYPE_LIST(FOURLINK_TYPE_CODE_) FOURLINK_TYPE_END_ = 99
} fourlink_type;
#undef FOURLINK_TYPE_CODE_

/* The crank angles at which the linkage can be assembled. */
typedef struct fourlink_reach {
    int n_ranges;          /* 0 (never), 1 or 2 */
    double from[2], to[2]; /* rad, from < to; 0 to 2 pi if the crank turns fully. Other ranges end
                              at dead positions */
} fourlink_reach;

/* The limits of a mechanism on one branch. */
typedef struct fourlink_limits {
    double mu_min, mu_max;         /* rad, transmission angle over all possible crank angles */
    double gamma_min, gamma_max;   /* rad, 0 to pi, angle between coupler and rocker; four-bar */
    int has_swing;                 /* 1: link 4 swings between two limits, with the crank turning */
    double theta4_min, theta4_max; /* rad, the limits of rocker or lever; the swing is max - min */
    double theta2_min, theta2_max; /* rad, 0 to 2 pi, the crank angles at these limits */
    double time_ratio;   /* 1, >= 1, of the two swings at constant crank speed; of the two strokes
                            of a piston whose line of stroke has an offset; for a lever that turns
                            fully, of the strokes of a tool whose line of stroke passes through D at
                            right angles to AD; 0: none */
    int has_stroke;      /* 1: piston or yoke moves between two dead centres */
    double stroke;       /* m */
    double inner, outer; /* rad, 0 to 2 pi, crank angles of the dead centres: the piston is farthest
                            from, and nearest to, the crankshaft; the yoke is farthest along +x, -x */
    int has_slide;       /* 1: Scotch yoke */
    double slide_min, slide_max; /* m, between which the block moves in the slot */
} fourlink_limits;

/* ---------------------------------------------------------------------------------------------
** Engines: textbook methods for a slider-crank
** ------------------------------------------------------------------------------------------- */

/* The textbook approximations for a rod much longer than the crank. */
typedef struct fourlink_series {
    double x, v, a;                            /* m, m/s, m/s2: two terms, as for state->x, v, a */
    double omega3, alpha3;                     /* rad/s, rad/s2, of the rod */
    double x_harmonic, v_harmonic, a_harmonic; /* m, m/s, m/s2: one term, an infinitely long rod */
} fourlink_series;

/* Which parts of the engine method use the series. */
typedef enum fourlink_approximation {
    FOURLINK_EXACT = 0,
    FOURLINK_SERIES_PISTON = 1, /* the acceleration of the piston */
    FOURLINK_SERIES_ALL = 2     /* and the angular acceleration of the rod */
} fourlink_approximation;

/* The rod as two masses. */
typedef struct fourlink_rod {
    double n;        /* 1, length of the rod / length of the crank */
    double k;        /* m, radius of gyration about the centre of mass */
    double b;        /* m, from the gudgeon pin to the centre of mass */
    double m_a, m_b; /* kg, at the crank pin and at the gudgeon pin: they have the rod's centre of
                        mass */
    double d;   /* m, k^2/b, from the centre of mass to m_d of the dynamically equivalent pair */
    double L;   /* m, b + d, length of the equivalent simple pendulum */
    double m_d; /* kg, at distance d; the other mass of the pair is m_g */
    double m_g; /* kg, at the gudgeon pin */
    double k1; /* m, radius of gyration of m_a and m_b, k1^2 = b (l - b); 0 if the centre of mass is
                  not between the pins */
} fourlink_rod;

/* The engine method, at one crank position.  Forces along the stroke are positive towards the crank, like
** that of the gas; torques are those delivered to the crankshaft, counter-clockwise positive. */
typedef struct fourlink_engine {
    double gas_force;         /* N, as given */
    double inertia_force;     /* N, -(m_p + m_b) a */
    double piston_effort;     /* N, gas, inertia, weight of m_p + m_b along the stroke, loads on the
                                 piston */
    double rod_force;         /* N, thrust in the rod */
    double side_thrust;       /* N, force of the guide on the piston, along +y */
    double crank_effort;      /* N, normal to the crank, counter-clockwise positive */
    double radial_force;      /* N, along the crank, positive towards the main bearing */
    double correction_couple; /* N m, m b (l - L) phi'', phi'' = -alpha3 */
    double T_piston;          /* N m, of the piston effort */
    double T_correction;      /* N m, of the correction couple */
    double T_weight_a;        /* N m, of the weight of m_a */
    double T_inertia_a;       /* N m, of the inertia of m_a; 0 at constant speed */
    double T_engine;          /* N m, sum of these four; with a massless crank, -Ts */
    double correction_force;  /* N, along +y: the force at the crank pin of the pair that makes the
                                 correction couple */
    double T_weight_b;        /* N m, of the weight of m_b; part of T_piston */
} fourlink_engine;

/* Klein's construction: lengths in the drawing.  O is the crankshaft, B the crank pin.  M is where the line
** of the rod cuts the perpendicular to the line of stroke through O; N, on the parallel to the line of stroke
** through O, and Q, on the rod, are on the common chord of the circle about B with radius BM and the circle
** on the rod as diameter.
**
** I is the instantaneous centre of the rod.  X and Y are the feet of the perpendiculars from I to the lines
** of action of the rod's weight and of its inertia force. */
typedef struct fourlink_klein {
    double OM; /* m, v = omega2 OM; same sign as v for omega2 > 0 */
    double BM; /* m, omega3 = omega2 BM / l; same sign as omega3 for omega2 > 0 */
    double BQ; /* m, centripetal acceleration of the piston about B: omega2^2 BQ, towards B */
    double QN; /* m, alpha3 = omega2^2 QN / l; same sign as alpha3 */
    double ON; /* m, a = omega2^2 ON for alpha2 = 0; same sign as a */
    double IX; /* m, arm of the rod's weight, positive where it turns the crank counter-clockwise */
    double IY; /* m, arm of the rod's inertia force, positive where it turns the crank clockwise; IX
                  and IY are NaN without that force, and if I is at infinity */
    double FT; /* N, the force that drives the rod alone, at the crank pin and at right angles to
                  the crank, counter-clockwise positive: IB FT = IY m omega2^2 gO - IX m g for
                  alpha2 = 0 */
} fourlink_klein;

/* ---------------------------------------------------------------------------------------------
** The motion of the crank
** ------------------------------------------------------------------------------------------- */

/* The crank positions to compute.  Angles are in the caller's unit, so that 40 deg is exactly 40 from input
** to table. */
typedef struct fourlink_motion {
    double angle_unit; /* rad, the unit of the four angles below: 1 for radians, pi/180 for deg */
    double from, to;   /* first and last crank angle; if to < from, the range runs clockwise */
    double interval;   /* > 0; the last row is at `to` even if that is not a multiple of it */
    double run_up;     /* > 0: start from rest at `from` with `acceleration` over this angle;
                          `speed` is not used. 0 or less: no run-up */
    double speed;      /* rad/s, at the first row */
    double
        acceleration; /* rad/s2, constant over the range: omega2^2 = speed^2 + 2 acceleration s */
    int hold;         /* 1: every row has this speed and acceleration */
    double x_at; /* rad, the crank angle at which the crank is along x of link 1, where theta2 is
                         0; another than 0 if angles are from the horizontal of a page */
} fourlink_motion;

/* The rows of a motion. */
typedef struct fourlink_range {
    unsigned long n_rows; /* at least 1 */
    int stops;            /* 1: the crank comes to rest before `to`, and the rows end there */
    double stop_angle;    /* the crank angle there, in the motion's unit; else 0 */
} fourlink_range;

/* One row of a motion. */
typedef struct fourlink_row {
    fourlink_crank crank;
    double angle; /* crank angle in the motion's unit */
    double place; /* what rows go over: the angle or, of rows by time, the time, s */
    double time;  /* s, since the first row; 0 if it is not defined (see fourlink_motion_row) */
    int side;     /* FOURLINK_RISING, FOURLINK_FALLING, of an input; 0 of the crank */
} fourlink_row;

/* ---------------------------------------------------------------------------------------------
** Decks
** ------------------------------------------------------------------------------------------- */

/* A unit of a deck: value * up / down is the value in SI units and radians. */
typedef struct fourlink_unit {
    const char *name; /* valid as long as the deck */
    double up, down;
    int is_given; /* 1: by [units] or `units` of fourlink_source, and not by that of length alone */
} fourlink_unit;

/* The source of a load. */
enum {
    FOURLINK_LOAD_OWN = 1,      /* a [load] */
    FOURLINK_LOAD_SPRING = 2,   /* a spring or damper: one load for each end on a moving link */
    FOURLINK_LOAD_FRICTION = 3, /* FOURLINK_FRICTION_LOADS of them, as in fourlink_losses */
    FOURLINK_LOAD_GAS = 4,      /* one on the piston; or one on the rod, one on the cylinder */
    FOURLINK_LOAD_DRIVE = 5 /* what drives, if not a torque on the crank: see fourlink_deck_drive */
};

typedef struct fourlink_load_info {
    const char *name; /* of its section; "load" if that has no name; "friction", "gas", "drive" */
    int sort;         /* FOURLINK_LOAD_OWN ... */
    unsigned long element; /* its number among those of its sort, from 0; for friction the joint: 0
                              to 3 for A, B, C, D */
    int link;              /* on which it acts */
    int has_torque;        /* 1: it has a torque at some crank angle */
} fourlink_load_info;

/* How the motion of the crank is determined. */
enum {
    FOURLINK_MODE_GIVEN = 0,  /* the motion is given */
    FOURLINK_MODE_FREE = 1,   /* it follows from torques and inertia, from a given speed */
    FOURLINK_MODE_RUN_UP = 2, /* the same, from rest */
    FOURLINK_MODE_STEADY = 3  /* the motion that repeats after a cycle */
};

/* What the rows of a deck go over, from the first to the last: the crank angle or time. */
typedef struct fourlink_abscissa {
    const char *name;         /* of its column: theta2, time */
    const char *symbol;       /* of it, in UTF-8: theta with subscript 2, t */
    const char *quantity;     /* of its unit: angle, time */
    const char *rows;         /* as [motion] rows has it: angle, time */
    const char *words;        /* in a sentence: the crank angle, time */
    const char *step_key;     /* of [motion]: interval, time_step */
    int is_crank_angle;       /* 1: a crank angle has one row; 0: it can have many, or none */
    const char *unit;         /* of its places: the deck's unit of angle, s */
    double first, step, last; /* places */
} fourlink_abscissa;

typedef struct fourlink_problem {
    char title[256]; /* null-terminated; cut off if longer */
    fourlink_mechanism mechanism;
    fourlink_motion motion;               /* the rows of the deck; one row for one instant */
    double cycle;                         /* rad, the period of curves and of the turning moment */
    int open, crossed;                    /* 1: this branch is requested */
    int asks_for_both;                    /* 1: branch = both is given; 0: one, or none */
    int has_forces;                       /* 1: there are masses, loads or gas */
    int has_friction, has_gas;            /* 1: there is friction, gas */
    fourlink_approximation approximation; /* for fourlink_engine_method */
    unsigned long n_loads;                /* for fourlink_deck_loads and fourlink_deck_load */
    unsigned long n_springs;              /* for fourlink_deck_spring */
    unsigned long n_points;               /* for fourlink_deck_point */
    double flywheel_fluctuation;          /* 1; 0 if not given */
    double flywheel_inertia;              /* kg m2; 0 if not given */
    unsigned long n_rows;                 /* of the motion */
    int one_instant;                      /* 1: the deck asks for one crank angle */
    int one_revolution;       /* 1: the crank turns once from the first row to the last */
    int digits;               /* significant digits in the deck's tables */
    unsigned long n_expected; /* values of [expect] and [misprint] */
    unsigned long n_designs;  /* of its [sweep]; 0: the deck has none */
    unsigned long design;     /* number of this design, from 0 */
    int has_outputs;          /* 1: the [sweep] names outputs: one line for each design */
    int has_values;           /* 1: the columns are values of the deck, which are its outputs */
    int is_graded;            /* 1: [grading] has tolerances for all values */
    int shows_answers;        /* 1: it has feedback = answers */
    int is_half_for_hint;     /* 1: it has hint = half */
    char task[1000];          /* its text, the words of the exercise; "": none; cut off if longer */
    double late;              /* its deduction for a day late: 0.1 for 10 % */
    int mode; /* FOURLINK_MODE_GIVEN ...; for the other modes only the angles of `motion`
                         are valid: speed, acceleration and time come from fourlink_results_row */
    fourlink_abscissa over; /* what its rows go over */
    int has_both_sides; /* 1: side = both, of an input: the first half of the rows is on its rising side */
    int is_prescribed; /* 1: another coordinate than the crank angle is prescribed, over which they go; */
    fourlink_motion
        prescribed;    /* its motion, in rad or m, and `motion` is the crank's only at `from` */
    int axes_on_page;  /* 1: results by name are in the axes of a page, structures never; */
    fourlink_vector A; /* m, the place of A there */
    double x_angle;    /* rad, and the direction of x of link 1; else 0 */
    int has_drawn;     /* 1: the deck has [pins] */
    double drawn;      /* the crank angle as drawn, in the deck's unit */
    int drawn_branch;  /* FOURLINK_OPEN, FOURLINK_CROSSED; 0: the drawing does not tell it */
    fourlink_vector drawn_A; /* m, the place of A on the page of [pins], whatever the axes are */
    double drawn_x;          /* rad, and the direction of x of link 1 there; else 0 */
} fourlink_problem;

/* All results at one crank angle. */
struct fourlink_instant {
    fourlink_row row;
    fourlink_branch branch;
    int status; /* not FOURLINK_OK: why there is no position; the members below are not filled */
    fourlink_forces forces; /* 0 if the deck has no forces */
    double gas_force;       /* N, of the gas, as from fourlink_deck_loads */
    fourlink_losses losses; /* without friction Ts0 is Ts, the efficiency 1, the rest 0 */
    fourlink_state state;
};

/* An area between the turning moment and its mean. */
typedef struct fourlink_area {
    double from, to; /* rad, from < to for either direction of rotation */
    double energy;   /* J, energy that the flywheel takes up over this area */
} fourlink_area;

#define FOURLINK_AREAS 40

/* The turning moment -Ts over one cycle at the deck's speed, and the flywheel. */
struct fourlink_turning {
    double mean_torque;        /* N m */
    double mean_power;         /* W */
    double energy_fluctuation; /* J, largest minus smallest energy of the flywheel over a cycle */
    int has_coefficient;       /* 0: the mean is 0 */
    double energy_coefficient; /* 1, energy_fluctuation / work of a cycle */
    double inertia; /* kg m2, of the flywheel, without the motor's rotor; 0: none is needed, or the
                       deck gives neither the inertia nor the fluctuation */
    double fluctuation; /* 1, coefficient of fluctuation of speed, including the rotor */
    int n_areas;        /* in one cycle from 0; at most FOURLINK_AREAS are kept */
    fourlink_area area[FOURLINK_AREAS];
};

/* A part of the program of a motion, between two of its points.  With u = (time - begin) / (end - begin)
** and the shape s(u) of its law, which goes from 0 to 1, the coordinate of the program, or its speed, is
** value + rise s(u); of a spline, with T = end - begin,
**
**    value + rise u + T^2 / 6 [bend[0] ((1 - u)^3 - (1 - u)) + bend[1] (u^3 - u)] */
typedef struct fourlink_program_part {
    const char *law;    /* as a deck has it */
    double begin, end;  /* s */
    double value, rise; /* rad or m; where the points are speeds, by s */
    double coordinate;  /* rad or m, at its beginning */
    double bend[2];     /* of a spline: second derivatives at its ends */
    double ramp
        [2]; /* of a trapezoid: u where its speed has risen, and 1 - u where it begins to fall */
    int is_angle;    /* 1: rad; 0: m */
    int is_of_speed; /* 1: the points are speeds */
} fourlink_program_part;

/* ---------------------------------------------------------------------------------------------
** Functions
** ------------------------------------------------------------------------------------------- */

/* The words for a kind of mechanism, and for its links, by number: "four-bar linkage", "slider-crank",
** "inverted slider-crank"; "ground", "crank", "coupler", "rod" or "slider", "rocker", "piston" or "lever".
** Constant strings in English, never null. */
FOURLINK_API const char *fourlink_kind_text(int kind);
FOURLINK_API const char *fourlink_link_text(int kind, int link);

/* The link on which a link slides: FOURLINK_GROUND (1) for the piston, FOURLINK_FOLLOWER (4) for the
** slider; 0 for a link that has only pins.  A link slides along its own x axis, with the slider at
** its origin. */
FOURLINK_API int fourlink_slides(int kind, int link);

/* The parts of a kind of mechanism: its words, its joints, which links slide on which.
**
** Given:
**    kind       FOURLINK_FOUR_BAR ...
** Returned:
**    facts      its texts are constant strings in English
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_KIND
*/
FOURLINK_API int fourlink_kind_of(int kind, fourlink_kind_facts *facts);

/* Check a design and prepare it for the functions below.
**
** Given:
**    design     the mechanism: lengths > 0 (unused for the piston), masses and moments of inertia
**               >= 0
** Returned:
**    mechanism  the checked design, with the constants of every position
** Returned (function value):
**    FOURLINK_OK, FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_KIND, FOURLINK_BAD_LENGTH,
**    FOURLINK_BAD_MASS, FOURLINK_BAD_GROUP
** Notes:
** 1) A design that cannot be assembled at some or all angles is accepted; the status of each position reports
**    it.
** 2) `group` of the design is not copied: it must stay as long as the mechanism is used.
** Reference:
**    The triangle BCD, law of cosines: it exists where |b - c| <= BD <= b + c.
*/
FOURLINK_API int fourlink_prepare(const fourlink_design *design, fourlink_mechanism *mechanism);

/* The type of a linkage, and its name: a constant string in English, never null.
**
** Given:
**    mechanism  from fourlink_prepare
** Returned:
**    type       by the Grashof condition: s + l < p + q, s the shortest, l the longest link
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
** Reference:
**    Grashof's condition.
*/
FOURLINK_API int fourlink_type_of(const fourlink_mechanism *mechanism, fourlink_type *type);
FOURLINK_API const char *fourlink_type_text(int type);

/* 1 if mechanisms of this kind can have this type. */
FOURLINK_API int fourlink_has_type(int kind, int type);

/* The crank angles at which the linkage can be assembled, in closed form.
**
** Given:
**    mechanism  from fourlink_prepare
** Returned:
**    reach      up to two ranges; the same for both branches
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
** Reference:
**    a^2 + d^2 - 2 a d cos(theta2) = (b + c)^2 and (b - c)^2; l = |r sin(theta2) - e|.
*/
FOURLINK_API int fourlink_reach_of(const fourlink_mechanism *mechanism, fourlink_reach *reach);

/* The limits of a mechanism, in closed form.
**
** Given:
**    mechanism  from fourlink_prepare
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
** Returned:
**    limits     members that has_swing and has_stroke exclude are 0
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_BRANCH
** Notes:
** 1) The rocker of a crank-rocker has limits where crank and coupler are in line.  A mechanism with
**    a change point has neither limits nor dead centres.
** 2) time_ratio is the larger crank angle between the limits, or dead centres, divided by the smaller one.
** Reference:
**    The triangles ACD with AC = b - a and a + b, law of cosines; dead centres where crank and rod
**    are in line.
*/
FOURLINK_API int fourlink_limits_of(const fourlink_mechanism *mechanism, fourlink_branch branch,
                                    fourlink_limits *limits);

/* Position of all links at one crank angle.
**
** Given:
**    mechanism  from fourlink_prepare
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
**    theta2     rad, crank angle
** Returned:
**    state      theta, axis and origin of each link; sine, mu; slider-crank: phi, x
** Returned (function value):
**    FOURLINK_OK, FOURLINK_TOO_FAR, FOURLINK_TOO_NEAR, FOURLINK_ROD_TOO_SHORT,
**    FOURLINK_DEAD_POSITION, FOURLINK_CHANGE_POINT, FOURLINK_LOST_IN_ROUNDING, FOURLINK_GROUP_APART;
**    FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_BRANCH, FOURLINK_BAD_KIND
** Notes:
** 1) A position counts as dead if sine^2 <= 1e-14, the level of rounding error.
** 2) The members that the next two functions fill are not valid yet.
** 3) Here and in the functions below, FOURLINK_BAD_KIND means that the mechanism was not prepared.
** Reference:
**    Alvi, eqs. 1 to 3, by circles instead of Freudenstein's equation (the source file four_bar.c);
**    ME3491, and DFA eq. 1 (slider_crank.c).
*/
FOURLINK_API int fourlink_position(const fourlink_mechanism *mechanism, fourlink_branch branch,
                                   double theta2, fourlink_state *state);

/* Velocity of all links.
**
** Given:
**    mechanism  from fourlink_prepare
**    omega2     rad/s, crank speed; may be negative or 0
** Given and returned:
**    state      from fourlink_position; receives omega, k, k_origin, velocity of each link;
**               slider-crank: v
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER
** Reference:
**    Alvi, eqs. 4.1 and 4.2.
*/
FOURLINK_API int fourlink_velocity(const fourlink_mechanism *mechanism, double omega2,
                                   fourlink_state *state);

/* Acceleration of all links.
**
** Given:
**    mechanism  from fourlink_prepare
**    alpha2     rad/s2, acceleration of the crank
** Given and returned:
**    state      from fourlink_velocity; receives alpha and acceleration of each link;
**               slider-crank: a
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER
** Reference:
**    Alvi, section 3.3.
*/
FOURLINK_API int fourlink_acceleration(const fourlink_mechanism *mechanism, double alpha2,
                                       fourlink_state *state);

/* Position, velocity and acceleration of a point of a link.
**
** Given:
**    state         from fourlink_acceleration
**    link          2 to the last
**    at            m, the point in the link's own axes
** Returned (each may be null):
**    position      m, in the frame of link 1
**    velocity      m/s
**    acceleration  m/s2
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_LINK
*/
FOURLINK_API int fourlink_point(const fourlink_state *state, int link, const fourlink_vector *at,
                                fourlink_vector *position, fourlink_vector *velocity,
                                fourlink_vector *acceleration);

/* The moving links as bodies, each cut free of the others: what Newton's and Euler's equations have besides
** the unknown forces of the joints, and the terms of virtual work.
**
** Given:
**    mechanism  from fourlink_prepare
**    state      from fourlink_acceleration
**    loads      forces and torques in addition to the weights; may be null if n_loads is 0
**    n_loads    how many
** Returned:
**    body       by link number, 2 to the last; the others stay as they are
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_KIND, FOURLINK_BAD_NUMBER, FOURLINK_BAD_LINK,
**    FOURLINK_BAD_FRAME
** Note:
**    With the mass m and the moment of inertia I of a link, the right-hand sides of its equations are
**    m a_G - weight - force and I alpha - moment; its power for unit crank speed is
**    weight.k - m a_G.k - I alpha k_link + work.
** Reference:
**    ME3491, eqs. 1 to 11; see free_body.h.
*/
FOURLINK_API int fourlink_bodies(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                 const fourlink_load *loads, unsigned long n_loads,
                                 fourlink_body body[FOURLINK_LINKS]);

/* Pin forces and driving torque: solves the nine Newton-Euler equations of a crank position.
**
** Given:
**    mechanism  from fourlink_prepare
**    state      from fourlink_acceleration
**    loads      forces and torques in addition to the weights; may be null if n_loads is 0
**    n_loads    how many
** Returned:
**    forces     F12 ... F14, Ts, residual
** Returned (function value):
**    FOURLINK_OK, FOURLINK_SINGULAR; FOURLINK_NULL, FOURLINK_BAD_NUMBER,
**    FOURLINK_BAD_LINK, FOURLINK_BAD_FRAME
** Notes:
** 1) The system is solved by GSL's LU decomposition for banded matrices, which allocates nothing.
** 2) `residual` is normally near 1e-15, and grows with the condition number 1/|sine|.
** 3) A state that the functions above did not fill gives meaningless forces, or FOURLINK_BAD_NUMBER or
**    FOURLINK_SINGULAR if it contains NaN or infinity.
** Reference:
**    ME3491, eqs. 3 to 15, corrected; see nine_equations.c.
*/
FOURLINK_API int fourlink_solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                const fourlink_load *loads, unsigned long n_loads,
                                fourlink_forces *forces);

/* The same forces in closed form, from the nine equations solved by hand.
**
** Given:
**    mechanism, state, loads, n_loads  as for fourlink_solve
** Returned:
**    forces     as from fourlink_solve, to rounding
** Returned (function value):
**    as from fourlink_solve
** Notes:
** 1) Links 3 and 4 are a dyad: their forces follow from two equations, and those of the crank from them.
**    This takes a fraction of the time of fourlink_solve; each solution checks the other.
** 2) FOURLINK_SINGULAR follows from the state's `sine`.
** Reference:
**    The equations are those of fourlink_solve; see closed_form.c.
*/
FOURLINK_API int fourlink_solve_dyad(const fourlink_mechanism *mechanism,
                                     const fourlink_state *state, const fourlink_load *loads,
                                     unsigned long n_loads, fourlink_forces *forces);

/* The same forces with Coulomb friction in pins and guides, which depends on the forces.
**
** Given:
**    mechanism, state, loads, n_loads  as for fourlink_solve
**    friction     of the joints
**    closed_form  1: as fourlink_solve_dyad, 0: as fourlink_solve
** Returned:
**    forces       as from fourlink_solve with losses->load as additional loads; slider-crank: F14x is the
**                 friction of the guide; inverted: F34 is N34 plus the friction of the guide
**    losses       friction and power lost
** Returned (function value):
**    as from fourlink_solve; FOURLINK_LOCKED: no torque moves the mechanism; FOURLINK_BAD_FRICTION
** Notes:
** 1) The signs follow from the relative speeds; for a crank at rest, from those at unit speed in
**    friction->direction.  A joint that is at rest while the crank turns has no friction: dead centres of a
**    piston, limits of a rocker.
** 2) Friction is found by Newton's method, which starts without friction and takes three to five steps.
**    FOURLINK_LOCKED means that the frictionless solution has no continuation as friction grows to its full
**    size.
** 3) `residual` is the power balance including the lost power.
** Reference:
**    R. S. Khurmi, J. K. Gupta, "Theory of Machines", chapter 10, friction circle; see friction.c.
*/
FOURLINK_API int fourlink_solve_friction(const fourlink_mechanism *mechanism,
                                         const fourlink_state *state, const fourlink_load *loads,
                                         unsigned long n_loads, const fourlink_friction *friction,
                                         int closed_form, fourlink_forces *forces,
                                         fourlink_losses *losses);

/* Check a spring and find its turns.  A torsional spring counts turns from the first crank angle >= 0 that
** can be reached, where its angle is within 180 deg of the free angle.
**
** Given:
**    mechanism  from fourlink_prepare
** Given and returned:
**    spring     receives `turns`
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_LINK, FOURLINK_BAD_SPRING,
**    FOURLINK_BAD_KIND
*/
FOURLINK_API int fourlink_spring_prepare(const fourlink_mechanism *mechanism,
                                         fourlink_spring *spring);

/* A spring at a crank position, and its loads on the links.
**
** Given:
**    mechanism  from fourlink_prepare
**    state      from fourlink_velocity
**    spring     from fourlink_spring_prepare
** Returned:
**    at         length, force, loads; with P on `link` and Q on `to`, T = preload + k (L - L0) + c dL/dt
**               pulls P towards Q
** Returned (function value):
**    FOURLINK_OK, FOURLINK_NO_DIRECTION; FOURLINK_NULL, FOURLINK_BAD_KIND
** Note:
**    A spring whose preload, free length and damping are 0 needs no direction.
*/
FOURLINK_API int fourlink_spring_at(const fourlink_mechanism *mechanism,
                                    const fourlink_state *state, const fourlink_spring *spring,
                                    fourlink_spring_state *at);

/* The mass moments of counterweights that balance the shaking force.
**
** Given:
**    mechanism  from fourlink_prepare
**    fraction   1, fraction of the reciprocating mass of a slider-crank that the crank balances; otherwise
**               unused
** Returned:
**    balance    for a four-bar or an inverted slider-crank these make the shaking force of inertia 0 in any
**               motion
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_KIND
** Reference:
**    R. S. Berkof, G. G. Lowen, "A New Method for Completely Force Balancing Simple Linkages",
**    J. Eng. Ind. 91 (1969); see balance.c.
*/
FOURLINK_API int fourlink_balance_of(const fourlink_mechanism *mechanism, double fraction,
                                     fourlink_balance *balance);

/* Make a link a uniform slender bar between its two pins.
**
** Given:
**    length     m, > 0
**    mass       kg, >= 0
** Returned:
**    link       its length, mass, centre of mass at mid-length, moment of inertia m L^2 / 12
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_LENGTH, FOURLINK_BAD_MASS
*/
FOURLINK_API int fourlink_uniform_bar(double length, double mass, fourlink_link *link);

/* Add a counterweight to a link.
**
** Given:
**    link       the link
**    moment     kg m, of the counterweight in the link's own axes
**    radius     m, > 0, distance of the counterweight from the link's origin
** Returned:
**    balanced   the link with the counterweight: mass, centre of mass, moment of inertia; may be `link`
**    mass       kg, of the counterweight, a point mass; may be null
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_BALANCE
*/
FOURLINK_API int fourlink_add_counterweight(const fourlink_link *link,
                                            const fourlink_vector *moment, double radius,
                                            fourlink_link *balanced, double *mass);

/* The generalised inertia J of the moving links: their kinetic energy is J omega2^2 / 2.
**
** Given:
**    mechanism  from fourlink_prepare
**    state      from fourlink_position
** Returned:
**    J          kg m2
**    slope      kg m2, dJ/dtheta2; may be null
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_KIND
** Note:
**    Without loads and weights, the torque on the crank that moves the links is
**    J alpha2 + slope omega2^2 / 2.
** Reference:
**    Lagrange's equation for one coordinate; see inertia.c.
*/
FOURLINK_API int fourlink_inertia(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                  double *J, double *slope);

/* The generalised force of loads and weights on the crank: their power at unit crank speed.
**
** Given:
**    mechanism  from fourlink_prepare
**    state      from fourlink_velocity
**    loads      as for fourlink_solve
**    n_loads    how many
** Returned:
**    Q          N m, counter-clockwise positive
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_KIND, FOURLINK_BAD_LINK, FOURLINK_BAD_FRAME,
**    FOURLINK_BAD_NUMBER
*/
FOURLINK_API int fourlink_generalised_force(const fourlink_mechanism *mechanism,
                                            const fourlink_state *state, const fourlink_load *loads,
                                            unsigned long n_loads, double *Q);

/* The torque of a motor on the crank.
**
** Given:
**    motor      a motor
**    omega2     rad/s, of the crank
** Returned:
**    torque     N m, at the crank: the torque of the motor's shaft times the ratio
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_MOTOR
*/
FOURLINK_API int fourlink_motor_torque(const fourlink_motor *motor, double omega2, double *torque);

/* The nine equations themselves, A x = b.
**
** Given:
**    mechanism, state, loads, n_loads  as for fourlink_solve
** Returned:
**    A          9 x 9, row by row; moments about the centres of mass
**    b          9, forces in N, moments in N m
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_LINK,
**    FOURLINK_BAD_FRAME
** Note:
**    x = (F12x F12y F23x F23y F34x F34y F14x F14y Ts); for a slider-crank (... F34y M14 N Ts),
**    for an inverted one (... F23y M34 N34 F14x F14y Ts),
**    where N is the force of the guide on the piston along +y.
**
**    Of a deck whose drive is not the crank the ninth is the effort of what drives, in place of Ts.
** Reference:
**    ME3491, eq. 15 and the matrix below it, corrected.
*/
FOURLINK_API int fourlink_system(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                 const fourlink_load *loads, unsigned long n_loads, double A[9][9],
                                 double b[9]);

/* The names of the nine unknowns, i = 0 to 8: "F12x" to "F34y", "F14x" and "F14y", or "M14" and "N"
** (an inverted slider-crank has "M34" and "N34" for "F34x" and "F34y"),
** and "Ts".  A constant string, never null. */
FOURLINK_API const char *fourlink_unknown_text(int kind, int i);

/* The six equations of a group, A x = b.  They stand alone: what the group does to the links that carry it
** is in b of fourlink_system, and what a group on its links does to it is in its own.
**
** Given:
**    mechanism, state, loads, n_loads  as for fourlink_solve
**    group      its number, from 0
** Returned:
**    A          6 x 6, row by row: of the rod or block, then of slider or rocker, the forces along x and
**               along y, and the moments about the link's origin
**    b, x       6, right-hand side and solution; forces in N, moments in N m
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_KIND, FOURLINK_BAD_GROUP, FOURLINK_SINGULAR,
**    FOURLINK_BAD_NUMBER, FOURLINK_BAD_LINK, FOURLINK_BAD_FRAME
** Note:
**    x = (FPx FPy FQx FQy FDx FDy); of a slider (... N M), the guide's.  The force of a slot, FP in a slot
**    of the carrying link and FQ in one of the group, is (S C): S along the slot's normal, to the left of
**    the block's axis, and the couple C, which is 0.  Where something drives on a group, its
**    fourlink_drive_loads are to be among the loads.
*/
FOURLINK_API int fourlink_group_system(const fourlink_mechanism *mechanism,
                                       const fourlink_state *state, const fourlink_load *loads,
                                       unsigned long n_loads, int group, double A[6][6],
                                       double b[6], double x[6]);

/* The names of these unknowns, i = 0 to 5: "FPx" ... A constant string, never null. */
FOURLINK_API const char *fourlink_group_unknown_text(const fourlink_group *group, int i);

/* The nine unknowns from the forces: the solution x of fourlink_system.
**
** Given:
**    mechanism  from fourlink_prepare
**    forces     of one of its positions
** Returned:
**    x          9, forces in N, moments in N m
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_KIND
*/
FOURLINK_API int fourlink_unknowns(const fourlink_mechanism *mechanism,
                                   const fourlink_forces *forces, double x[9]);

/* The analysis of one crank position in one call: position, velocity, acceleration, forces.
**
** Given:
**    mechanism       from fourlink_prepare
**    branch          FOURLINK_OPEN or FOURLINK_CROSSED
**    crank           crank angle, speed and acceleration
**    loads, n_loads  as for fourlink_solve
** Returned:
**    state           the motion of every link
**    forces          pin forces and driving torque; if null, they are not computed and the loads are ignored
** Returned (function value):
**    as for fourlink_position, fourlink_velocity, fourlink_acceleration and fourlink_solve
** Reference:
**    as for these functions
*/
FOURLINK_API int fourlink_analyse(const fourlink_mechanism *mechanism, fourlink_branch branch,
                                  const fourlink_crank *crank, const fourlink_load *loads,
                                  unsigned long n_loads, fourlink_state *state,
                                  fourlink_forces *forces);

/* The same, with forces from fourlink_solve_dyad: for many crank positions, as in a search.
**
** Given and returned:
**    all             as for fourlink_analyse
** Returned (function value):
**    as for fourlink_analyse, except FOURLINK_SINGULAR: every position found has forces
*/
FOURLINK_API int fourlink_analyse_dyad(const fourlink_mechanism *mechanism, fourlink_branch branch,
                                       const fourlink_crank *crank, const fourlink_load *loads,
                                       unsigned long n_loads, fourlink_state *state,
                                       fourlink_forces *forces);

/* fourlink_analyse directly from the design: for one crank position, or a few.
**
** Given:
**    design          as for fourlink_prepare
**    others          as for fourlink_analyse
** Returned:
**    state, forces   as from fourlink_analyse
** Returned (function value):
**    as for fourlink_prepare and fourlink_analyse
*/
FOURLINK_API int fourlink_analyse_design(const fourlink_design *design, fourlink_branch branch,
                                         const fourlink_crank *crank, const fourlink_load *loads,
                                         unsigned long n_loads, fourlink_state *state,
                                         fourlink_forces *forces);

/* The textbook series for a slider-crank.
**
** Given:
**    mechanism  from fourlink_prepare, a slider-crank without offset
**    state      from fourlink_acceleration: the crank's theta, omega and alpha are used
** Returned:
**    series     two-term and one-term approximations
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NOT_AN_ENGINE, FOURLINK_NO_SERIES
** Reference:
**    DFA, eqs. 1 to 4; ME3491, "Dynamic analysis of Slider Crank Mechanism".
*/
FOURLINK_API int fourlink_textbook_series(const fourlink_mechanism *mechanism,
                                          const fourlink_state *state, fourlink_series *series);

/* The rod of a slider-crank as two masses.
**
** Given:
**    mechanism  from fourlink_prepare, a slider-crank
** Returned:
**    rod        both pairs of masses; d, L, m_d, m_g are 0 for a rod whose centre of mass is at the
**               gudgeon pin (b = 0)
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NOT_AN_ENGINE, FOURLINK_ROD_OFF_LINE
** Reference:
**    ME3491, "Dynamically equivalent system"; DFA, the same.
*/
FOURLINK_API int fourlink_rod_masses(const fourlink_mechanism *mechanism, fourlink_rod *rod);

/* The engine method.
**
** Given:
**    mechanism      from fourlink_prepare, a slider-crank
**    state          from fourlink_acceleration
**    gas_force      N, on the piston, towards the crank positive
**    loads          as for fourlink_solve, without the gas; those on crank and rod are outside this
**                   method and are ignored
**    n_loads        how many
**    approximation  what the series are used for
** Returned:
**    engine         the forces and torques
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_LINK, FOURLINK_BAD_FRAME,
**    FOURLINK_NOT_AN_ENGINE, FOURLINK_ROD_OFF_LINE, FOURLINK_NO_SERIES,
**    FOURLINK_BAD_APPROXIMATION
** Note:
**    With FOURLINK_EXACT, T_engine equals -Ts of the nine equations to rounding if the crank has no mass and
**    loads act on the piston alone.  This holds with offset, inclination and crank acceleration, and on both
**    branches.
** Reference:
**    DFA, examples 1 and 2; ME3491, examples 1 and 2; see engine.c.
*/
FOURLINK_API int fourlink_engine_method(const fourlink_mechanism *mechanism,
                                        const fourlink_state *state, double gas_force,
                                        const fourlink_load *loads, unsigned long n_loads,
                                        fourlink_approximation approximation,
                                        fourlink_engine *engine);

/* Klein's construction.
**
** Given:
**    mechanism  from fourlink_prepare, a slider-crank
**    state      from fourlink_position; for FT from fourlink_velocity
** Returned:
**    klein      the lengths of the drawing, and FT
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NOT_AN_ENGINE
** Reference:
**    ME3491, example 2, "Graphical method".
*/
FOURLINK_API int fourlink_klein_construction(const fourlink_mechanism *mechanism,
                                             const fourlink_state *state, fourlink_klein *klein);

/* The rows of a motion.
**
** Given:
**    motion     the range, or the run-up and one revolution after it
** Returned:
**    range      the number of rows, and whether the crank comes to rest before the last angle
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_INTERVAL, FOURLINK_BAD_RANGE,
**    FOURLINK_NO_RUN_UP, FOURLINK_TOO_MANY_ROWS
** Note:
**    Rows are at from, from + interval, ... and at the last angle, which is `to`; with a run-up it
**    is one revolution after its end, in the direction of the acceleration.
*/
FOURLINK_API int fourlink_motion_range(const fourlink_motion *motion, fourlink_range *range);

/* The crank at one row of a motion, computed from the row number, so that rounding does not accumulate.
**
** Given:
**    motion     as above
**    range      from fourlink_motion_range
**    i          0 ... range->n_rows - 1
** Returned:
**    row        crank angle, speed, acceleration; time since the first row
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_NO_RUN_UP, FOURLINK_NO_SUCH_ROW
** Note:
**    The time is negative in a range that runs against the rotation.  It is undefined, and set to 0, for a
**    crank at rest and if `hold` is set with an acceleration.
** Reference:
**    Alvi, section 5, the three kinds of motion of the program.
*/
FOURLINK_API int fourlink_motion_row(const fourlink_motion *motion, const fourlink_range *range,
                                     unsigned long i, fourlink_row *row);

/* The crank at any angle of a motion.
**
** Given:
**    motion     as above
**    angle      in the motion's unit, between `from` and the last angle
** Returned:
**    row        as from fourlink_motion_row
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_NO_RUN_UP
** Notes:
** 1) The motion must be one that fourlink_motion_range accepts.
** 2) Beyond the angle at which the crank comes to rest, its speed is 0.
** Reference:
**    omega2^2 = speed^2 + 2 acceleration s, s the angle from the first row in rad.
*/
FOURLINK_API int fourlink_motion_at(const fourlink_motion *motion, double angle, fourlink_row *row);

/* The largest or the smallest value of a quantity over a motion, refined between rows, for hosts without
** a deck.
**
** Given:
**    mechanism  from fourlink_prepare
**    motion     of the crank; its interval does not matter
**    loads      on the links, the same at all crank angles; may be null if n_loads is 0
**    n_loads    how many
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED
**    name       max(COLUMN) or min(COLUMN), such as "max(Ts)", "min(omega4)": any column of decks
** Returned:
**    value      in SI units and radians; infinite if the quantity is unbounded
**    angle      crank angle at which it occurs, in the motion's unit; NaN if the value is infinite.  May be
**               null
** Returned (function value):
**    FOURLINK_OK, FOURLINK_NOT_REACHED, FOURLINK_LONG_SEARCH; FOURLINK_NO_SUCH_NAME, FOURLINK_NULL,
**    FOURLINK_NO_MEMORY, or as from fourlink_motion_range and fourlink_solve
** Notes:
** 1) It is max(COLUMN) of the deck with the same mechanism, motion and loads.
** 2) Loads that follow the motion, springs and friction need a deck.
*/
FOURLINK_API int fourlink_extreme(const fourlink_mechanism *mechanism,
                                  const fourlink_motion *motion, const fourlink_load *loads,
                                  unsigned long n_loads, fourlink_branch branch, const char *name,
                                  double *value, double *angle);

/* Read a deck from memory.
**
** Given:
**    text          the deck's text, as in a file; it is not needed after the call
**    length        its length in bytes
**    load          loads the files that the deck names; null if it may not name any
**    host          for `load`; may be null
**    max_mistakes  size of `mistakes`
** Returned:
**    deck          the deck, to be given to fourlink_deck_free
**    mistakes      only with FOURLINK_BAD_DECK: the first of them, in the order of the lines; may be
**                  null if max_mistakes is 0
**    n_mistakes    only with FOURLINK_BAD_DECK: how many there are, which may exceed max_mistakes;
**                  may be null
** Returned (function value):
**    FOURLINK_OK, FOURLINK_BAD_DECK; FOURLINK_NULL, FOURLINK_NO_MEMORY
** Notes:
** 1) If the status is not FOURLINK_OK, there is nothing to free.
** 2) Numbers are read the same way in every locale.
** 3) A deck with a [sweep] gives its first design.  Columns and expected values are checked but not returned.
** 4) More than 10,000,000 rows by angle, or 1,000,000 by time, are a mistake.
** Reference:
**    the manual page fourlink-deck(5)
*/
FOURLINK_API int fourlink_deck_read(const char *text, unsigned long length, fourlink_loader *load,
                                    void *host, unsigned long max_mistakes, fourlink_deck **deck,
                                    fourlink_mistake *mistakes, unsigned long *n_mistakes);

/* Free a deck; null is allowed. */
FOURLINK_API void fourlink_deck_free(fourlink_deck *deck);

/* The problem that a deck poses.
**
** Given:
**    deck       from fourlink_deck_read
** Returned:
**    problem    in SI units and radians, except the angles of its motion; a copy, which may be changed and
**               remains valid after the deck is freed
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
** Note:
**    For row i of the deck: fourlink_motion_range, fourlink_motion_row, fourlink_deck_loads,
**    fourlink_analyse.
*/
FOURLINK_API int fourlink_deck_problem(const fourlink_deck *deck, fourlink_problem *problem);

/* The loads of a deck at one crank angle: curves (by Steffen's interpolation), loads within their range of
** crank angles, and the gas force.
**
** Given:
**    deck       from fourlink_deck_read
**    branch     FOURLINK_OPEN or FOURLINK_CROSSED: decides from which side the gas pushes a piston
**    theta2     rad, crank angle
** Returned:
**    loads      problem.n_loads loads, for fourlink_analyse, in the order of fourlink_deck_load. Springs,
**               friction, and loads that depend on anything but the crank angle are 0: see
**               fourlink_deck_analyse
**    gas_force  N, of the gas on the piston, towards the crank positive, for fourlink_engine_method
**               (which takes the loads without the gas); on a rod, along the slide; 0 without gas;
**               may be null
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_BRANCH
** Reference:
**    ME3491, "Forces on the reciprocating parts of an engine": p1 A1 - p2 A2.
*/
FOURLINK_API int fourlink_deck_loads(const fourlink_deck *deck, fourlink_branch branch,
                                     double theta2, fourlink_load *loads, double *gas_force);

/* A crank position of a deck with all its loads: those of fourlink_deck_loads, loads that depend on a speed,
** springs, dampers and friction.
**
** Given:
**    deck         from fourlink_deck_read
**    branch       FOURLINK_OPEN or FOURLINK_CROSSED
**    crank        crank angle, speed and acceleration
**    closed_form  1: forces as from fourlink_solve_dyad, 0: as from fourlink_solve
** Returned:
**    loads        problem.n_loads loads; also changed on errors
**    state        the motion
**    forces       with all loads
**    losses       friction; without it Ts0 is Ts, the efficiency 1 and the rest 0
**    gas_force    N, as from fourlink_deck_loads
** Returned (function value):
**    as from fourlink_analyse, fourlink_solve_friction and fourlink_spring_at
*/
FOURLINK_API int fourlink_deck_analyse(const fourlink_deck *deck, fourlink_branch branch,
                                       const fourlink_crank *crank, int closed_form,
                                       fourlink_load *loads, fourlink_state *state,
                                       fourlink_forces *forces, fourlink_losses *losses,
                                       double *gas_force);

/* A spring of a deck, and the friction of its joints (all 0 if it has none).
**
** Given:
**    deck       from fourlink_deck_read
**    i          0 ... problem.n_springs - 1
** Returned:
**    name       its name, null-terminated, valid as long as the deck; may be null
**    spring     for fourlink_spring_at
**    friction   for fourlink_solve_friction
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_POINT if there is no such spring
*/
FOURLINK_API int fourlink_deck_spring(const fourlink_deck *deck, unsigned long i, const char **name,
                                      fourlink_spring *spring);
FOURLINK_API int fourlink_deck_friction(const fourlink_deck *deck, fourlink_friction *friction);

/* An actuator of a deck, between points of two links. */
typedef struct fourlink_actuator {
    const char *name;          /* null-terminated, valid as long as the deck */
    int link, to;              /* FOURLINK_GROUND, FOURLINK_CRANK ... */
    fourlink_vector at, to_at; /* m, in the axes of these links */
    double bore, rod_diameter; /* m; 0: not given */
    int drives;                /* 1: its force drives the machine */
} fourlink_actuator;

/* Given:
**    deck       from fourlink_deck_read
**    i          from 0
** Returned:
**    actuator   the actuator
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_POINT if there is no such actuator
*/
FOURLINK_API int fourlink_deck_actuator(const fourlink_deck *deck, unsigned long i,
                                        fourlink_actuator *actuator);

/* What drives, if not a torque on the crank, as loads: one on each link that it pushes.  They are not among
** the problem.n_loads loads.
**
** Given:
**    deck    from fourlink_deck_read
**    i       from 0
** Returned:
**    info    of load i of fourlink_drive_loads; its sort is FOURLINK_LOAD_DRIVE
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_LINK if there is no such load
*/
FOURLINK_API int fourlink_deck_drive(const fourlink_deck *deck, unsigned long i,
                                     fourlink_load_info *info);

/* The loads of what drives.
**
** Given:
**    mechanism   from fourlink_deck_problem
**    state       the motion
**    effort      N or N m, the force or the torque: `drive` of fourlink_forces
** Returned:
**    load        in the order of fourlink_deck_drive
**    n           0 to 2, how many; 0 if a torque on the crank drives, or where the ends of an actuator meet
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
*/
FOURLINK_API int fourlink_drive_loads(const fourlink_mechanism *mechanism,
                                      const fourlink_state *state, double effort,
                                      fourlink_load load[2], int *n);

/* The status of a row in words: as fourlink_status_text, and which output cannot be assembled.
**
** Given:
**    deck    from fourlink_deck_read or fourlink_results_deck
**    at      a row of it
** Returned (function value):
**    the words, valid as long as the deck
*/
FOURLINK_API const char *fourlink_deck_status_text(const fourlink_deck *deck,
                                                   const fourlink_instant *at);

/* The name of a link.
**
** Given:
**    deck    from fourlink_deck_read or fourlink_results_deck
**    link    1 to the last
** Returned (function value):
**    crank, coupler ...; of a link of an [output] NAME or NAME.rod; "unknown link"
*/
FOURLINK_API const char *fourlink_deck_link_text(const fourlink_deck *deck, int link);

/* The part of a deck's program that a time is in.
**
** Given:
**    deck    from fourlink_deck_read or fourlink_results_deck
**    time    s; before the beginning of the program its first part, behind its end the last
** Returned:
**    part    its words are constant strings
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL; FOURLINK_NO_SUCH_POINT for a deck without a program
*/
FOURLINK_API int fourlink_deck_program(const fourlink_deck *deck, double time,
                                       fourlink_program_part *part);

/* A tracer point of a deck.
**
** Given:
**    deck       from fourlink_deck_read
**    i          0 ... problem.n_points - 1
** Returned:
**    name       its name, null-terminated, valid as long as the deck; may be null
**    link       2, 3 or 4
**    at         m, in the link's own axes, for fourlink_point
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_POINT
*/
FOURLINK_API int fourlink_deck_point(const fourlink_deck *deck, unsigned long i, const char **name,
                                     int *link, fourlink_vector *at);

/* The text of a deck with its current values, as set by changes and by the design of its [sweep], and without
** the [sweep].  Everything else is as in the text that was read, including comments and line ends; a deck
** without changes and [sweep] is written as it was.
**
** Given:
**    deck       from fourlink_deck_read, or fourlink_results_deck
**    size       of `out`; 0: only the length is wanted
** Returned:
**    out        the text, null-terminated; cut off if longer than size - 1.  May be null if size is 0
**    length     of the text in bytes, without the null character
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
** Notes:
** 1) A value of a design is written in the unit of the value that it replaces, `length = 21 mm`, if a number
**    with at most 17 digits gives the same value.  A value of a change is written as the change gives it.
** 2) If a part of a vector is set, the vector is written as two components.
** 3) A value that is not in the text is added after the first line of its section, or in a new section at the
**    end.
** 4) A deck read from this text has the same results.  Designs are solved by dyads unless the deck has
**    `solver`, so `solver = dyad` is added to the text of a design.
*/
FOURLINK_API int fourlink_deck_write(const fourlink_deck *deck, char *out, unsigned long size,
                                     unsigned long *length);

/* Write a deck by lengths as one by the places of its pins ([pins]), drawn on the open branch; one with
** [pins] as fourlink_deck_write does.
**
** Given:
**    theta2     rad, the crank angle of the drawing, from x of link 1
**    others     as for fourlink_deck_write
** Returned:
**    as from fourlink_deck_write
** Returned (function value):
**    FOURLINK_OK; as from fourlink_position; FOURLINK_NULL
** Notes:
** 1) Lengths that follow from the pins are left out.  Everything else holds as it is written, in the axes of
**    link 1: `axes = ground` is added unless the deck has axes, and `branch = both` if it had both.
** 2) Where the drawing does not tell the mechanism, the text cannot be read, or is another one: if links
**    3 and 4 are in line, or the pin of a piston is not on the side of x.
*/
FOURLINK_API int fourlink_deck_write_pins(const fourlink_deck *deck, double theta2, char *out,
                                          unsigned long size, unsigned long *length);

/* The unit of a quantity in the results of a deck.
**
** Given:
**    deck       from fourlink_deck_read, or fourlink_results_deck
**    quantity   length, area, volume, angle, mass, time, speed, acceleration, angular_speed,
**               angular_acceleration, inertia, force, torque, pressure, power, energy, stiffness, damping,
**               torsional_stiffness, torsional_damping, mass_moment or number
** Returned:
**    unit       its name and size
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_NAME
*/
FOURLINK_API int fourlink_deck_unit(const fourlink_deck *deck, const char *quantity,
                                    fourlink_unit *unit);

/* Read a number with a unit, such as 30 deg, in the unit that the results of a deck have.
**
** Given:
**    deck       from fourlink_deck_read, or fourlink_results_deck
**    quantity   as for fourlink_deck_unit
**    words      the number, as in a deck; a bare number is in the unit of the results
** Returned:
**    value      in the unit of the results
**    mistake    only with FOURLINK_BAD_DECK: what is wrong with the words, with line 0; may be null
** Returned (function value):
**    FOURLINK_OK, FOURLINK_BAD_DECK; FOURLINK_NULL, FOURLINK_NO_SUCH_NAME
*/
FOURLINK_API int fourlink_deck_quantity(const fourlink_deck *deck, const char *quantity,
                                        const char *words, double *value,
                                        fourlink_mistake *mistake);

/* Information on a load of a deck: its name, its source, where it acts.
**
** Given:
**    deck       from fourlink_deck_read, or fourlink_results_deck
**    i          0 ... problem.n_loads - 1, those of own loads, of springs, of gas, each by element; then
**               friction in the order of fourlink_losses
** Returned:
**    info       the same at every crank angle; its name is valid as long as the deck
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_LINK if there is no such load
*/
FOURLINK_API int fourlink_deck_load(const fourlink_deck *deck, unsigned long i,
                                    fourlink_load_info *info);

/* ---------------------------------------------------------------------------------------------
** Synthesis
** ------------------------------------------------------------------------------------------- */

/* Link lengths for a wanted motion.  A function for each task takes a struct, finds linkages, checks them and
** writes them to the caller's array, best first.
**
** Axes.  The designer's axes are those in which a task gives pivots and positions.  The frame of the linkage
** found has its origin at A and x along A->D, as everywhere.  A point P of the designer is at
** (P - origin) e^(-i direction) in that frame.  For `function` and `quick_return` both are the same.
**
** Turned links.  A negative length in the equations means that the link is turned by 180 deg: its angle in
** the linkage is that of the designer plus 180 deg (crank_turn, rocker_turn).
**
** A defect is not a failure: the solution is returned, and `defects` says what is wrong with it. */

/* Defects of a solution: bits. */
enum {
    FOURLINK_DEFECT_BRANCH = 1,  /* precision positions are on both branches */
    FOURLINK_DEFECT_CIRCUIT = 2, /* they are on both circuits: the linkage has to be taken apart */
    FOURLINK_DEFECT_ORDER = 4,   /* the crank does not pass them in the given order */
    FOURLINK_DEFECT_DEAD = 8,    /* a precision position is a dead position */
    FOURLINK_DEFECT_WAY = 16,    /* a dead position lies between precision positions */
    FOURLINK_DEFECT_REACH = 32,  /* the crank does not reach the whole working range */
    FOURLINK_DEFECT_MISSED = 64  /* a precision position is not met within rounding; not for least
                                    squares, which meet none */
};

/* The name of one of them: a constant string in English, never null. */
FOURLINK_API const char *fourlink_defect_text(int defect);

/* The most precision points of a task. */
#define FOURLINK_PRECISION_MAX 100

/* The most positions of a solution, and of a search through many points. */
#define FOURLINK_POSITIONS_MAX 500

/* A precision position of a solution, in the frame of the linkage. */
typedef struct fourlink_precision {
    double theta2; /* rad, crank angle, continuous along the motion */
    double output; /* wanted: theta4 (rad, in (-pi, pi]), or X (m) of a piston; lever: theta4 */
    double theta3; /* rad, wanted angle of the coupler, in (-pi, pi]; motion, path, cognate */
    fourlink_vector point; /* m, wanted position of the coupler point; motion, path, cognate */
    double error;    /* what the linkage has there minus what is wanted: rad, or m for a piston;
                        motion, path, cognate: distance of the point from its place, m; NaN: not reached */
    double residual; /* 1, function: error F of the linear equation (see fourlink_function_task);
                        rad, many poses: the coupler's angle there minus theta3 */
    double mu;       /* rad, transmission angle; NaN: not reached */
    int branch;      /* FOURLINK_OPEN, FOURLINK_CROSSED; 0: neither, as `status` says */
    int status;      /* FOURLINK_OK, or why there is no position: FOURLINK_DEAD_POSITION ... */
} fourlink_precision;

/* A linkage found, with its checks. */
typedef struct fourlink_solution {
    fourlink_design design; /* kind, lengths, offset; without masses */
    fourlink_branch branch; /* of the first position that is not dead */
    double a, c;            /* m, crank and rocker with the signs of the equations */
    double crank_turn;  /* rad, 0 or pi: crank angle of the linkage minus that of the designer */
    double rocker_turn; /* rad, 0 or pi: the same for theta4 */
    double K[3];        /* function: K1, K2, K3 (1); slider-crank: S1 (m), S2, S3 (m2); else 0 */
    double condition;   /* 1, of the linear system, columns scaled to the same length; 1: none */
    fourlink_vector origin; /* m, A in the designer's axes */
    double direction;       /* rad, angle of A->D in the designer's axes */
    int has_point;          /* 1: there is a coupler point */
    fourlink_vector point;  /* m, coupler point in the coupler's own axes */
    double from, to;        /* rad, working range: crank angles where the motion begins and ends */
    int n_positions;
    int is_in_order; /* 1: the crank passes the positions in their order; points of a path that are
                        nearer to each other than the curve comes to them may change places */
    int defects;     /* sum of FOURLINK_DEFECT_BRANCH ...; 0: none */
    fourlink_type type;
    double ratio;  /* 1, longest / shortest link */
    double mu_min; /* rad, smallest transmission angle in the working range, on `branch`; 0 at and
                            beyond a dead position */
    double mu_min_at;    /* rad, crank angle there */
    double mu_positions; /* rad, smallest at the precision positions */
    double
        max_error; /* rad or m, function: largest |structural error|, with the sign of the error: in
                            the working range if the wanted function is given, else at the points; rad,
                      many poses: largest error of the coupler's angle */
    double max_error_at;  /* rad, crank angle of the linkage there */
    int is_better_longer; /* 1: function, FOURLINK_FIT_ANGLE: longer links would fit better, but the
                             longest is as long as it may be, see fourlink_synthesis_function */
    double sum;          /* m2, points: the sum that is made small, see fourlink_synthesis_points */
    double rms, largest; /* m, points: root mean square and largest distance */
    unsigned long starts; /* points: how many starts were tried */
    int is_swapped;       /* 1, points: the crank stands on the pivot given as right */
    fourlink_precision position[FOURLINK_POSITIONS_MAX];
} fourlink_solution;

/* The wanted output of a function generator, for the structural error between the points.
**
** Given:
**    host       as in the task
**    theta2     rad, crank angle of the designer
** Returned (function value):
**    theta4 of the designer (rad), or X (m); NaN: not defined there
*/
typedef double fourlink_wanted(void *host, double theta2);

/* What least squares make small. */
typedef enum fourlink_fit {
    FOURLINK_FIT_EQUATION = 0, /* sum of w F^2, F the error of the linear equation */
    FOURLINK_FIT_ANGLE = 1     /* sum of w error^2, the error of theta4, or of X, on one branch */
} fourlink_fit;

/* A function generator.  Set it to zero first: members that stay 0 are absent. */
typedef struct fourlink_function_task {
    fourlink_kind kind;   /* FOURLINK_FOUR_BAR or FOURLINK_SLIDER_CRANK */
    double ground;        /* m, four-bar: length of the ground */
    unsigned long n;      /* points: 3 to FOURLINK_PRECISION_MAX */
    const double *theta2; /* rad, crank angles */
    const double
        *output; /* theta4 (rad); slider-crank: X (m), the piston's coordinate from A along x */
    const double *weight; /* 1, > 0, w; null: all are 1 */
    fourlink_fit fit;
    double from, to; /* rad, working range in the designer's crank angles; equal: the smallest that
                              has all points */
    fourlink_wanted *wanted; /* null: known at the points only */
    void *host;              /* for `wanted` */
} fourlink_function_task;

/* What is given of a dyad, the link from a fixed pivot m to a moving pivot k on the coupler. */
typedef enum fourlink_choice {
    FOURLINK_FIXED_PIVOT = 1,  /* m */
    FOURLINK_MOVING_PIVOT = 2, /* k in the first position */
    FOURLINK_ROTATIONS =
        3,              /* the link's rotations from the first to the second and third position */
    FOURLINK_SLIDER = 4 /* right: in place of a link, a slider on a line in a given direction */
} fourlink_choice;

typedef struct fourlink_dyad {
    fourlink_choice choice;
    fourlink_vector pivot; /* m, in the designer's axes */
    double rotation[2];    /* rad, counter-clockwise; slider: the direction of its line first */
} fourlink_dyad;

/* Three positions of the coupler: a point of it and its angle. */
typedef struct fourlink_motion_task {
    fourlink_vector point[3]; /* m, in the designer's axes */
    double angle[3];          /* rad; only differences count */
    fourlink_dyad left;       /* the crank */
    fourlink_dyad right;      /* the rocker, or a slider */
} fourlink_motion_task;

/* Three points of a path, with the crank's rotations between them. */
typedef struct fourlink_path_task {
    fourlink_vector point[3]; /* m, in the designer's axes */
    double timing[2];         /* rad, rotations of the crank from the first point to the others */
    int search;               /* 1: the coupler's rotations are searched for; 0: given */
    double rotation[2];       /* rad, of the coupler, from the first point to the others */
    double step;              /* rad, search: step of the rotations; 0: 5 deg */
    fourlink_dyad right;      /* the rocker, or a slider */
} fourlink_path_task;

/* Where a fixed pivot may be: at `low`, or in the box from `low` to `high`. */
typedef struct fourlink_ground {
    int is_given;              /* 0: anywhere */
    fourlink_vector low, high; /* m, in the designer's axes */
} fourlink_ground;

/* Many points of a path, or poses of the coupler.  Set it to zero first: members that stay 0 are absent. */
typedef struct fourlink_points_task {
    fourlink_kind kind;           /* FOURLINK_FOUR_BAR or FOURLINK_SLIDER_CRANK */
    unsigned long n;              /* 3 to FOURLINK_POSITIONS_MAX */
    const fourlink_vector *point; /* m, in the designer's axes */
    const double *angle;          /* rad, of the coupler, only differences count; null: a path */
    const double *timing;        /* rad, n - 1 rotations of the crank from the first position to the
                                     others, which rise or fall; null: any */
    int either_way;              /* 1: the crank may also turn by the opposite of `timing` */
    const double *weight;        /* 1, > 0, w; null: all are 1 */
    fourlink_ground left, right; /* the pivots A and D, of which the crank takes the better one */
    int may_rock;                /* 1: the crank need not turn fully */
    int any_order;               /* 1: the crank may pass the positions in any order */
    double mu_min;               /* rad, least transmission angle in the working range; 0: any */
    double shortest, longest;    /* m, bounds of the links' lengths; 0: any */
    double length_ratio;         /* 1, of the longest link to the shortest at most; 0: any */
    unsigned long effort;        /* so many times the usual number of starts; 0: once */
    const struct fourlink_solution *near; /* the only start, a linkage for as many positions; null:
                                             many starts */
} fourlink_points_task;

/* The stroke that is the slow one. */
enum {
    FOURLINK_SLOW_WITH = 1,    /* the rocker turns as the crank does; of a piston, towards the
                                  crankshaft, for a crank that turns counter-clockwise */
    FOURLINK_SLOW_AGAINST = -1 /* the other stroke */
};

/* A quick return.  Set it to zero first: lengths that stay 0 are to be found. */
typedef struct fourlink_quick_return_task {
    fourlink_type type; /* FOURLINK_CRANK_ROCKER, FOURLINK_ENGINE (a slider-crank),
                           FOURLINK_SLOTTED_LEVER or FOURLINK_WHITWORTH */
    double time_ratio;  /* 1, >= 1; slotted lever: 0 if the swing is given */
    double swing;       /* rad, crank-rocker, slotted lever */
    double stroke;      /* m, slider-crank; slotted lever: of a tool at C, 0: none */
    double length[5];   /* m, by link number.  Crank-rocker: two, or one for the largest mu_min;
                           slider-crank: one of crank, rod and offset, or none for the largest mu_min;
                           slotted lever, Whitworth: ground or crank; lever: its length, instead of the
                           stroke */
    double offset; /* m, slider-crank: distance of the line of stroke, its sign follows from `slow`;
                           slotted lever: as in fourlink_design */
    int slow;      /* FOURLINK_SLOW_WITH, 0: the same; FOURLINK_SLOW_AGAINST: not for levers */
} fourlink_quick_return_task;

/* Which of the two cognates. */
typedef enum fourlink_side { FOURLINK_LEFT = 1, FOURLINK_RIGHT = 2 } fourlink_side;

/* A linkage whose coupler point another one shall trace. */
typedef struct fourlink_cognate_task {
    fourlink_design design; /* four-bar */
    fourlink_branch branch;
    fourlink_vector point; /* m, in the coupler's own axes */
    fourlink_side side;
    double from, to; /* rad, its crank angles; equal: a full turn, or the first range it reaches */
} fourlink_cognate_task;

/* Points for a function's range by Chebyshev's spacing.
**
** Given:
**    from, to   the range
**    n          how many, 1 to FOURLINK_PRECISION_MAX
** Returned:
**    x          n numbers, from `from` to `to`
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_POINTS
** Note:
**    The spacing makes the largest errors between the points equal to first order only.
** Reference:
**    F. Freudenstein, "Approximate Synthesis of Four-Bar Linkages", Trans. ASME 77 (1955) 853-861.
*/
FOURLINK_API int fourlink_chebyshev(double from, double to, unsigned long n, double *x);

/* A four-bar linkage or a slider-crank whose output is a function of the crank angle.
**
** Given:
**    task       points, weights, range
**    max        length of `solutions`
** Returned:
**    solutions  one linkage, if max > 0
**    n          how many there are, 1; may be more than `max`
** Returned (function value):
**    FOURLINK_OK; FOURLINK_DEPENDENT, FOURLINK_INFINITE_LINK, FOURLINK_NO_LINKAGE: there is none;
**    FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_KIND, FOURLINK_BAD_LENGTH, FOURLINK_BAD_POINTS,
**    FOURLINK_BAD_CHOICE
** Notes:
** 1) Four-bar: the residual of a position is F = K1 cos(theta4) - K2 cos(theta2) + K3 -
**    cos(theta2 - theta4), with the designer's angles.  Slider-crank: F = (S1 X cos(theta2) +
**    S2 sin(theta2) - S3 - X^2) / X_max^2.  It is not an error of the output.
** 2) Three points are met exactly.  More are met by least squares; three with a fit of the angle are no
**    different.
** 3) A linkage that reaches a point on both branches has it on the one whose output is nearer; for a fit of
**    the angle all points are on `branch`.
** 4) A linkage of least squares may not reach some points: FOURLINK_DEFECT_REACH.  A fit of the angle
**    reaches all, with a transmission angle of at least 0.001 deg.  Of these linkages it has the least sum,
**    to 1 %, if no link, or offset, may be more than 100 times as long as another; of a slider-crank, crank
**    and rod may not be as much shorter than the largest |X| either.
** 5) Points stand in the order of the motion.  If their angles neither rise nor fall, each follows the one
**    before by the shorter way: 350, 10, 30 deg are 350, 370, 390 deg.
** Reference:
**    Freudenstein 1955, see fourlink_chebyshev; see synthesis/function.c.
*/
FOURLINK_API int fourlink_synthesis_function(const fourlink_function_task *task, unsigned long max,
                                             fourlink_solution *solutions, unsigned long *n);

/* The structural error of a function generator: the linkage's output minus the wanted one.
**
** Given:
**    solution   from fourlink_synthesis_function
**    theta2     rad, crank angle of the designer
**    wanted     theta4 of the designer (rad), or X (m)
** Returned:
**    error      rad, in (-pi, pi], or m
** Returned (function value):
**    FOURLINK_OK; 1 to 19, the linkage does not reach the angle; FOURLINK_NULL, FOURLINK_BAD_NUMBER
*/
FOURLINK_API int fourlink_synthesis_error(const fourlink_solution *solution, double theta2,
                                          double wanted, double *error);

/* A four-bar linkage, or a slider-crank, that guides its coupler through three positions.
**
** Given:
**    task       positions and what is chosen of both dyads
**    max        length of `solutions`
** Returned:
**    solutions  one linkage, if max > 0
**    n          how many there are, 1
** Returned (function value):
**    FOURLINK_OK; FOURLINK_DEPENDENT, FOURLINK_INFINITE_LINK, FOURLINK_NO_LENGTH: there is none;
**    FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_CHOICE
** Notes:
** 1) If the three places of the right moving pivot are on a line, or a slider is asked for, the linkage is a
**    slider-crank.  FOURLINK_INFINITE_LINK: those of the left one are, or those of a fixed pivot seen
**    from the coupler.
** 2) FOURLINK_DEPENDENT: two positions are equal, or a pivot is a pole of two positions, so that the other
**    pivot may be anywhere on a line.
** 3) FOURLINK_NO_LENGTH: A and D or B and C are the same point, or both dyads are the same.
** 4) The crank may run either way; `from` and `to` follow from the order of the positions.
** Reference:
**    see synthesis/dyad.c.
*/
FOURLINK_API int fourlink_synthesis_motion(const fourlink_motion_task *task, unsigned long max,
                                           fourlink_solution *solutions, unsigned long *n);

/* A four-bar linkage, or a slider-crank, whose coupler point passes three points at given crank rotations.
**
** Given:
**    task       points, timing, the coupler's rotations or the order to search for them
**    max        length of `solutions`
** Returned:
**    solutions  the first `max` linkages.  A search gives those without defects, crank-rockers and double
**               cranks before others, the largest mu_min first
**    n          how many there are; may be more than `max`
** Returned (function value):
**    as from fourlink_synthesis_motion, and FOURLINK_NONE_FOUND: the search found none without defects
** Note:
**    A search lists the linkages that are better than their neighbours on the grid of rotations.  With a step
**    of 5 deg it takes some hundredths of a second, with 0.5 deg some seconds; it is at least 0.5 deg.
** Reference:
**    see synthesis/dyad.c.
*/
FOURLINK_API int fourlink_synthesis_path(const fourlink_path_task *task, unsigned long max,
                                         fourlink_solution *solutions, unsigned long *n);

/* A four-bar linkage or a slider-crank whose coupler point passes many points, or whose coupler passes many
** poses, as closely as possible.
**
** Given:
**    task       points, timing, weights, where the pivots may be
**    max        length of `solutions`
** Returned:
**    solutions  the first `max` linkages: those without defects, then others, each by its sum of squares, and
**               those that are met within rounding by mu_min
**    n          how many there are; may be more than `max`
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NONE_FOUND, FOURLINK_DEPENDENT (two points are equal); FOURLINK_NULL,
**    FOURLINK_NO_MEMORY, FOURLINK_BAD_NUMBER, FOURLINK_BAD_KIND, FOURLINK_BAD_POINTS, FOURLINK_BAD_CHOICE
** Notes:
** 1) The sum is that of w distance^2: without timing the distance from the curve, else that from the
**    place of the coupler point at the given crank angle.  With angles, w (size error)^2 is added, where
**    size is the root mean square distance of the points from their centre, and the poses are met where
**    this sum is least.
** 2) The search descends from a fixed number of starts, the same on each run.  It finds the best linkage of
**    these starts; a better one may exist.
** 3) Linkages whose transmission angle falls below 0.1 deg, or whose longest link is more than 100 times
**    as long as the shortest, do not count.
** 4) The crank may run either way.  A timing that rises is that of a crank that turns counter-clockwise.
** 5) The search allocates about a megabyte, and frees it.  With 20 points it takes one or two seconds.
** Reference:
**    see synthesis/points.c.
*/
FOURLINK_API int fourlink_synthesis_points(const fourlink_points_task *task, unsigned long max,
                                           fourlink_solution *solutions, unsigned long *n);

/* A mechanism with a given time ratio.
**
** Given:
**    task       type, time ratio, swing or stroke, lengths
**    max        length of `solutions`
** Returned:
**    solutions  one mechanism, on the open branch, if max > 0; its positions are the two limits of the
**               output, its range is a turn of the crank from the first of them
**    n          how many there are, 1
** Returned (function value):
**    FOURLINK_OK; FOURLINK_DEPENDENT, FOURLINK_INFINITE_LINK, FOURLINK_NO_LINKAGE,
**    FOURLINK_NO_FULL_TURN: there is none; FOURLINK_NULL, FOURLINK_BAD_NUMBER, FOURLINK_BAD_KIND,
**    FOURLINK_BAD_LENGTH, FOURLINK_BAD_TIME_RATIO, FOURLINK_BAD_CHOICE
** Notes:
** 1) FOURLINK_BAD_CHOICE: too many or too few lengths, or slow = against for a lever, whose slow stroke is
**    always with the crank.
** 2) FOURLINK_INFINITE_LINK for the largest mu_min: it grows as links become longer and longer (a time ratio
**    of 1).
** Reference:
**    E. Soylemez, "Mechanisms" (METU), 7.1.4 and 7.2; see synthesis/quick_return.c.
*/
FOURLINK_API int fourlink_synthesis_quick_return(const fourlink_quick_return_task *task,
                                                 unsigned long max, fourlink_solution *solutions,
                                                 unsigned long *n);

/* A cognate: another four-bar linkage whose coupler point traces the same curve.
**
** Given:
**    task       the linkage, its branch, its coupler point, left or right
**    max        length of `solutions`
** Returned:
**    solutions  the cognate, if max > 0.  The designer's axes are the frame of the given linkage; positions
**               are those at 1/6, 1/2 and 5/6 of its range
**    n          how many there are, 1
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NO_LENGTH: the coupler point is at B or C; FOURLINK_NOT_REACHED; FOURLINK_NULL,
**    FOURLINK_BAD_NUMBER, FOURLINK_BAD_KIND, FOURLINK_BAD_LENGTH, FOURLINK_BAD_BRANCH, FOURLINK_BAD_CHOICE
** Notes:
** 1) Left has the pivot A and the third pivot E; right has E and D.  The right one's crank turns as the given
**    one's; the left one's turns as the given coupler does.
** 2) The working range of the right one is that of the given linkage; the left one's goes from its first to
**    its last position.
** 3) The left one of a crank-rocker does not turn fully: it has dead positions on the way
**    (FOURLINK_DEFECT_WAY, FOURLINK_DEFECT_BRANCH), unless the range is small.
** Reference:
**    Roberts and Chebyshev; see synthesis/cognate.c.
*/
FOURLINK_API int fourlink_synthesis_cognate(const fourlink_cognate_task *task, unsigned long max,
                                            fourlink_solution *solutions, unsigned long *n);

/* The linkages found for the task of a deck with [synthesis], opened with fourlink_source.synthesis.
**
** Given:
**    deck       from fourlink_results_deck
**    max        length of `solutions`
** Returned:
**    solutions  best first; a search keeps ten, or as many as `synthesis` asked for
**    chosen     number of the one that the deck has, from 0
**    n          how many there are; may be more than `max`, and than are kept
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL, FOURLINK_NO_SUCH_LIST: the deck has no [synthesis]
** Note:
**    fourlink_deck_write writes the deck of the linkage found.
*/
FOURLINK_API int fourlink_deck_solutions(const fourlink_deck *deck, unsigned long max,
                                         fourlink_solution *solutions, unsigned long *chosen,
                                         unsigned long *n);

/* The defects of the linkage that such a deck has, in words.
**
** Given:
**    deck       from fourlink_results_deck
**    max        length of `list`
** Returned:
**    list       the first `max`, with the place of [synthesis]
**    n          how many there are; 0: none, or no [synthesis]
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NULL
*/
FOURLINK_API int fourlink_deck_defects(const fourlink_deck *deck, unsigned long max,
                                       fourlink_mistake *list, unsigned long *n);

#endif
