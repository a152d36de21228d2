# SPDX-License-Identifier: GPL-3.0-or-later
#
# random_decks.py N FOLDER [motors [FIRST]] - writes N decks of all kinds, with loads, springs, friction and motors, each
# with its own seed: random-0.deck, random-1.deck ...  With "motors" all have a motion that is not given: motors-FIRST.deck ...
import os
import random
import sys

KINDS = ('four-bar', 'slider-crank', 'inverted-slider-crank', 'scotch-yoke')


class Maker:
    def __init__(self, seed):
        self.r = random.Random(seed)
        self.kind = KINDS[3] if seed % 4 == 3 else KINDS[seed % 3]
        self.lines = []

    def between(self, low, high):
        return '%.6g' % self.r.uniform(low, high)

    def chance(self, share):
        return self.r.random() < share

    def put(self, *lines):
        self.lines += lines

    def body(self, size):
        self.put('mass = %s kg' % self.between(0.1, 3), 'cg = %s mm at %s deg' % (self.between(0, size), self.between(-20, 20)),
                 'gyration = %s mm' % self.between(5, size))

    def mechanism(self):
        self.put('mechanism = ' + self.kind)
        crank = self.r.uniform(10, 60)
        self.put('[crank]', 'length = %.6g mm' % crank)
        self.body(crank)
        if self.kind == 'four-bar':
            for section in ('coupler', 'rocker'):
                self.put('[%s]' % section, 'length = %s mm' % self.between(50, 140))
                self.body(50)
            self.put('[ground]', 'length = %s mm' % self.between(50, 120))
        elif self.kind == 'slider-crank':
            self.put('[rod]', 'length = %s mm' % self.between(90, 250))
            self.body(80)
            self.put('[piston]', 'mass = %s kg' % self.between(0.1, 3), '[ground]', 'offset = %s mm' % self.between(-10, 10))
        elif self.kind == 'scotch-yoke':
            self.put('[ground]', 'offset = %s mm' % self.between(-30, 30), '[slider]')
            self.body(10)
            self.put('[yoke]')
            if self.chance(0.6):
                self.put('angle = %s deg' % self.between(40, 140))
            self.body(100)
        else:
            self.put('[ground]', 'length = %s mm' % self.between(70, 150), '[slider]')
            self.body(30)
            self.put('[lever]', 'offset = %s mm' % self.between(-5, 5))
            self.body(100)

    def links(self):
        return {'four-bar': ('crank', 'coupler', 'rocker'), 'slider-crank': ('crank', 'rod', 'piston'),
                'inverted-slider-crank': ('crank', 'slider', 'lever'), 'scotch-yoke': ('crank', 'slider', 'yoke')}[self.kind]

    def load(self, name):
        link = self.r.choice(self.links())
        self.put('[load %s]' % name, 'link = ' + link)
        if link in ('piston', 'yoke'):
            self.put('force = %s N' % self.between(-300, 300))
        elif self.chance(0.5):
            self.put('torque = %s N m' % self.between(-10, 10))
        else:
            self.put('force = (%s, %s) N' % (self.between(-200, 200), self.between(-200, 200)),
                     'at = (%s, %s) mm' % (self.between(0, 60), self.between(-20, 20)))
        if self.chance(0.3):
            begin = self.r.randrange(0, 300)
            self.put('from = %d deg' % begin, 'to = %d deg' % (begin + self.r.randrange(20, 60)))

    def spring(self):
        link = self.links()[2]
        self.put('[spring S]', 'link = ' + link, 'to = ground')
        if link in ('piston', 'yoke') or self.chance(0.5):
            self.put('at = (%s, 0) mm' % self.between(0, 1 if link == 'piston' else 60),
                     'to_at = (%s, %s) mm' % (self.between(100, 250), self.between(100, 250)),
                     'stiffness = %s N/m' % self.between(10, 3000), 'free_length = %s mm' % self.between(50, 200))
        else:
            self.put('stiffness = %s N m/rad' % self.between(0.1, 20))
        if self.chance(0.4):
            self.put('damping = %s N m s/rad' % self.between(0.001, 0.1) if self.lines[-1].endswith('rad')
                     else 'damping = %s N s/m' % self.between(0.1, 20))

    def friction(self):
        self.put('[friction]')
        for pin in {'inverted-slider-crank': 'ABD', 'scotch-yoke': 'AB'}.get(self.kind, 'ABC'):
            self.put('%s = %s' % (pin, self.between(0.02, 0.15)), 'radius_%s = %s mm' % (pin, self.between(2, 8)))
        if self.kind != 'four-bar':
            self.put('guide = %s' % self.between(0.02, 0.15))
        if self.kind == 'scotch-yoke':
            self.put('slot = %s' % self.between(0.02, 0.15))
            if self.chance(0.5):
                self.put('slot_length = %s mm' % self.between(10, 40))

    def motion(self):
        if self.chance(0.25):
            self.put('[motor]', 'stall_torque = %s N m' % self.between(40, 200), 'no_load_speed = %s rad/s' % self.between(10, 60),
                     '[flywheel]', 'inertia = %s kg m2' % self.between(0.3, 3), '[motion]',
                     'mode = ' + self.r.choice(('run-up', 'steady', 'free')))
            mode = self.lines[-1].split()[-1]
            self.put('turns = %d' % (1 if mode == 'steady' else 2))
            if mode == 'free':
                self.put('speed = %s rad/s' % self.between(5, 30))
        else:
            self.put('[motion]', 'speed = %s rad/s' % self.between(-30, 30))
            if self.chance(0.3):
                self.put('acceleration = %s rad/s2' % self.between(-5, 40), 'hold = yes')
        self.put('interval = 10 deg')

    def deck(self):
        self.mechanism()
        for name in 'LMN'[:self.r.randrange(3)]:
            self.load(name)
        if self.chance(0.3):
            self.spring()
        if self.chance(0.3):
            self.friction()
        self.motion()
        return '\n'.join(self.lines) + '\n'


class MotorMaker(Maker):
    """Machines whose motion is not given: free, from rest and steady, with motors of each sort, loads over angles,
    positions and speeds, gas, springs, dampers and friction; one branch."""

    def __init__(self, seed):
        super().__init__(seed)
        self.sense = -1 if self.chance(0.3) else 1
        self.mode = self.r.choice(('free', 'run-up', 'steady'))
        self.speed = 10 ** self.r.uniform(0.6, 2.1)
        self.torque = 10 ** self.r.uniform(0.3, 2.2)
        self.has_friction = self.chance(0.3)
        self.by_time = self.mode != 'steady' and not self.has_friction and self.chance(0.2)
        self.from_ = 5 * self.r.randrange(-20, 60) if self.chance(0.5) else 0

    def mechanism(self):
        """One that can be assembled."""
        super().mechanism()
        lengths = [float(line.split()[2]) for line in self.lines if line.startswith('length')]
        if self.kind == 'four-bar' and 2 * max(lengths) >= sum(lengths):
            self.lines = []
            self.mechanism()

    def size(self):
        return '%.6g' % (10 ** self.r.uniform(-1, 2) * self.r.choice((-1, 1)))

    def points(self, unit, low, high, n):
        """A curve: points whose arguments rise."""
        at = sorted(self.r.uniform(low, high) for _ in range(n))
        return ', '.join('%.6g %s %s %s' % (x, unit, self.size(), self.unit) for x in at)

    def on(self, link):
        """What acts on a link, a force or a torque; sets its unit."""
        self.unit = 'N' if link in ('piston', 'yoke') else 'N m'
        return 'force' if link in ('piston', 'yoke') else 'torque'

    def load_over_angle(self, name):
        link = self.r.choice(self.links())
        key = self.on(link)
        at = sorted(self.r.sample(range(0, 360, 5), self.r.randrange(3, 8)))
        self.put('[load %s]' % name, 'link = ' + link,
                 key + ' = ' + ', '.join('%d deg %s %s' % (x, self.size(), self.unit) for x in at))

    def load_over_speed(self, name):
        link, over, unit = self.r.choice([('crank', 'omega2', 'rad/s')] + {
            'four-bar': [('rocker', 'omega4', 'rad/s')], 'slider-crank': [('piston', 'v', 'm/s')],
            'inverted-slider-crank': [('lever', 'omega4', 'rad/s'), ('lever', 'slide_v', 'm/s')],
            'scotch-yoke': [('yoke', 'v', 'm/s'), ('yoke', 'slide_v', 'm/s')]}[self.kind])
        key = self.on(link)
        reach = self.speed * (0.05 if unit == 'm/s' else 1)
        self.put('[load %s]' % name, 'link = ' + link, 'over = ' + over)
        if self.chance(0.7):
            self.put('%s = -%.6g %s' % (key, 10 ** self.r.uniform(-1, 1.5), self.unit), 'at_speed = %.6g %s' % (reach, unit),
                     'exponent = ' + self.r.choice(('1', '1.5', '2', '3')))
        else:
            self.put('%s = %s' % (key, self.points(unit, -reach, reach, self.r.randrange(2, 6))))

    def load_over_position(self, name):
        link, over, unit, low, high = {
            'four-bar': ('rocker', 'theta4', 'deg', 0, 360), 'slider-crank': ('piston', 'x', 'mm', 0, 120),
            'inverted-slider-crank': self.r.choice((('lever', 'theta4', 'deg', 0, 360), ('lever', 'slide', 'mm', 10, 200))),
            'scotch-yoke': self.r.choice((('yoke', 'x', 'mm', 0, 120), ('yoke', 'slide', 'mm', -50, 50)))}[self.kind]
        key = self.on(link)
        self.put('[load %s]' % name, 'link = ' + link, 'over = ' + over,
                 '%s = %s' % (key, self.points(unit, low, high, self.r.randrange(3, 6))))
        if self.chance(0.5):
            self.put('back = %s %s' % (self.size(), self.unit))

    def gas(self):
        at = sorted(self.r.sample(range(0, 360, 5), self.r.randrange(3, 8)))
        self.put('[gas]', 'bore = %s mm' % self.between(10, 40),
                 'indicator = ' + ', '.join('%d deg %s bar' % (x, self.between(0, 20)) for x in at))

    def loads(self):
        for name in 'KLMN'[:self.r.randrange(5)]:
            self.r.choice((self.load, self.load, self.load_over_angle, self.load_over_speed, self.load_over_position))(name)
        if self.kind in ('slider-crank', 'scotch-yoke') and self.chance(0.2):
            self.gas()
        if self.chance(0.3):
            self.spring()
        if self.chance(0.2):
            self.put('[spring D]', 'link = crank', 'to = ground', 'damping = %.6g N m s/rad' % 10 ** self.r.uniform(-3, 0.5))
        if self.has_friction:
            self.friction()
            if self.kind != 'four-bar' and self.chance(0.5):
                self.put('guide_length = %s mm' % self.between(30, 80))

    def motor(self):
        """A motor that drives in the sense of the range, some with a gear; returns its key."""
        sort = self.r.choice(('torque', 'stall_torque', 'curve', 'power') + (('constant', 'constant') if self.mode == 'steady' else ()))
        ratio = 1 if self.chance(0.6) else self.r.choice((-1, 1)) * 10 ** self.r.uniform(-0.5, 1)
        sign = self.sense * (-1 if ratio < 0 else 1)
        T, w = sign * self.torque / abs(ratio), sign * self.speed * abs(ratio)
        self.put('[motor]')
        if sort == 'constant':
            self.put('torque = constant')
        elif sort == 'torque':
            self.put('torque = %.6g N m' % T)
        elif sort == 'stall_torque':
            self.put('stall_torque = %.6g N m' % T, 'no_load_speed = %.6g rad/s' % w)
        elif sort == 'power':
            self.put('power = %.6g W' % (T * w / 4), 'max_torque = %.6g N m' % T)
        else:
            points = [(0, T), (0.4 * w, T * self.r.uniform(0.6, 1.2)), (0.8 * w, T * self.r.uniform(0.8, 1.8)), (w, 0)]
            points += [(1.2 * w, -T * self.r.uniform(0.5, 1.5))] if self.chance(0.5) else []
            self.put('curve = ' + ', '.join('%.6g rad/s %.6g N m' % point for point in sorted(points)))
        if self.chance(0.4):
            self.put('inertia = %.6g kg m2' % (10 ** self.r.uniform(-3, 0) / ratio ** 2))
        if ratio != 1:
            self.put('ratio = %.6g' % ratio)
        return sort

    def motion(self):
        sort = self.motor() if self.mode != 'free' or self.chance(0.6) else None
        wanted = sort == 'constant' and self.chance(0.3)
        if wanted:
            self.put('[flywheel]', 'fluctuation = %.6g' % 10 ** self.r.uniform(-2, 0), 'exact = yes')
        elif self.chance(0.8):
            self.put('[flywheel]', 'inertia = %.6g kg m2' % 10 ** self.r.uniform(-2.5, 0.5))
        self.put('[motion]', 'mode = ' + self.mode, 'from = %d deg' % self.from_)
        if self.mode == 'free':
            self.put('speed = %.6g rad/s' % (self.sense * self.speed * self.r.uniform(0.3, 1.5)))
        if sort == 'constant':
            self.put('mean_speed = %.6g rad/s' % (self.sense * self.speed))
        if self.by_time:
            self.put('rows = time', 'duration = %.6g s' % (10 / self.speed), 'time_step = %.6g s' % (0.2 / self.speed))
        else:
            self.put('turns = %.6g' % (self.sense * (1 if self.mode == 'steady' else self.r.choice((0.5, 1, 2, 3)))),
                     'interval = %d deg' % self.r.choice((7, 10, 15)))
        self.put('[table]', 'branch = ' + ('open' if self.kind == 'scotch-yoke' else self.r.choice(('open', 'crossed'))))

    def deck(self):
        self.mechanism()
        self.loads()
        self.motion()
        return '\n'.join(self.lines) + '\n'


def main(n, folder, sort='random', first=0):
    make = {'random': Maker, 'motors': MotorMaker}[sort]
    os.makedirs(folder, exist_ok=True)
    for seed in range(int(first), int(first) + int(n)):
        with open(os.path.join(folder, '%s-%d.deck' % (sort, seed)), 'w', encoding='utf-8') as out:
            out.write(make(seed).deck())


if __name__ == '__main__':
    main(*sys.argv[1:])
