# SPDX-License-Identifier: GPL-3.0-or-later
#
# facts.py - the facts of a deck by dense search over all crank angles: name -> list of values, for each branch.
import numpy as np

from chain import REAL
from columns import columns
from machine import CHANGE, DEAD, OK, PI, TURN
from motion import COEFFICIENTS, NODES, UP_TO, WEIGHTS, integrals, peak

ROWS = 2880


def sought(m, label, name, sign, reach):
    """The largest (sign 1) or smallest value of a column over the crank angles that can be reached, and where."""
    def f(theta2):
        s = m.state(theta2, 1, 0, label)
        full = np.full(len(theta2), -np.inf, REAL)
        full[s.which] = sign * columns(m, s, False)[0][name]
        if name == 'theta4':  # one that does not turn fully
            full[s.which] = sign * ((s.phi[3] - centre + PI) % TURN)
        return full
    best = -np.inf, 0
    for low, high in reach:
        inside = 1e-13 if high - low < TURN * (1 - 1e-9) else 0
        grid = low + inside + (high - low - 2 * inside) * np.arange(ROWS + 1, dtype=REAL) / ROWS
        if name == 'theta4':
            s = m.state(grid, 1, 0, label)
            centre = np.angle(np.exp(1j * s.phi[3]).sum())
        best = max(best, peak(f, grid, True))
    return (sign * best[0] + (centre - PI if name == 'theta4' else 0), best[1])


def of_link_4(m):
    """The stretches of angles that link 4 can have: those at which the crank and the coupler reach its end C."""
    def there(angle):
        f = abs(m.d + m.c * np.exp(1j * angle))
        return (f >= abs(m.a - m.b)) & (f <= m.a + m.b)
    return stretches(there)


def stretches(there):
    """Of an angle, where a condition holds: from 0 to 360 deg, or between angles, of which the first may be below 0."""
    grid = np.arange(ROWS, dtype=REAL) * TURN / ROWS + 1e-9
    ok = there(grid)
    if ok.all():
        return [(REAL(0), TURN)]
    starts, stops = [], []
    for k in np.nonzero(ok != np.roll(ok, 1))[0]:
        good, bad = (grid[k], grid[k] - TURN / ROWS) if ok[k] else (grid[k] - TURN / ROWS, grid[k])
        for _ in range(60):
            middle = (good + bad) / 2
            good, bad = (middle, bad) if there(np.array([middle]))[0] else (good, middle)
        (starts if ok[k] else stops).append(good)
    return [(x, min(y + TURN * (y < x) for y in stops)) for x in starts]


def of_geometry(m):
    """The same on both branches."""
    found = {'theta2_from': [], 'theta2_to': []}
    for low, high in stretches(lambda theta2: np.isin(m.state(theta2, 1, 0, 1).status, (OK, DEAD, CHANGE))):
        found['theta2_from'].append(low)
        found['theta2_to'].append(high)
    if m.kind == 'four-bar':
        found['K'] = [(m.a ** 2 - m.b ** 2 + m.c ** 2 + m.d ** 2) / 2]
        for low, high in [x for x in of_link_4(m) if x[1] - x[0] < TURN * (1 - 1e-12)]:
            for name, value in (('theta4_from', low), ('theta4_to', high), ('theta4_swing', high - low)):
                found.setdefault(name, []).append(value)
    if m.kind == 'slider-crank':
        (mass, inertia, z), l = m.masses[2], m.b
        found['n'] = [l / m.a]
        if mass and abs(z.imag) < 1e-12 * l:
            b = l - z.real
            k2 = inertia / mass
            found.update(k=[np.sqrt(k2)], m_a=[mass * b / l], m_b=[mass * (l - b) / l])
            if b * (l - b) > 0:
                found['k1'] = [np.sqrt(b * (l - b))]
            if b:
                L = b + k2 / b
                found.update(L=[L], d=[k2 / b], m_d=[mass * b / L], m_g=[mass * k2 / b / L])
    for link, (U, mass) in m.counterweights.items():
        found['balance_' + link], found['balance_%s_angle' % link] = [abs(U)], [np.angle(U)]
        found['balance_mass' if link == 'crank' else 'balance_rocker_mass'] = [mass]
    return found


def of_branch(m, label):
    """Limits of a branch over all crank angles."""
    reach = stretches(lambda theta2: np.isin(m.state(theta2, 1, 0, label).status, (OK, DEAD, CHANGE)))
    found = {}
    full = len(reach) == 1 and reach[0][1] - reach[0][0] > TURN * (1 - 1e-9) and not m.changes
    for name in ['mu'] + ['gamma'] * (m.kind == 'four-bar') + ['slide'] * (m.kind == 'scotch-yoke'):
        for end, sign in (('_min', -1), ('_max', 1)):
            value = sought(m, label, name, sign, reach)[0]
            found[name + end] = REAL(round(value / PI)) * PI if not full and abs(value - round(value / PI) * PI) < 1e-5 and name != 'slide' else value
    if m.changes and m.kind != 'inverted-slider-crank' or not full and m.kind != 'inverted-slider-crank':
        found['mu_min'] = 0
    if m.slides and full:
        (high, outer), (low, inner) = sought(m, label, 'x', 1, reach), sought(m, label, 'x', -1, reach)
        if m.gas:
            swept, clearance = m.bore_area * (high - low), m.clearance_volume()
            found.update(displacement=swept, **({'compression_ratio': (clearance + swept) / clearance} if clearance else {}))
        found.update(stroke=high - low, inner_dead_centre=inner, outer_dead_centre=outer)
        way = (outer - inner) % TURN
    elif m.pinned and full and (m.kind == 'four-bar' and m.a + max(m.b, m.c, m.d) <= (m.a + m.b + m.c + m.d) / 2 and m.a < min(m.b, m.c, m.d)
                                or m.slot and m.a < m.d):
        (high, last), (low, first) = sought(m, label, 'theta4', 1, reach), sought(m, label, 'theta4', -1, reach)
        found.update(theta4_min=low, theta4_max=high, swing=high - low)
        way = (last - first) % TURN
    elif m.slot and m.pinned and full:  # a tool whose line of stroke passes D at right angles to AD
        angles = np.sort([x for pair in stretches(lambda theta2: m.state(theta2, 1, 0, label).e[2].real > 0) for x in pair])
        way = angles[1] - angles[0]
    else:
        return found
    way = min(way, TURN - way)
    if m.kind != 'scotch-yoke':
        found['time_ratio'] = (TURN - way) / way
    return found


def turning(m, label, omega, inertia, motor=None):
    """The turning moment -Ts at a constant speed over the cycle."""
    cuts = np.unique(np.concatenate(([0, m.cycle], m.corners(label, 0, m.cycle), np.arange(0, m.cycle, float(TURN) / 180)))).astype(REAL)
    a, b = cuts[:-1, None], cuts[1:, None]
    s = m.state((a + (b - a) * NODES).ravel(), omega, 0, label)
    if not s.which.all() or m.forces(s).locked.any():
        return {}
    T, T0 = (-np.array([-x[-1]]).reshape(len(a), -1) for x in (s.x, s.x0))
    work = ((b - a) * T) @ WEIGHTS
    mean, without = work.sum() / m.cycle, (((b - a) * T0) @ WEIGHTS).sum() / m.cycle
    taken = np.concatenate(([0], np.cumsum(work - mean * (b - a)[:, 0])))
    within = taken[:-1, None] + (b - a) * ((T - mean) @ UP_TO.T)  # at the nodes
    energy = np.concatenate((within.ravel(), taken))
    for sign in (1, -1):  # where T crosses its mean
        k, j = np.divmod(int(np.argmax(sign * within)), len(NODES))
        f = np.linspace(0, 1, 4001)
        energy = np.append(energy, taken[k] + (b - a)[k] * (integrals(f) @ COEFFICIENTS @ (T[k] - mean)))
    found = {'mean_torque': mean, 'mean_power': mean * omega, 'energy_fluctuation': energy.max() - energy.min()}
    found['energy_coefficient'] = found['energy_fluctuation'] / abs(mean * m.cycle) if mean else 0
    if m.gas and m.slides and m.card:
        power = m.bore_area * m.pressure(s.theta2) * m.variable(s, 'v')
        found['indicated_work'] = (((b - a) * power.reshape(len(a), -1)) @ WEIGHTS).sum() / abs(omega)
        found['indicated_power'] = found['indicated_work'] * abs(omega) / m.cycle
    own, wanted = m.deck.number('flywheel', 'inertia', 'inertia'), m.deck.number('flywheel', 'fluctuation', 'number')
    if inertia:
        found['flywheel_fluctuation'] = found['energy_fluctuation'] / (inertia * omega ** 2)
        found['flywheel_inertia'] = own
    elif wanted:
        found['flywheel_inertia'], found['flywheel_fluctuation'] = found['energy_fluctuation'] / (wanted * omega ** 2), wanted
    with_, without_ = (-x * np.sign(omega) for x in (mean, without))
    found['efficiency_cycle'] = (without_ / with_ if without_ > 0 else 0) if with_ > 0 else (with_ / without_ if without_ < 0 else 0)
    return found
