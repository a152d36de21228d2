C     SPDX-License-Identifier: GPL-3.0-or-later
C
C     results.f - a deck in, named numbers out, in FORTRAN 77: min(Ts)
C     by its handle, the others by name.
C
      PROGRAM NAMED
      INTEGER*8 HANDLE
      INTEGER ISTAT, I, ID, N
      DOUBLE PRECISION VALUE
      CHARACTER TEXT*10000, LINE*100, MSG*80, NAMES(4)*7, UNITS(4)*3
      DATA NAMES /'theta4', 'Ts', 'min(Ts)', 'mu_min'/
      DATA UNITS /'deg', 'N.m', 'N.m', 'deg'/

      TEXT = ' '
      N = 1
   10 READ (*, '(A)', END=20) LINE
         TEXT(N:N+100) = LINE // CHAR(10)
         N = N + 101
      GOTO 10
   20 CALL FLOPEN(TEXT, HANDLE, ISTAT, MSG)
      IF (ISTAT .NE. 0) WRITE (*, '(A)') MSG
      DO 30 I = 1, 4
         IF (I .EQ. 3) THEN
            CALL FLFIND(HANDLE, 'Ts', ID, ISTAT)
            CALL FLGET(HANDLE, ID + 2, 1, 40.0D0, VALUE, ISTAT)
         ELSE
            CALL FLVAL(HANDLE, NAMES(I), 1, 40.0D0, VALUE, ISTAT)
         END IF
         IF (ISTAT .EQ. 0) WRITE (*, '(2A, F15.9, 2A)')
     &      NAMES(I), ' =', VALUE, ' ', UNITS(I)
   30 CONTINUE
      CALL FLSHUT(HANDLE)
      END
