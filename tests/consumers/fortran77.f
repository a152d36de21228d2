C     SPDX-License-Identifier: GPL-3.0-or-later
C
C     fortran77.f - a whole crank position in one call, from FORTRAN 77:
C     the linkage of data/me3491-matrix.deck at 40 deg, the engine of
C     data/me3491-example-1.deck, a lever with its slide at an angle,
C     and mistakes.
C
      PROGRAM CONSUM
      DOUBLE PRECISION LINKS(5,4), GRAV(2), CRANK(3), LOADS(7,1)
      DOUBLE PRECISION STATE(9,4), SLIDE(4), FORCES(10)
      DOUBLE PRECISION FRCYOK(11), PI, RADIAN
      INTEGER NLOADS, ISTAT, I, J
      CHARACTER*80 TEXT

      PI = 4 * ATAN(1.0D0)
      RADIAN = PI / 180
      DO 20 J = 1, 4
         DO 10 I = 1, 5
            LINKS(I,J) = 0
   10    CONTINUE
   20 CONTINUE
      DO 30 I = 1, 7
         LOADS(I,1) = 0
   30 CONTINUE

C     The four-bar linkage, with a load torque on the rocker.
      LINKS(1,1) = 0.080D0
      CALL SETLNK(LINKS(1,2), 0.020D0, 0.10D0, 0.008D0, 0.010D0, 0.0D0)
      CALL SETLNK(LINKS(1,3), 0.066D0, 0.30D0, 0.025D0, 0.030D0,
     &            10 * RADIAN)
      CALL SETLNK(LINKS(1,4), 0.056D0, 0.25D0, 0.020D0, 0.028D0,
     &            -5 * RADIAN)
      GRAV(1) = 0
      GRAV(2) = -9.81D0
      CRANK(1) = 40 * RADIAN
      CRANK(2) = 10.5D0
      CRANK(3) = 0
      NLOADS = 1
      LOADS(1,1) = 4
      LOADS(7,1) = 0.5D0
      CALL FLFBAR(LINKS, GRAV, 1, CRANK, NLOADS, LOADS, STATE, FORCES,
     &            ISTAT)
      CALL CHECK(ISTAT, 0)
      WRITE (*, '(A, F10.6, A)') 'theta4 = ', STATE(1,4) / RADIAN,
     &                           ' deg'
      WRITE (*, '(A, F14.12, A)') 'Ts = ', FORCES(10), ' N m'

C     The engine, with the force of the gas on the piston.
      LINKS(1,1) = 0
      CALL SETLNK(LINKS(1,2), 0.150D0, 0.0D0, 0.0D0, 0.0D0, 0.0D0)
      CALL SETLNK(LINKS(1,3), 0.450D0, 2.0D0, 0.175D0, 0.150D0, 0.0D0)
      CALL SETLNK(LINKS(1,4), 0.0D0, 2.5D0, 0.0D0, 0.0D0, 0.0D0)
      CRANK(2) = 1000 * PI / 30
      LOADS(3,1) = -2.0D6 * PI / 4 * 0.115D0**2
      LOADS(7,1) = 0
      CALL FLSLCR(LINKS, 0.0D0, GRAV, 1, CRANK, NLOADS, LOADS, STATE,
     &            FORCES, ISTAT)
      CALL CHECK(ISTAT, 0)
      IF (ABS(FORCES(10) + 1979.2760424146D0) .GT. 1D-8) STOP 3
      WRITE (*, '(A, F12.6, A)') 'a4 = ', STATE(8,4), ' m/s2'

C     An inverted slider-crank, its slide at 60 deg to the lever, with
C     values of an independent solver.
      LINKS(1,1) = 0.2D0
      CALL SETLNK(LINKS(1,2), 0.08D0, 0.1D0, 0.0D0, 0.04D0, 0.0D0)
      CALL SETLNK(LINKS(1,3), 0.0D0, 0.3D0, 0.0D0, -0.15D0, 0.0D0)
      CALL SETLNK(LINKS(1,4), 0.13D0, 0.15D0, 0.0D0, 0.065D0, 0.0D0)
      LINKS(5,3) = 0.01D0
      LINKS(3,2) = 0.0004D0
      LINKS(3,3) = 0.001D0
      LINKS(3,4) = 0.0007D0
      CRANK(1) = 110 * RADIAN
      CRANK(2) = 10
      CRANK(3) = -40
      LOADS(1,1) = 3
      LOADS(3,1) = 0
      LOADS(4,1) = -100
      LOADS(5,1) = -0.35D0
      CALL FLINVS(LINKS, 0.0D0, 60 * RADIAN, GRAV, 1, CRANK, NLOADS,
     &            LOADS, STATE, SLIDE, FORCES, ISTAT)
      CALL CHECK(ISTAT, 0)
      IF (ABS(STATE(1,3) - 3.311715631002D0 + 2 * PI) .GT. 1D-9) STOP 4
      IF (ABS(STATE(1,4) - 2.264518079806D0) .GT. 1D-9) STOP 4
      IF (ABS(STATE(3,4) - 29.77525504049D0) .GT. 1D-8) STOP 4
      IF (ABS(SLIDE(1) - 0.1463519448371D0) .GT. 1D-9) STOP 5
      IF (ABS(SLIDE(2) - 0.7113765593292D0) .GT. 1D-9) STOP 5
      IF (ABS(SLIDE(3) + 7.829083934205D0) .GT. 1D-8) STOP 5
      IF (ABS(SLIDE(4) - 0.9585339217869D0) .GT. 1D-9) STOP 5
      IF (ABS(FORCES(9) + 34.85154695049D0) .GT. 1D-8) STOP 6
      IF (ABS(FORCES(10) + 0.6072639458676D0) .GT. 1D-8) STOP 6
      WRITE (*, '(A, F9.6, A)') 'slide = ', SLIDE(1), ' m'
      SLIDE(1) = 7
      CALL FLINVS(LINKS, 0.0D0, 60 * RADIAN, GRAV, 2, CRANK, NLOADS,
     &            LOADS, STATE, SLIDE, FORCES, ISTAT)
      IF (ISTAT .EQ. 0) STOP 7
      IF (NINT(SLIDE(1)) .NE. 7) STOP 7

C     A Scotch yoke at 90 deg: F = 400 N along the guide, a = 60 mm.
      LINKS(1,2) = 0.06D0
      LINKS(2,2) = 0
      LINKS(2,3) = 0
      LINKS(2,4) = 0
      CRANK(1) = 40 * RADIAN
      CRANK(3) = 0
      LOADS(1,1) = 4
      LOADS(3,1) = -400
      LOADS(4,1) = 0
      CALL FLYOKE(LINKS, 0.0D0, 90 * RADIAN, GRAV, CRANK, NLOADS, LOADS,
     &            STATE, SLIDE, FRCYOK, ISTAT)
      CALL CHECK(ISTAT, 0)
      IF (ABS(STATE(4,4) - 0.06D0 * COS(40 * RADIAN)) .GT. 1D-9) STOP 8
      IF (ABS(SLIDE(1) - 0.06D0 * SIN(40 * RADIAN)) .GT. 1D-9) STOP 8
      IF (ABS(FRCYOK(10) + 24 * SIN(40 * RADIAN)) .GT. 1D-8) STOP 9

C     A length that is none: the outputs are as they were.
      LINKS(1,2) = -1
      STATE(1,4) = 7
      FORCES(10) = 7
      CALL FLFBAR(LINKS, GRAV, 1, CRANK, NLOADS, LOADS, STATE, FORCES,
     &            ISTAT)
      CALL CHECK(ISTAT, 23)
      IF (NINT(STATE(1,4)) .NE. 7) STOP 2
      IF (NINT(FORCES(10)) .NE. 7) STOP 2
      CALL FLTEXT(ISTAT, TEXT)
      WRITE (*, '(A)') TEXT(1:24)
      END

C     A link with its centre of mass at the distance R, under ANGLE.
      SUBROUTINE SETLNK(LINK, LENGTH, MASS, GYR, R, ANGLE)
      DOUBLE PRECISION LINK(5), LENGTH, MASS, GYR, R, ANGLE
      LINK(1) = LENGTH
      LINK(2) = MASS
      LINK(3) = MASS * GYR**2
      LINK(4) = R * COS(ANGLE)
      LINK(5) = R * SIN(ANGLE)
      END

C     A status other than the one expected: its text, and the end.
      SUBROUTINE CHECK(ISTAT, IEXPCT)
      INTEGER ISTAT, IEXPCT
      CHARACTER*80 TEXT
      IF (ISTAT .EQ. IEXPCT) RETURN
      CALL FLTEXT(ISTAT, TEXT)
      WRITE (*, '(A)') TEXT
      STOP 1
      END
