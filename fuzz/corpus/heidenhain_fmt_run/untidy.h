0  BEGIN PGM test MM 
1  BLK FORM 0.1 Z  X-200  Y-100  Z-30
2 blk form 0.2 x200 Y+100 Z0 ; the  Blank 
/3 TOOL CALL 1 Z S800 DL+0,1 dr2 0.5
 4 l x10y-5.5 r0 F MAX m3 ;go
4 L X 10 +5
5 CR X+1 R20 DR+ F AUTO
6 cycl def 200 Bohren ~
 Q200=2 ;SICHERHEITS-ABST. ~
      Q201 = -20;TIEFE
7 CYCL DEF 7.0 NULLPUNKT
8 CYCL DEF 7.1   IX10
9 q1=-(Q2+5,5)*SIN Q3 ;formula
10 FN9:IF +Q1 EQU +0 GOTO LBL1
11 LBL "Abc Def"
12 CALL PGM TNC:\x\Abc.h
13 appr LT X+10 y20 LEN 15 RL F MAX
14 FN 16: F-PRINT TNC:\m.a/RS232:\Prot.txt
   * - Structure

;comment ~
   goes on here
CYCL DEF 201 X
Q200=5 ;abc
Q201=+Q5
L M30
99 END PGM test MM
