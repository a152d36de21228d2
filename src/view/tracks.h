/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tracks.h - the numbers of a mechanism at an instant: places, velocities, accelerations, forces, torques.
**
** scene.h says what is drawn of them.  Over the motion each is a track.
*/
#ifndef FOURLINK_TRACKS_H
#define FOURLINK_TRACKS_H

#include "view.h"

/* What a drawing has room for. */
enum { TRACKS_LOADS = 42, TRACKS_POINTS = 24, TRACKS_SPRINGS = TRACKS_LOADS, TRACKS_NAME = 16 };

/* The tracks of an output, behind its first.  P and Q, and D of a rocker that floats, have their
** velocities and accelerations behind them.  P6 is the point at P of a slider or rocker with a slot, Qk
** that at Q of the link with one. */
enum {
    OUTPUT_P,
    OUTPUT_Q = OUTPUT_P + 3,
    OUTPUT_D = OUTPUT_Q + 3,
    OUTPUT_VP = OUTPUT_D + 3, /* of the pin P */
    OUTPUT_VQ,                /* of Q from the pole, unless the pin of the rocker moves */
    OUTPUT_VQP,
    OUTPUT_VQD,
    OUTPUT_VP6,
    OUTPUT_VPP6, /* along the slot */
    OUTPUT_VQK,
    OUTPUT_VQQK,
    OUTPUT_AP,
    OUTPUT_AQ,   /* of Q of a slider */
    OUTPUT_AQPN, /* normal and tangential */
    OUTPUT_AQPT,
    OUTPUT_AQDN,
    OUTPUT_AQDT,
    OUTPUT_AQN, /* of a rocker about a fixed pin */
    OUTPUT_AQT,
    OUTPUT_AP6N,
    OUTPUT_AP6T,
    OUTPUT_AP6, /* of a slider */
    OUTPUT_AK,  /* Coriolis, in a slot of its own */
    OUTPUT_AS,
    OUTPUT_AQK,
    OUTPUT_AKK, /* Coriolis, in a slot of the link */
    OUTPUT_ASK,
    OUTPUT_FP,
    OUTPUT_FQ,
    OUTPUT_FD, /* on a rocker at its pin; N of the guide on a slider */
    OUTPUT_M,  /* of the guide */
    TRACKS_OF_OUTPUT
};

/* The numbers of the tracks; of some there are several.  A centre of mass, or a tracer point, has its place
** and behind that its velocity and its acceleration. */
enum {
    TRACK_A, /* the joints, by letter */
    TRACK_B,
    TRACK_C,
    TRACK_D,
    TRACK_E1, /* ends of the lever */
    TRACK_E2,
    TRACK_VB,
    TRACK_VC,
    TRACK_VCB,
    TRACK_VB4, /* of the point of the lever at B */
    TRACK_VS,  /* along the slide */
    TRACK_ABN, /* normal and tangential */
    TRACK_ABT,
    TRACK_ACBN,
    TRACK_ACBT,
    TRACK_ACN,
    TRACK_ACT,
    TRACK_AC,
    TRACK_AB4N,
    TRACK_AB4T,
    TRACK_AB4,
    TRACK_AK, /* Coriolis */
    TRACK_AS,
    TRACK_FORCE,                    /* F12, F23, F34, F14: of joint i */
    TRACK_COUPLE = TRACK_FORCE + 4, /* of a slider */
    TRACK_TS = TRACK_COUPLE + 4,
    TRACK_CENTRE,                                                /* of link i, from 0 */
    TRACK_WEIGHT = TRACK_CENTRE + 3 * FOURLINK_LINKS,            /* of link i */
    TRACK_INERTIA_FORCE = TRACK_WEIGHT + FOURLINK_LINKS,         /* -m a */
    TRACK_INERTIA_TORQUE = TRACK_INERTIA_FORCE + FOURLINK_LINKS, /* -I alpha */
    TRACK_POINT = TRACK_INERTIA_TORQUE + FOURLINK_LINKS,         /* tracer point i */
    TRACK_LOAD = TRACK_POINT + 3 * TRACKS_POINTS,                /* the place of load i, */
    TRACK_LOAD_FORCE = TRACK_LOAD + TRACKS_LOADS,                /* its force */
    TRACK_LOAD_TORQUE = TRACK_LOAD_FORCE + TRACKS_LOADS,         /* and its torque */
    TRACK_SPRING = TRACK_LOAD_TORQUE + TRACKS_LOADS,             /* both ends of spring i */
    TRACK_DRIVE = TRACK_SPRING + 2 * TRACKS_SPRINGS, /* load i of what drives, if not the crank: */
    TRACK_DRIVE_FORCE = TRACK_DRIVE + 2,
    TRACK_DRIVE_TORQUE = TRACK_DRIVE_FORCE + 2,
    TRACK_OUTPUT = TRACK_DRIVE_TORQUE + 2, /* those of output i */
    TRACK_COUNT = TRACK_OUTPUT + FOURLINK_MOST_GROUPS * TRACKS_OF_OUTPUT
};

#define TRACK_OF_CENTRE(link) (TRACK_CENTRE + 3 * (link))
#define TRACK_OF_OUTPUT(i) (TRACK_OUTPUT + TRACKS_OF_OUTPUT * (int)(i))
#define TRACK_OF_POINT(i) (TRACK_POINT + 3 * (int)(i))

/* The track of a joint's place. */
#define TRACK_OF_JOINT(joint) (TRACK_A + (joint)->letter[0] - 'A')

/* A vector, or a number, which is x, in SI units. */
typedef struct track {
    int is_there; /* 0: this mechanism has none */
    quantity q;
    fourlink_vector v;
} track;

typedef struct tracks {
    const view *v;
    track list[TRACK_COUNT];
} tracks;

/* The numbers at an instant; where the linkage cannot be assembled those of the crank alone.  The deck has no
** more of anything than there is room for. */
void tracks_find(tracks *t, const view *v, const fourlink_instant *now, const fourlink_load *loads);

/* The places alone at a position; 1 for those that a drawing needs room for: pins, points, ends of
** springs. */
void tracks_find_places(tracks *t, const view *v, const fourlink_state *state);
int tracks_is_outline(const tracks *t, int number);

/* The vector of a track; 0 if there is none. */
fourlink_vector tracks_vector(const tracks *t, int number);

/* The link with which the place of a track moves: a joint, a centre of mass, where a load acts, a pin of
** an output. */
int tracks_body(const tracks *t, int number);

/* The mass and so on of a link, of an output too. */
const fourlink_link *tracks_link(const view *v, int link);

/* What a disc is called in the file: G2, P0. */
char *tracks_name(const char *before, unsigned long i, char name[TRACKS_NAME]);

#endif
