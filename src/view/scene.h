/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene.h - what a drawing of a mechanism consists of: polygons, forces and torques, by the numbers of
** their tracks.
**
** Pictures draw it at one instant, those of a report at each step of a motion.
*/
#ifndef FOURLINK_SCENE_H
#define FOURLINK_SCENE_H

#include "tracks.h"

/* ------------------------------------------------------------------------------------------ polygons */

/* A side from one corner to another. */
typedef struct scene_side {
    const char *name, *sub, *super; /* v_CB, a_B^n */
    int from, to;                   /* 0: the pole */
    int of;                         /* its track */
    int link;                       /* whose vector it is; 5: of none */
} scene_side;

enum { SCENE_SIDES = 8 }; /* at most */

typedef struct scene_polygon {
    const char *title; /* without "polygon" */
    quantity q;
    const char *zero; /* if all sides are 0 */
    const scene_side
        *sides; /* the last has no name; those without a track are not of this mechanism */
    const char *const *letters; /* of the corners; null: it has none */
    int lines[2][2];            /* from corner to corner; 0 and 0: none */
    const char *mark;           /* on the letters of the images, */
    int derivative;             /* and by how much their tracks are behind those of the places */
} scene_polygon;

/* Those of velocities and of accelerations. */
const scene_polygon *scene_polygons(const view *v);

/* ----------------------------------------------------------------------------------- forces, torques */

/* What a force or a torque is. */
typedef enum scene_sort { SCENE_PIN, SCENE_LOAD, SCENE_INERTIA } scene_sort;

/* A force, or a torque, on a link. */
typedef struct scene_force {
    const char *name; /* F_12, - m a_G2; that of a load is the deck's */
    char sub[TRACKS_NAME];
    int of, at; /* tracks of its values and of its place */
    int sign;   /* -1: a reaction to them */
    int on;     /* the link */
    scene_sort sort;
    int is_inner; /* 1: it is not in the drawing of the whole mechanism */
    int load;     /* FOURLINK_LOAD_OWN ...; 0: none */
} scene_force;

/* The image of a centre of mass, g_2, or of a tracer point in a polygon. */
typedef struct scene_image {
    const char *name;
    int link; /* below its letter; 0: none */
    int of;   /* the track of its place */
} scene_image;

/* Pins with both directions, couples, weight and inertia of three links, loads, what drives. */
enum { SCENE_FORCES = 8 + 8 + 6 + TRACKS_LOADS + 2, SCENE_IMAGES = 3 + TRACKS_POINTS };

typedef struct scene {
    scene_image images[SCENE_IMAGES];
    int n_images;
    scene_force forces[SCENE_FORCES], torques[SCENE_FORCES];
    int n_forces, n_torques;
} scene;

/* The scene of a deck with at most so many loads and points as a drawing shows. */
void scene_find(scene *s, const view *v);

/* Its name: F and its links as subscripts; -m a with the subscript G, without the link; as notation.h marks
** it. */
char *scene_words(const scene_force *f, char *out, size_t size);

/* ------------------------------------------------------------------------------------------- springs */

/* 1 for a spring that has a coil, or a damper; it has one of them at least. */
int scene_has_coil(const fourlink_spring *spring);
int scene_has_damper(const fourlink_spring *spring);

/* The number of the joint at which a torsional spring is: that of its links, or of the ground and one of
** them. */
int scene_joint_of(const fourlink_spring *spring);

#endif
