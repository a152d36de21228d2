# SPDX-License-Identifier: GPL-3.0-or-later
#
# columns.py - the columns of `fourlink --list` of the states of a machine, each from its definition there, in SI units.
import numpy as np

from chain import cross, turned
from machine import PI, TURN

UNDEFINED = np.nan


def quotient(x, y):
    """x / y; undefined or infinite where y is 0."""
    with np.errstate(all='ignore'):
        return x / np.where(y == 0, UNDEFINED, y)


def columns(m, s, forces=True):
    """Name -> values of the rows that have a position; and name -> what a column is divided by, of the order of 1: where it
    is small the column is uncertain."""
    if forces:
        m.forces(s)
    v, small = {}, {}
    one, r, e = s.unit, m.a, s.e

    def vector(name, F, size=True):
        v[name + 'x'], v[name + 'y'] = F.real, F.imag
        if size:
            v[name], v[name + '_dir'] = abs(F), np.angle(F)

    v.update(theta2=s.theta2, omega2=s.omega2, alpha2=s.alpha2, condition=1 / m.own_sine(s))
    for k in (3, 4):
        v['theta%d' % k], v['omega%d' % k], v['alpha%d' % k] = s.phi[k - 1] + 0 * s.theta2, s.omega[k - 1], s.alpha[k - 1]
    sine = m.own_sine(s)
    v['mu'] = np.arcsin(np.minimum(sine, 1))
    small['mu'] = np.maximum(np.sqrt(np.maximum(1 - sine ** 2, 0)), 1e-8)
    for output in m.outputs:
        move_output(s, output, v, small)
    if m.kind == 'four-bar':
        v['gamma'] = np.arctan2(abs(cross(e[2], e[3])), turned(e[2], e[3]))
        K = (m.a ** 2 - m.b ** 2 + m.c ** 2 + m.d ** 2) / 2
        v['freudenstein_A'] = K - m.a * (m.d - m.c) * e[1].real - m.c * m.d
        v['freudenstein_B'] = -2 * m.a * m.c * e[1].imag
        v['freudenstein_C'] = K - m.a * (m.d + m.c) * e[1].real + m.c * m.d
    if m.slides:
        v.update(x=m.variable(s, 'x'), v=m.variable(s, 'v'), a=-s.label * s.acceleration(3, 0).real)
    if m.slot:
        v.update(slide=m.variable(s, 'slide'), slide_v=m.variable(s, 'slide_v'))
        relative = s.acceleration(2, 0) - s.a[3] - (1j * s.alpha[3] - s.omega[3] ** 2) * (s.place(2, 0) - s.r[3])
        v['coriolis'] = 2 * s.omega[3] * v['slide_v']
        v['slide_a'] = turned(e[2], relative)
    v['I13x'], v['I13y'] = pole(one, 2, 0)
    v['I24x'], v['I24y'] = pole(one, 3, 1)
    v['I24y'] = 0 * s.theta2  # on the line of A and D
    if m.slides:
        v['I24x'], v['I24y'] = 0 * s.theta2, -one.v[3].real
    small.update(I13x=one.omega[2], I13y=one.omega[2], klein_IX=one.omega[2], klein_IY=one.omega[2], I24x=one.omega[3] - 1)
    slow = one.v[3].real * -s.label / r if m.slides else one.omega[3]
    with np.errstate(all='ignore'):
        v['mechanical_advantage'] = 1 / slow
    small['mechanical_advantage'] = slow
    points = [('B', 1, m.a), ('C', 3, 0 if m.slides else m.tip if m.slot else m.c)] + [('G%d' % (k + 1), k, m.masses[k][2]) for k in (1, 2, 3)]
    for name, body, at in points + m.points:
        P, V, A = s.place(body, at), s.velocity(body, at), s.acceleration(body, at)
        for key, value in zip(('.x', '.y', '.vx', '.vy', '.ax', '.ay', '.v', '.a'), (P.real, P.imag, V.real, V.imag, A.real, A.imag, abs(V), abs(A))):
            v[name + key] = value
    for spring in m.springs:
        x, rate, T, _, energy = spring.find(s)
        for key, value in zip(('.angle', '.torque') if spring.torsional else ('.length', '.force'), (x, T)):
            v[spring.name + key] = value
        v[spring.name + '.energy'], v[spring.name + '.power'] = energy, -T * rate
    for name, joint in m.joints.items():
        if not joint.guide and '.' not in name:
            high, low = max(joint.i, joint.j), min(joint.i, joint.j)
            v['rubbing_' + name] = m.radius[name] * (s.omega[high] - s.omega[low])
    v['J'] = sum(mass * abs(one.v[k]) ** 2 + inertia * one.omega[k] ** 2 for k, (mass, inertia, _) in enumerate(m.masses))
    if m.kind == 'slider-crank':
        slider_crank(m, s, v)
    for k in (1, 2, 3):
        mass, inertia, _ = m.masses[k]
        size = mass * abs(s.a[k])
        v['Fi%d' % (k + 1)], v['Fi%d_dir' % (k + 1)] = size, np.where(size > 0, np.angle(-s.a[k]), UNDEFINED)
        v['Ci%d' % (k + 1)] = -inertia * s.alpha[k]
        v['h%d' % (k + 1)] = quotient(inertia * s.alpha[k], size)
    if m.gas:
        v['gas_force'] = m.gas(s.theta2)
    if m.gas and m.slides:
        v['volume'], v['pressure'] = m.clearance_volume() + m.bore_area * v['x'], m.pressure(s.theta2)
    if forces:
        add_forces(m, s, v, vector)
    return v, small


def move_output(s, o, v, small):
    rod, end = o.first, o.first + 1
    for front, k in (('.rod_', rod), ('.', end)):
        if not o.slot if front == '.rod_' else not o.slides:
            for key, value in (('theta', np.angle(s.e[k])), ('omega', s.omega[k]), ('alpha', s.alpha[k])):
                v[o.name + front + key] = value + 0 * s.theta2
    if o.slides:
        v[o.name + '.x'] = turned(o.u, s.place(end, 0) - o.q)
        v[o.name + '.v'], v[o.name + '.a'] = turned(o.u, s.velocity(end, 0)), turned(o.u, s.acceleration(end, 0))
    if o.slot:
        v[o.name + '.slide'], v[o.name + '.slide_v'] = o.slide(s)
    sine = o.sine(s)
    v[o.name + '.mu'] = np.arcsin(np.minimum(sine, 1))
    small[o.name + '.mu'] = np.maximum(np.sqrt(np.maximum(1 - sine ** 2, 0)), 1e-8)


def pole(s, i, j):
    """The point of body i that moves as that of body j there."""
    k = s.omega[i] - s.omega[j]
    k = np.where(abs(k) < 1e-12, UNDEFINED, k)
    P = -1j * (s.v[j] - s.v[i] - 1j * (s.omega[j] * s.r[j] - s.omega[i] * s.r[i])) / k
    return P.real, P.imag


def add_forces(m, s, v, vector):
    at = dict(zip(m.joints, m.chain.forces(s, s.x)[0]))
    Ts, e = -s.x[-1], s.e
    F12, F23 = at['A'][0], at['B'][0]
    if m.kind == 'four-bar':
        F34, F14 = at['C'][0], at['D'][0]
    elif m.kind == 'slider-crank':
        F34, (F14, M14) = at['C'][0], at['guide']
    else:  # the slide acts on link 3, its opposite on link 4; u, then n to its left
        F, M = at['slot' if m.slides else 'guide']
        F34, v['N34'], v['M34'] = -F, -turned(1j * e[2], F), -M
        F14, M14 = at['guide'] if m.slides else (at['D'][0], 0)
    friction = {name: s.y[name] * -m.unit_friction(s, m.joints[name])[0] for name in s.y}  # on body i, along u
    if m.slot:
        F34 = F34 - friction.get('slot' if m.slides else 'guide', 0) * e[2]
    if m.slides:
        v['N'] = F14.imag
        v['M14'] = M14 + 0 * Ts
        F14 = F14 + friction.get('guide', 0)
    for name, F in (('F12', F12), ('F23', F23), ('F34', F34), ('F14', F14)):
        vector(name, F)
    v.update(Ts=Ts, Ts_work=Ts, power=Ts * s.omega2, Ts_static=np.where(s.locked_still, np.nan, -s.still[-1]), Ts0=-s.x0[-1])
    v['Ts_inertia'] = Ts - v['Ts_static']
    for name, F, k in (('F12', F12, 1), ('F32', -F23, 1), ('F23', F23, 2), ('F43', -F34, 2), ('F34', F34, 3), ('F14', F14, 3)):
        v[name + '_along'], v[name + '_across'] = turned(e[k], F), cross(e[k], F)
    # what acts on the machine besides the frame is what loads and weights exert; the rest of m a is the frame's
    outside = sum((load.efforts(s) for load in m.loads), s.weight) + s.inertial * -1
    bodies = range(0, outside.shape[1], 3)
    force = sum(outside[:, k] + 1j * outside[:, k + 1] for k in bodies)
    v['Ms'] = sum(outside[:, k + 2] + cross(s.r[k // 3 + 1], outside[:, k] + 1j * outside[:, k + 1]) for k in bodies)
    vector('Fs', force)
    s.parts = abs(F12) + abs(F14)
    v['power_friction'] = sum((s.y[name] * abs(m.joint_speed(s, m.joints[name])) for name in s.y), 0 * Ts)
    for name in m.joints:
        if '.' not in name:
            v['friction_' + name] = s.y.get(name, 0 * Ts)
    for output in m.outputs:
        (FP, _), (FQ, _), (FD, M) = (at[output.name + end] for end in ('.P', '.Q', '.D'))
        vector(output.name + '.FP', FP)
        vector(output.name + '.FQ', -FQ if output.slot == 'output' else FQ)
        if output.slides:
            v[output.name + '.N'], v[output.name + '.M'] = cross(output.u, FD), M + 0 * Ts
        else:
            vector(output.name + '.FD', FD)
    T, T0 = Ts * s.sense, v['Ts0'] * s.sense
    with np.errstate(all='ignore'):
        v['efficiency'] = np.where(T > 0, np.where(T0 > 0, T0 / T, 0), np.where(T0 < 0, T / T0, np.where(T == T0, UNDEFINED, 0)))
    v['residual'] = v['superposition'] = 0 * Ts


def slider_crank(m, s, v):
    """The series, Klein's construction, the engine method (DFA; ME3491)."""
    one, r, l, n, side = s.unit, m.a, m.b, m.b / m.a, s.label
    sin, cos = side * s.e[1].imag, side * s.e[1].real
    v['phi'] = np.arctan2(-s.e[2].imag, abs(s.e[2].real))
    w, al = s.omega2, s.alpha2
    series = {'x': r * (1 - cos + sin ** 2 / (2 * n)), 'v': r * w * (sin + sin * cos / n),
              'a': r * w ** 2 * (cos + (cos ** 2 - sin ** 2) / n) + r * al * (sin + sin * cos / n),
              'omega3': -w * cos / n, 'alpha3': w ** 2 * sin / n - al * cos / n}
    for name, value in series.items():
        v[name + '_series'], v[name + '_diff'] = value, value - v[name]
    v.update(x_harmonic=r * (1 - cos), v_harmonic=r * w * sin, a_harmonic=r * w * w * cos + r * al * sin)
    (mass, inertia, z), g = m.masses[2], m.g
    k3, kk3 = one.omega[2], one.alpha[2]
    v.update(klein_OM=-side * one.velocity(3, 0).real, klein_BM=l * k3, klein_BQ=l * k3 ** 2, klein_QN=l * kk3, klein_ON=-side * one.acceleration(3, 0).real)
    by_inertia = mass * turned(one.a[2], one.v[2]) + inertia * kk3 * k3
    by_weight = mass * turned(g + 0 * one.v[2], one.v[2])
    small = abs(k3) < 1e-12
    v['klein_IX'] = np.where(small, UNDEFINED, quotient(by_weight, mass * abs(g) * abs(k3)))
    v['klein_IY'] = np.where(small, UNDEFINED, quotient(by_inertia, mass * abs(one.a[2]) * abs(k3)))
    v['klein_FT'] = (w * w * by_inertia - by_weight) / r
    v.update(Fs_primary=m.reciprocating * r * w ** 2 * s.e[1].real, Fs_secondary=side * m.reciprocating * r * w ** 2 * (s.e[1] ** 2).real / n)
    # F along +x, with the mass m_b of the rod at the pin C and m_a at the pin B
    b = l - z.real
    m_a, m_b = mass * b / l, mass * (l - b) / l
    approximation = m.deck.word('', 'series', 'none').lower()
    a = -side * (v['a'] if approximation == 'none' else series['a'])
    alpha3 = series['alpha3'] if approximation == 'all' else v['alpha3']
    P = -side * m.gas(s.theta2) if m.gas else 0 * w
    v['gas_force'] = -side * P
    v['inertia_force'] = side * (m.masses[3][0] + m_b) * a
    force = sum((np.real(load.values(s)[0]) for load in m.loads if load.body == 3), P)
    F = -side * (force + (m.masses[3][0] + m_b) * (g.real - a))
    cos_phi, excess = side * s.e[2].real, mass * b * (l - b) - inertia
    v.update(piston_effort=F, rod_force=F / cos_phi, side_thrust=-F * s.e[2].imag / cos_phi, crank_effort=-F * cross(s.e[1], s.e[2]) / cos_phi,
             radial_force=F * turned(s.e[1], s.e[2]) / cos_phi, correction_couple=-excess * alpha3,
             correction_force=-side * excess * alpha3 / (l * cos_phi), T_correction=excess * alpha3 * k3,
             T_weight_a=m_a * turned(g + 0 * k3, one.velocity(1, r)), T_weight_b=m_b * turned(g + 0 * k3, one.velocity(3, 0)), T_inertia_a=-m_a * r * r * al)
    v['T_piston'] = v['crank_effort'] * r
    v['T_engine'] = v['T_piston'] + v['T_correction'] + v['T_weight_a'] + v['T_inertia_a']
