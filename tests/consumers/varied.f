C     SPDX-License-Identifier: GPL-3.0-or-later
C
C     varied.f - a deck in, the largest torque for several cranks out,
C     in FORTRAN 77: the deck is read once.
C
      PROGRAM VARIED
      INCLUDE 'fourlink.inc'
      INTEGER*8 HANDLE
      INTEGER ISTAT, I, IDS(1), N
      DOUBLE PRECISION LENGTH(1), VALUE
      CHARACTER TEXT*10000, LINE*100, MSG*80, UNIT*16

      TEXT = ' '
      N = 1
   10 READ (*, '(A)', END=20) LINE
         TEXT(N:N+100) = LINE // CHAR(10)
         N = N + 101
      GOTO 10
   20 CALL FLOPEN(TEXT, HANDLE, ISTAT, MSG)
      IF (ISTAT .NE. 0) WRITE (*, '(A)') MSG
      CALL FLFIND(HANDLE, 'crank.length', IDS(1), ISTAT)
      CALL FLUNIT(HANDLE, 'crank.length', UNIT, ISTAT)
      DO 30 I = 0, 2
         LENGTH(1) = 18.0D0 + 2.0D0 * I
         CALL FLPUT(HANDLE, 1, IDS, LENGTH, ISTAT, MSG)
         CALL FLVAL(HANDLE, 'max(Ts)', FOURLINK_OPEN, 0.0D0, VALUE,
     &      ISTAT)
         IF (ISTAT .EQ. FOURLINK_OK)
     &      WRITE (*, '(I2, 1X, A, A, F11.9, A)') NINT(LENGTH(1)),
     &         UNIT(:LNBLNK(UNIT)), ': max(Ts) = ', VALUE, ' N.m'
   30 CONTINUE
      CALL FLSET(HANDLE, 'crank.length', -1.0D0, ISTAT, MSG)
      IF (ISTAT .NE. 0) WRITE (*, '(A)')
     &   MSG(INDEX(MSG, ':') + 2:LNBLNK(MSG))
      CALL FLSHUT(HANDLE)
      END
