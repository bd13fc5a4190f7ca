"""Programs of our own for expected files whose program is not in the corpus: written from the calls they must give.

Texts of comments and messages are ours; compared are the calls, and the numbers in what is printed.
"""
OWN = {
    "exists": "#<here>=1\nG0 X[EXISTS[#<here>]] Y[EXISTS[#<gone>]] Z1\n(one word)\nG0 Z[EXISTS[#<gone>]]\nM2\n",
    "fractional-linenumbers": "S300\nN1234.5 S600\nN4567.25 S1200\nM2\n",
    "g33.1": "G0 Z1\nS1000 M3\nG33.1 Z-1.2 K.1\nM2\n",
    "g52/g52-g92-interaction": """G20
o1 sub
(print,#5210 #5211 #5212 #5213 #5214 #5215 #5216 #5217 #5218 #5219)
o1 endsub
o1 call
G92 X1 Y2
o1 call
G92.2
o1 call
G92.3
o1 call
G92.1
o1 call
G52 X2 Y3
o1 call
G92.2
o1 call
G92.3
o1 call
G52 X0 Y0
o1 call
M30
""",
    "g52/g92-offset-persistence":
        "(print,#5210)\n(print,#5211 #5212 #5213 #5214 #5215 #5216 #5217 #5218 #5219)\nM30\n",
    "g6164": "G64\nG64 P1\nG64 P1 Q2\nG61\nG61.1\nM2\n",
    "g76": """G18 G20 G64
T4 M6
G43
S800 M3
G4 P1
G0 X.2 Z.2
G76 P.05 Z-.5 I-.075 J.008 R2 K.045 Q29.5 H3 E.05 L2
G0 X.5
Z0
M5
M2
""",
    "iniparam": "G0 X#<_ini[place]x> Y#<_ini[place]y> Z#<_ini[place]z>\n(debug,#5420 #5421 #5422)\n"
                "(debug,#<_ini[gone]name>)\n#1=#<_ini[gone]name>\nM2\n",
    "iniparam-failassign": "#<_ini[place]x>=3\nM2\n",
    "m98m99/01-basics": """F40
G0 Z.25
M98 P1 L3
M30
O1
G91 G0 X1
G90 G99 G81 Z-1 R.25
M99
""",
    "m98m99/03-error-M98-no-P-word": "M98\nM2\n",
    "m98m99/04-M98-but-no-sub": "%\nM98 P1\n%\n",
    "m98m99/07-nested-subs": """(print,x #1)
M98 P2 L5
(print,x #1)
M30
O2
#2=#1
M98 P1 L5
#1=[#1+1]
(print,x #1)
M99
O1
#2=[#2+0.1]
(print,x #2)
M99
""",
    "m98m99/08-sub-follows-main": "M98 P1\nM30\nO1\n(print,x in it)\nM99\n",
    "m98m99/10-M98-P001": "M98 P001\nM30\nO1\n(print,x in it)\nM99\n",
    "magic_comments/param_format_printing": """#1=1.1234567891
#2=2.3456789
(debug,#1)
(debug,%d#1)
(debug,%.4f#1)
(debug,%.4fand then #1)
(debug,%.7f#1)
(debug,#2)
(debug,%.4f#1, #2)
(debug,#1, %d#2)
M2
""",
    "namedparam-bug424": "#<far>=2\n#<_there>=3\nG20 G0 X#<far> Y#<_there> Z4\nM2\n",
    "rotation/g28": """%
G10 L2 P2 R45
G10 L2 P3 R0
G55
G0 X10 Y10
G28.1
G28 X10 Y10
G56
G0 A1
G28 A1
%
""",
    "unit-conversion": """G20
G54
G92.2
G10 L2 P1 X0 Y0 Z0 A0 B0 C0 R0
G0 X1 Y2 Z3 A4 B5 C6
(debug,#5420 #5421 #5422 #5423 #5424 #5425)
G21
(debug,#5420 #5421 #5422 #5423 #5424 #5425)
G20
(debug,#5420 #5421 #5422 #5423 #5424 #5425)
G10 L2 P1 X1 Y2 Z3 A4 B5 C6
G54
(debug,#5221 #5222 #5223 #5224 #5225 #5226)
G21
(debug,#5221 #5222 #5223 #5224 #5225 #5226)
G20
(debug,#5221 #5222 #5223 #5224 #5225 #5226)
G92 X1 Y2 Z3 A4 B5 C6
(debug,#5211 #5212 #5213 #5214 #5215 #5216)
G21
(debug,#5211 #5212 #5213 #5214 #5215 #5216)
G20
(debug,#5211 #5212 #5213 #5214 #5215 #5216)
G92.1
M2
""",
    "m19": "M19 R87 Q2\nM19 R42 P1\nM19 R132 P0\nM19 R132 P1 Q1\nM2\n",
    "g72-facing": """G18 G21 G90 G54 F400
T2 M6
G40
G43
S100 M3
o1 sub
G0 X50 Z-40
G1 X100
G1 Z0
o1 endsub
G72 Q1 X50 Z0 D0 I3 R.1
G0 X0 Z0
M30
""",
}
OWN["g72-missing-iteration"] = OWN["g72-facing"]
OWN["g72-facing"] = OWN["g72-facing"].replace("G1 X100\n", "G1 X100 Z-39.999\n")
ARCS = {"big": (600, 300.14, 6000, 3001.4001), "medium": (200, 99.95, 2000, 999.5), "small": (5, 2.4986, 50, 24.986)}
for size, (inch_x, inch_i, mm_x, mm_i) in ARCS.items():
    OWN[f"good/good-arc.{size}.imperial.center-format.ngc"] = f"G20\nF1\nG0 X0 Y0\nG2 X{inch_x} I{inch_i}\nM2\n"
    OWN[f"good/good-arc.{size}.metric.center-format.ngc"] = f"G21\nF1\nG0 X0 Y0\nG2 X{mm_x} I{mm_i}\nM2\n"
