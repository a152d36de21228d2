# SPDX-License-Identifier: GPL-3.0-or-later
#
# random_decks.py N FOLDER - writes N decks of all kinds, with loads, springs, friction, gas, counterweights and motors, each
# with its own seed: random-0.deck, random-1.deck ...
import os
import random
import sys

KINDS = ('four-bar', 'slider-crank', 'inverted-slider-crank')


class Maker:
    def __init__(self, seed):
        self.r = random.Random(seed)
        self.kind = KINDS[seed % 3]
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
        else:
            self.put('[ground]', 'length = %s mm' % self.between(70, 150), '[slider]')
            self.body(30)
            self.put('[lever]', 'offset = %s mm' % self.between(-5, 5))
            self.body(100)

    def links(self):
        return {'four-bar': ('crank', 'coupler', 'rocker'), 'slider-crank': ('crank', 'rod', 'piston'),
                'inverted-slider-crank': ('crank', 'slider', 'lever')}[self.kind]

    def load(self, name):
        link = self.r.choice(self.links())
        self.put('[load %s]' % name, 'link = ' + link)
        if link == 'piston':
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
        if link == 'piston' or self.chance(0.5):
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
        for pin in 'ABD' if self.kind == 'inverted-slider-crank' else 'ABC':
            self.put('%s = %s' % (pin, self.between(0.02, 0.15)), 'radius_%s = %s mm' % (pin, self.between(2, 8)))
        if self.kind != 'four-bar':
            self.put('guide = %s' % self.between(0.02, 0.15))

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


def main(n, folder):
    os.makedirs(folder, exist_ok=True)
    for seed in range(int(n)):
        with open(os.path.join(folder, 'random-%d.deck' % seed), 'w', encoding='utf-8') as out:
            out.write(Maker(seed).deck())


if __name__ == '__main__':
    main(*sys.argv[1:])
