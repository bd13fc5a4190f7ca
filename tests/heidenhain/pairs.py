"""The same program in Klartext and in DIN/ISO gives the same stream: `pairs.py OBRYS`.

Each pair is run in both languages. Compared are the records without their places in the text, the exit code, and the
codes of what was complained about. A pair that differs on purpose holds the comparison itself to account.
"""
import os
import re
import subprocess
import sys
import tempfile

TOOL_H = """BLK FORM 0.1 Z X+0 Y+0 Z-40
BLK FORM 0.2 X+100 Y+100 Z+0
TOOL DEF 1 L+0 R+5
TOOL CALL 1 Z S5000
L Z+100 R0 FMAX M3
"""
TOOL_I = """N1 G30 G17 X+0 Y+0 Z-40 *
N2 G31 G90 X+100 Y+100 Z+0 *
N3 G99 T1 L+0 R+5 *
N4 T1 G17 S5000 *
N5 G00 G40 G90 Z+100 M3 *
"""
MORE = {
    "SUB.H": "0 BEGIN PGM SUB MM\n1 L IX+5 F100\n2 L Y+3\n3 END PGM SUB MM\n",
    "ISUB.I": "%ISUB G71 *\nN10 G01 G91 X+5 F100 *\nN20 G90 Y+3 *\nN9999 %ISUB G71 *\n",
    "TWO.H": "0 BEGIN PGM TWO MM\n1 L X+1 F100\n2 END PGM TWO MM\n",
    "TWO.I": "%TWO G71 *\nN10 G01 X+2 F100 *\nN9999 %TWO G71 *\n",
}

# name, Klartext, DIN/ISO; both behind the tool of the lines above, without block numbers.
PAIRS = [
    ("lines", "L X+10 Y-5 R0 FMAX\nL Z-5 F200\nL X+50 Y+20.5 F300 M8\nL IX-5 IY+2,5\n",
     "G00 G40 X+10 Y-5 *\nG01 Z-5 F200 *\nX+50 Y+20.5 F300 M8 *\nG91 X-5 Y+2,5 *\n"),
    ("mixed dimensions", "L X+10 Y+10 F200\nL IX+5 Y+30\nL X+40 IY+5\nL X+0 Y+0\n",
     "G01 X+10 Y+10 F200 *\nG91 X+5 G90 Y+30 *\nX+40 G91 Y+5 *\nG90 X+0 Y+0 *\n"),
    ("dimension behind", "L IX+5 F200\nL Y+7\n", "G01 G91 X+5 F200 G90 *\nY+7 *\n"),
    ("compensation", "L X-10 Y-10 F500\nL X+0 Y+0 RL F300\nL Y+50\nL X+50\nL Y+0\nL X+0\nL X-10 Y-10 R0\n",
     "G01 X-10 Y-10 F500 *\nG41 X+0 Y+0 F300 *\nY+50 *\nX+50 *\nY+0 *\nX+0 *\nG40 X-10 Y-10 *\n"),
    ("right compensation", "L X-10 Y-10 F500\nL X+0 Y+0 RR F300\nL X+50\nL Y+50\nL X-10 Y-10 R0\n",
     "G01 X-10 Y-10 F500 *\nG42 X+0 Y+0 F300 *\nX+50 *\nY+50 *\nG40 X-10 Y-10 *\n"),
    ("chamfer and rounding", "L X+0 Y+0 F300\nL X+50\nCHF 5\nL Y+50\nRND R8 F100\nL X+0\nL Y+0\n",
     "G01 X+0 Y+0 F300 *\nX+50 *\nG24 R5 *\nY+50 *\nG25 R8 F100 *\nX+0 *\nY+0 *\n"),
    ("corner behind G90", "L X+0 Y+0 F300\nL IX+50\nRND R8\nL Y+50\n",
     "G01 X+0 Y+0 F300 *\nG91 X+50 G90 *\nG25 R8 *\nY+50 *\n"),
    ("circle about pole", "CC X+25 Y+25\nL X+45 Y+25 F300\nC X+45 Y+25 DR+\nC X+25 Y+5 DR-\nC X+5 Y+25\n",
     "I+25 J+25 *\nG01 X+45 Y+25 F300 *\nG03 X+45 Y+25 *\nG02 X+25 Y+5 *\nG05 X+5 Y+25 *\n"),
    ("pole with its arc", "L X+45 Y+25 F300\nCC IX-20 IY+0\nC X+25 Y+45 DR+\n",
     "G01 X+45 Y+25 F300 *\nG03 G91 I-20 J+0 G90 X+25 Y+45 *\n"),
    ("pole from position", "L X+20 Y+20 F300\nCC\nLP PR+10 PA+45\n", "G01 X+20 Y+20 F300 *\nG29 *\nG11 R+10 H+45 *\n"),
    ("circle by radius", "L X+0 Y+0 F300\nCR X+20 Y+0 R+15 DR-\nCR X+40 Y+0 R-15 DR+\nCR X+60 Y+0 R+15\n",
     "G01 X+0 Y+0 F300 *\nG02 X+20 Y+0 R+15 *\nG03 X+40 Y+0 R-15 *\nG05 X+60 Y+0 R+15 *\n"),
    ("tangential arc", "L X+0 Y+25 F300\nL X+25 Y+30\nCT X+45 Y+20\nL Y+0\n",
     "G01 X+0 Y+25 F300 *\nX+25 Y+30 *\nG06 X+45 Y+20 *\nG01 Y+0 *\n"),
    ("polar lines", "CC X+50 Y+50\nLP PR+30 PA+0 FMAX\nLP PA+60 F300\nLP IPA+60\nLP PR+20 IPA+30\nLP IPR+5\n",
     "I+50 J+50 *\nG10 R+30 H+0 *\nG11 H+60 F300 *\nG91 H+60 *\nG90 R+20 G91 H+30 *\nR+5 *\nG90 *\n"),
    ("polar arcs", "CC X+50 Y+50\nLP PR+30 PA+0 F300\nCP PA+90 DR+\nCP IPA-30 DR-\nCP PA+180\n",
     "I+50 J+50 *\nG11 R+30 H+0 F300 *\nG13 H+90 *\nG12 G91 H-30 *\nG15 G90 H+180 *\n"),
    ("helix", "CC X+0 Y+0\nL X+20 Y+0 F300\nCP IPA+1080 IZ-6 DR+\n", "I+0 J+0 *\nG01 X+20 Y+0 F300 *\nG13 G91 H+1080 Z-6 *\nG90 *\n"),
    ("polar tangential arc", "CC X+40 Y+35\nL X+0 Y+35 F250\nLP PR+25 PA+120\nCTP PR+30 PA+30\nL Y+0\n",
     "I+40 J+35 *\nG01 X+0 Y+35 F250 *\nG11 R+25 H+120 *\nG16 R+30 H+30 *\nG01 Y+0 *\n"),
    ("paraxial", "L X+0 Y+0 F300\nX+20 R+ F200\nY+20 R-\nX+5 R0\nL X+7\n",
     "G01 X+0 Y+0 F300 *\nG07 G43 X+20 F200 *\nG07 G44 Y+20 *\nG07 G40 X+5 *\nX+7 *\n"),
    ("planes", "TOOL CALL 1 Y S1000\nCC Z+0 X+0\nL X+20 Z+0 F300\nC X+0 Z+20 DR-\n",
     "T1 G18 S1000 *\nK+0 I+0 *\nG01 X+20 Z+0 F300 *\nG02 X+0 Z+20 *\n"),
    ("tool with oversizes", "TOOL CALL 1 Z S3000 F250 DL+0.1 DR-0.2\nL X+5 Y+5\n", "T1 G17 S3000 F250 DL+0.1 DR-0.2 *\nG01 X+5 Y+5 *\n"),
    ("next tool", "TOOL DEF 2\nL X+5 F100\n", "G51 T2 *\nG01 X+5 F100 *\n"),
    ("subprogram", "CALL LBL 1\nL X+50 F100\nCALL LBL 1\nM2\nLBL 1\nL IX+5 F200\nL Y+9\nLBL 0\n",
     "L1,0 *\nG01 X+50 F100 *\nL1,0 *\nM2 *\nG98 L1 *\nG01 G91 X+5 F200 *\nG90 Y+9 *\nG98 L0 *\n"),
    ("repeats", "LBL 7\nL IX+5 F200\nCALL LBL 7 REP 3\nLBL \"END\"\nL IY+1\nCALL LBL \"END\" REP 2\n",
     "G98 L7 G01 G91 X+5 F200 *\nL7,3 *\nG98 L\"END\" *\nG01 Y+1 *\nL\"END\",2 *\nG90 *\n"),
    ("motion of the caller", "LBL 1\nL X+1 FMAX\nL X+2 FMAX\nCALL LBL 1 REP 1\n",
     "G00 *\nG98 L1 *\nX+1 *\nX+2 *\nL1,1 *\n"),
    ("call of Klartext", "L X+1 F100\nCALL PGM SUB\nL IX+1\n", "G01 X+1 F100 *\n%SUB.H *\nG01 G91 X+1 *\nG90 *\n"),
    ("call of DIN/ISO", "L IX+1 F100\nCALL PGM ISUB.I\nL IX+1\n", "G01 G91 X+1 F100 *\n%ISUB *\nX+1 *\n"),
    ("suffix decides", "CALL PGM TWO\nCALL PGM TWO.I\nCALL PGM TNC:\\WORK\\TWO.H\n", "%TWO.H *\n%TWO *\n%:TNC:\\WORK\\TWO.H *\n"),
    ("formulas", "Q1 = 3 * ( 2 + SQRT 16 ) / 4\nQ2 = Q1 ^ 2 - SIN 30\nL X+Q1 Y-Q2 F+Q1\n",
     "Q1 = 3 * ( 2 + SQRT 16 ) / 4 *\nQ2 = Q1 ^ 2 - SIN 30 *\nG01 X+Q1 Y-Q2 F+Q1 *\n"),
    ("functions", "FN 0: Q1 = +60\nFN 1: Q2 = -Q1 + -5\nFN 2: Q3 = +10 - +5\nFN 3: Q4 = +3 * +3\nFN 4: Q5 = +8 DIV +Q4\n"
     "FN 5: Q6 = SQRT +4\nFN 6: Q7 = SIN -Q5\nFN 7: Q8 = COS +Q5\nFN 8: Q9 = +10 LEN +Q5\nFN 13: Q10 = +10 ANG -Q1\n"
     "L X+Q2 Y+Q3 Z+Q4 F100\nL X+Q5 Y+Q6 Z+Q7\nL X+Q8 Y+Q9 Z+Q10\n",
     "D00 Q1 P01 +60 *\nD01 Q2 P01 -Q1 P02 -5 *\nD02 Q3 P01 +10 P02 +5 *\nD03 Q4 P01 +3 P02 +3 *\nD04 Q5 P01 +8 P02 +Q4 *\n"
     "D05 Q6 P01 +4 *\nD06 Q7 P01 -Q5 *\nD07 Q8 P01 +Q5 *\nD08 Q9 P01 +10 P02 +Q5 *\nD13 Q10 P01 +10 P02 -Q1 *\n"
     "G01 X+Q2 Y+Q3 Z+Q4 F100 *\nX+Q5 Y+Q6 Z+Q7 *\nX+Q8 Y+Q9 Z+Q10 *\n"),
    ("jumps", "FN 0: Q1 = +0\nLBL 1\nFN 1: Q1 = +Q1 + +1\nL X+Q1 F100\nFN 12: IF +Q1 LT +4 GOTO LBL 1\n"
     "FN 9: IF +Q1 EQU +4 GOTO LBL 2\nL X+99\nLBL 2\nFN 10: IF +Q1 NE +4 GOTO LBL 1\nFN 11: IF +Q1 GT +9 GOTO LBL 1\n",
     "D00 Q1 P01 +0 *\nG98 L1 *\nD01 Q1 P01 +Q1 P02 +1 *\nG01 X+Q1 F100 *\nD12 P01 +Q1 P02 +4 P03 1 *\n"
     "D09 P01 +Q1 P02 +4 P03 2 *\nX+99 *\nG98 L2 *\nD10 P01 +Q1 P02 +4 P03 1 *\nD11 P01 +Q1 P02 +9 P03 1 *\n"),
    ("system data", "FN 18: SYSREAD Q1 = ID20 NR1\nFN 18: SYSREAD Q2 = ID50 NR2 IDX1\nL X+Q1 Y+Q2 F100\n",
     "D18 Q1 P01 20 P02 1 *\nD18: SYSREAD Q2 = ID50 NR2 IDX1 *\nG01 X+Q1 Y+Q2 F100 *\n"),
    ("stops with an error", "FN 14: ERROR = 1005\nL X+1 F100\n", "D14 P01 1005 *\nG01 X+1 F100 *\n"),
    ("stop", "STOP M8\nL X+5 F100\nSTOP\n", "G38 M8 *\nG01 X+5 F100 *\nG38 *\n"),
    ("drilling", "CYCL DEF 200 DRILLING ~\nQ200=2 ~\nQ201=-20 ~\nQ206=150 ~\nQ202=5 ~\nQ210=0 ~\nQ203=+0 ~\nQ204=50 ~\nQ211=0\n"
     "L X+10 Y+10 FMAX M99\nL X+20 FMAX\nCYCL CALL M8\nL X+30 FMAX M89\nL X+40 FMAX M99\n",
     "G200 DRILLING Q200=2 Q201=-20 Q206=150 Q202=5 Q210=0 Q203=+0 Q204=50 Q211=0 *\n"
     "G00 X+10 Y+10 M99 *\nX+20 *\nG79 M8 *\nX+30 M89 *\nX+40 M99 *\n"),
    ("pecking", "CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -20\nCYCL DEF 1.3 PECKG 8\nCYCL DEF 1.4 DWELL 0.5\n"
     "CYCL DEF 1.5 F400\nL X+10 Y+10 FMAX\nL Z+2 FMAX M99\n",
     "G83 P01 2 P02 -20 P03 8 P04 0.5 P05 400 *\nG00 X+10 Y+10 *\nZ+2 M99 *\n"),
    ("tapping", "CYCL DEF 2.0 TAPPING\nCYCL DEF 2.1 SET UP 2\nCYCL DEF 2.2 DEPTH -20\nCYCL DEF 2.3 DWELL 0.5\nCYCL DEF 2.4 F100\n"
     "L X+10 Y+10 Z+2 FMAX M99\nCYCL DEF 17.0 RIGID TAPPING\nCYCL DEF 17.1 SET UP 2\nCYCL DEF 17.2 DEPTH -20\nCYCL DEF 17.3 PITCH +1\n"
     "L X+20 FMAX M99\n",
     "G84 P01 2 P02 -20 P03 0.5 P04 100 *\nG00 X+10 Y+10 Z+2 M99 *\nG85 P01 2 P02 -20 P03 +1 *\nX+20 M99 *\n"),
    ("thread cutting", "CYCL DEF 18.0 THREAD CUTTING\nCYCL DEF 18.1 DEPTH -20\nCYCL DEF 18.2 PITCH +1\nL X+5 Z+2 FMAX M99\n",
     "G86 P01 -20 P02 +1 *\nG00 X+5 Z+2 M99 *\n"),
    ("dwell and orientation", "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 1.5\nCYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE 90\n",
     "G04 F1.5 *\nG36 S90 *\n"),
    ("datum shift", "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+60\nCYCL DEF 7.2 Y+40\nL X+0 Y+0 F100\nCYCL DEF 7.0 DATUM SHIFT\n"
     "CYCL DEF 7.1 IX+5\nL X+0 Y+0\n", "G54 X+60 Y+40 *\nG01 X+0 Y+0 F100 *\nG54 G91 X+5 *\nG90 X+0 Y+0 *\n"),
    ("mirror", "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X Y\nL X+10 Y+5 F100\n", "G28 X Y *\nG01 X+10 Y+5 F100 *\n"),
    ("rotation and scaling", "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\nL X+10 Y+0 F100\nCYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.5\n"
     "L X+20 Y+0\n", "G73 G90 H+30 *\nG01 X+10 Y+0 F100 *\nG72 F0.5 *\nX+20 Y+0 *\n"),
    ("working plane", "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+30 B+0 C+0\nL X+10 Y+0 F100\n", "G80 A+30 B+0 C+0 *\nG01 X+10 Y+0 F100 *\n"),
    ("tolerance", "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:1 TA5\nL X+10 F100\n", "G62 T0.05 P01 1 P02 5 *\nG01 X+10 F100 *\n"),
    ("program as a cycle", "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM SUB\nL X+10 F100 M99\n", "G39 P01 SUB.H *\nG01 X+10 F100 M99 *\n"),
    ("contour", "CYCL DEF 14.0 CONTOUR GEOMETRY\nCYCL DEF 14.1 CONTOUR LABEL 1/2\nCYCL DEF 20 CONTOUR DATA Q1=-20 Q2=1 Q3=+0 Q4=+0 Q5=+0 Q6=2 Q7=+50 Q8=0 Q9=-1\n"
     "CYCL DEF 22 ROUGH-OUT Q10=5 Q11=100 Q12=350 Q18=0 Q19=150\nCYCL CALL\nM2\nLBL 1\nL X+0 Y+0 RR\nL X+50\nL Y+50\nL X+0 Y+0\nLBL 0\nLBL 2\nL X+1\nLBL 0\n",
     "G37 P01 1 P02 2 *\nG120 CONTOUR DATA Q1=-20 Q2=1 Q3=+0 Q4=+0 Q5=+0 Q6=2 Q7=+50 Q8=0 Q9=-1 *\n"
     "G122 ROUGH-OUT Q10=5 Q11=100 Q12=350 Q18=0 Q19=150 *\nG79 *\nM2 *\nG98 L1 *\nG01 G42 X+0 Y+0 *\nX+50 *\nY+50 *\nX+0 Y+0 *\nG98 L0 *\nG98 L2 *\nG01 X+1 *\nG98 L0 *\n"),
    ("old contour cycles", "CYCL DEF 6.0 ROUGH-OUT\nCYCL DEF 6.1 SET UP 2 DEPTH -10\nCYCL DEF 6.2 PECKG 5 F100 ALLOW +0.5\nCYCL DEF 6.3 ANGLE +0 F300\nL X+1 F100 M99\n",
     "G57 P01 2 P02 -10 P03 5 P04 100 P05 +0.5 P06 +0 P07 300 *\nG01 X+1 F100 M99 *\n"),
    ("contour milling", "CYCL DEF 16.0 CONTOUR MILLING\nCYCL DEF 16.1 SET UP 2 DEPTH -10\nCYCL DEF 16.2 PECKG 5 F100\nCYCL DEF 16.3 DR- F300\nL X+1 F100 M99\n",
     "G58 P01 2 P02 -10 P03 5 P04 100 P05 300 *\nG01 X+1 F100 M99 *\n"),
    ("pockets", "CYCL DEF 4.0 POCKET MILLING\nCYCL DEF 4.1 SET UP 2\nCYCL DEF 4.2 DEPTH -10\nCYCL DEF 4.3 PECKG 4 F80\nCYCL DEF 4.4 X+80\nCYCL DEF 4.5 Y+40\n"
     "CYCL DEF 4.6 F100 DR+ RADIUS 5\nL X+60 Y+35 FMAX\nL Z+2 FMAX M99\nCYCL DEF 5.0 CIRCULAR POCKET\nCYCL DEF 5.1 SET UP 2\nCYCL DEF 5.2 DEPTH -12\n"
     "CYCL DEF 5.3 PECKG 6 F80\nCYCL DEF 5.4 RADIUS 35\nCYCL DEF 5.5 F100 DR-\nL X+60 Y+50 FMAX M99\n",
     "G76 P01 2 P02 -10 P03 4 P04 80 P05 X+80 P06 Y+40 P07 100 P08 5 *\nG00 X+60 Y+35 *\nZ+2 M99 *\n"
     "G77 P01 2 P02 -12 P03 6 P04 80 P05 35 P06 100 *\nX+60 Y+50 M99 *\n"),
    ("preset", "CYCL DEF 247 DATUM SETTING Q339=1\nL X+1 F100\n", "G247 Q339=1 *\nG01 X+1 F100 *\n"),
    ("functions of the machine", "L X+1 F100 M13\nL X+2 M8\nL X+3 M91\nM9\nL X+4 M5\nM30\n",
     "G01 X+1 F100 M13 *\nX+2 M8 *\nX+3 M91 *\nM9 *\nX+4 M5 *\nM30 *\n"),
    ("block skip", "L X+1 F100\n/L X+2\nL X+3\n", "G01 X+1 F100 *\n/X+2 *\nX+3 *\n"),
    ("without stars", "L X+1 F100\nL Y+2\nL X+3\n", "G01 X+1 F100\nY+2\nG01 X+3 ; comment *\n"),
    ("rotary axes", "L C+45 F100\nL A+10 B-5\nL IC+5\n", "G01 C+45 F100 *\nA+10 B-5 *\nG91 C+5 *\n"),
    ("feeds", "L X+1 FU0.2\nL X+2 FZ0.1\nL X+3 FMAX\nL X+4 F200\n", "G01 X+1 FU0.2 *\nX+2 FZ0.1 *\nX+3 F MAX *\nX+4 F200 *\n"),
    ("smooth approach and departure", "L X-20 Y-10 R0 F500\nAPPR LCT X+0 Y+20 R5 RL F300\nL Y+50\nL X+50\nDEP LCT X+60 Y+80 R6\nL X+90\n",
     "G01 G40 X-20 Y-10 F500 *\nG41 X+0 Y+20 F300 *\nG26 R5 *\nY+50 *\nX+50 *\nG27 R6 *\nG40 X+60 Y+80 *\nX+90 *\n"),
    ("M functions with values", "L X+0 Y+0 RL F300 M120 LA20\nL X+50 M97\nL Y+50 M103 F20\nL X+0 M109\nL X-20 R0 M140 MB10\n",
     "G01 G41 X+0 Y+0 F300 M120 LA20 *\nX+50 M97 *\nY+50 M103 F20 *\nX+0 M109 *\nG40 X-20 M140 MB10 *\n"),
    ("tilted plane", "PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY\nL X+10 Y+0 Z+5 F100\nPLANE RESET STAY\nL X+10\n",
     "PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY *\nG01 X+10 Y+0 Z+5 F100 *\nPLANE RESET STAY *\nX+10 *\n"),
    ("texts", "QS1 = \"SUB\" || \".H\"\nL X+1 F100\nCALL PGM QS1\nFN 9: IF QS1 EQU \"SUB.H\" GOTO LBL \"A\"\nL X+99\nLBL \"A\"\n",
     "QS1 = \"SUB\" || \".H\" *\nG01 X+1 F100 *\n%QS1 *\nD09 P01 QS1 P02 \"SUB.H\" P03 \"A\" *\nX+99 *\nG98 L\"A\" *\n"),
    ("local parameters", "QL1 = 5\nQR2 = QL1 * 2\nFN 2: QL3 = +QL1 - +QR2\nL X+QL1 Y-QL3 FQ1\n",
     "QL1 = 5 *\nQR2 = QL1 * 2 *\nD02 QL3 P01 +QL1 P02 +QR2 *\nG01 X+QL1 Y-QL3 FQ1 *\n"),
    ("jump out of a subprogram's motion", "L X+0 Y+0 F100\nCALL LBL 1\nL X+5 FMAX\nM2\nLBL 1\nL X+9 FMAX\nLBL 0\n",
     "G01 X+0 Y+0 F100 *\nL1,0 *\nX+5 *\nM2 *\nG98 L1 *\nG00 X+9 *\nG98 L0 *\n"),
    ("G91 of a subprogram", "L X+0 Y+0 F100\nCALL LBL 1\nL IX+5\nM2\nLBL 1\nL IX+9\nLBL 0\n",
     "G01 G90 X+0 Y+0 F100 *\nL1,0 *\nX+5 *\nM2 *\nG98 L1 *\nG91 X+9 *\nG98 L0 *\n"),
    ("probe", "TCH PROBE 410 DATUM INSIDE RECTAN. Q321=+50\nL X+1 F100\n", "G410 DATUM INSIDE RECTAN. Q321=+50 *\nG01 X+1 F100 *\n"),
]
DIFFERENT = ("L X+10 Y+20 F100\n", "G01 X+10 Y+20.001 F100 *\n")
INCH = ("L X+1 F10\n", "G01 X+1 F10 *\n")


def numbered(text, number):
    """Numbers for every block; a line that starts with Q and `=` belongs to the block before in neither language."""
    lines, n = [], 10
    goes_on = False
    for line in text.splitlines():
        skip = "/" if line.startswith("/") else ""
        lines.append(line if goes_on else skip + number(n) + line.lstrip("/"))
        goes_on = line.endswith("~")
        n += 1
    return "\n".join(lines) + "\n"


def klartext(body, unit="MM"):
    return f"0 BEGIN PGM PART {unit}\n" + numbered(TOOL_H + body, lambda n: f"{n} ") + f"999 END PGM PART {unit}\n"


def iso(body, unit="G71"):
    return f"%PART {unit} *\n" + TOOL_I + numbered(body, lambda n: f"N{n} ") + f"N99999999 %PART {unit} *\n"


def run(obrys, folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="ascii") as file:
        file.write(text)
    done = subprocess.run([obrys, "run", name, "--control", "heidenhain-itnc530"], cwd=folder, capture_output=True, text=True, timeout=60)
    stream = [re.sub(r" (\^\d+|@\S+)", "", line) for line in done.stdout.splitlines()]
    codes = sorted(re.findall(r"\[([a-z-]+)\]$", done.stderr, re.M))
    return {"stream": stream, "codes": codes, "exit": done.returncode}, done.stderr


def both(obrys, h, i):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in MORE.items():
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
        left, left_said = run(obrys, folder, "PART.H", h)
        os.remove(os.path.join(folder, "PART.H"))
        right, right_said = run(obrys, folder, "PART.I", i)
    return left, right, left_said, right_said


def difference(left, right):
    out = [f"{key}: {left[key]} and {right[key]}" for key in ("codes", "exit") if left[key] != right[key]]
    for a, b in zip(left["stream"] + ["(end)"], right["stream"] + ["(end)"]):
        if a != b:
            out.append(f"Klartext: {a}\n  DIN/ISO:  {b}")
            break
    return out


def main():
    obrys, failed, records = os.path.abspath(sys.argv[1]), 0, 0
    cases = [(name, klartext(h), iso(i)) for name, h, i in PAIRS]
    cases.append(("inch", klartext(INCH[0], "INCH"), iso(INCH[1], "G70")))
    for name, h, i in cases:
        left, right, left_said, right_said = both(obrys, h, i)
        found = difference(left, right)
        records += len(left["stream"])
        if len(left["stream"]) < 3:
            found.append("the Klartext program gives no stream")
        if found:
            failed += 1
            print(f"{name}:", *found, sep="\n  ")
            print("  Klartext says:", left_said, "  DIN/ISO says:", right_said)
    left, right, _, _ = both(obrys, klartext(DIFFERENT[0]), iso(DIFFERENT[1]))
    if not difference(left, right):
        failed += 1
        print("programs that differ are called equal")
    print(f"{len(cases)} pairs, {records} records, {failed} differ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
