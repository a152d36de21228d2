/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_group.c - groups: values from closed forms with Newton's and Euler's equations of each body in 40 digits,
** which the tests of the oracle check too (oracle/chains.py); differences; the two solutions of random ones.
*/
#include "check.h"
#include "fourlink.h"
#include "mechanics/group.h"
#include "mechanics/group_limits.h"

enum { O1 = 1, O2, O3, O4, O5, O6, O7, O8, O9 };

typedef struct case_row {
    int mechanism, side;
    double crank[3];  /* deg, rad/s, rad/s2 */
    double motion[7]; /* place, speed, acceleration of a slider; omega, alpha of rod and rocker */
    double FP[2], FQ[2], FD[2], M, Ts;
    double pin[8]; /* F12, F23, F34, F14; 0 if not known */
} case_row;

static const case_row rows[] = {
    {O1,
     1,
     {35, 10, 0},
     {-0.204683616572, 0.168535128016, -16.9297406202, -0.228281375238, 23.1027833623, 0, 0},
     {150.240267883, 41.5657758003},
     {164.192269045, 35.1854928618},
     {-5.8736185934, -33.3109463441},
     1.65623376643,
     3.33579005453,
     {106.054021673, 118.906302753, 109.330629851, 113.352608499, 132.625253287, 103.468992806,
      6.36352677001, -49.5494834852}},
    {O1,
     1,
     {160, 10, 50},
     {-0.389257971726, -1.05252341655, -0.748987096097, 2.34014960171, 4.72812800367, 0, 0},
     {225.368390875, 152.508344767},
     {224.426824109, 143.839515432},
     {-26.2708448566, -148.989364821},
     0.847196090229,
     -22.6735748851,
     {240.338854303, 157.734955049, 237.264124106, 153.134420864, 227.996093982, 143.356297102,
      -0.939157425945, 23.1953119287}},
    {O1,
     1,
     {285, -6, -20},
     {-0.410028564661, -0.582545411228, 0.928790474052, 1.32543163435, -1.35647657669, 0, 0},
     {233.437617403, 174.370253708},
     {232.454666415, 165.212831683},
     {-30.1679662655, -171.091038617},
     0.763307211722,
     20.8812419665,
     {138.663117718, 293.21543556, 139.808557804, 284.183557606, 141.189435339, 260.608035238,
      93.2343446218, -71.1879212533}},
    {O1,
     -1,
     {35, 10, 0},
     {-1.02787748645, 0.0854859205104, -8.48200458344, 0.228281375238, -23.1027833623, 0, 0},
     {149.779004666, -102.131039417},
     {160.373908771, -108.090936687},
     {18.7432315419, 106.298148284},
     1.2338469646,
     2.3165314925,
     {48.667574526, 66.2810303506, 51.9441827031, 60.727336096, 75.2388061396, 50.8437204036,
      63.2887107002, -140.6210263}},
    {O1,
     -1,
     {160, 10, 50},
     {-1.04425352879, 0.391902187681, 5.75633806354, -2.34014960171, -4.72812800367, 0, 0},
     {176.980595201, -230.554237217},
     {173.453837816, -238.899341301},
     {40.7183780686, 230.925397265},
     0.521929832247,
     6.25890778522,
     {-64.9707926695, -39.0344708217, -68.045522866, -43.6350050068, -77.3135529905, -53.4131287684,
      255.982693873, -163.097844184}},
    {O1,
     -1,
     {285, -6, -20},
     {-1.03547052988, 0.275227358798, 1.14968357508, -1.32543163435, 1.35647657669, 0, 0},
     {162.033015429, -234.274378043},
     {160.962282393, -243.420807739},
     {41.868260853, 237.446706595},
     0.75226255667,
     -7.75991240683,
     {-57.8130780793, -80.134647406, -56.6676379933, -89.1665253598, -55.2867604584, -112.742047728,
      218.305938446, -106.482470038}},
    {O2,
     1,
     {35, 10, 0},
     {0.475612276982, 1.53567022237, -53.6843093876, 3.78648433628, -47.2104754641, 0, 0},
     {164.632838562, -236.017305657},
     {182.875587267, -173.686187753},
     {-379.075587267, 0},
     -1.85372375506,
     -64.4998137378,
     {-313.618633945, -735.370974284, -285.807113502, -729.635209921, -274.75847317, -725.333386648,
      345.691967137, 335.943234411}},
    {O2,
     1,
     {160, 10, 50},
     {0.330333302941, -1.92438967836, -16.083173857, -0.83264143492, 18.8867771216, 0, 0},
     {-343.878000931, 562.340787399},
     {-335.70404839, 578.336522861},
     {139.50404839, 0},
     13.1867304572,
     -101.458800541,
     {62.7445188009, 692.203467846, 74.6776933097, 700.322132383, 73.8175741913, 706.411130786,
      -464.320028562, -177.498867314}},
    {O2,
     1,
     {285, -6, -20},
     {-0.0866758898168, 0.426338344636, 13.5231330515, -0.642224184649, -19.6986356529, 0, 0},
     {-1221.5634767, 1183.05159747},
     {-1208.46146164, 1170.46266103},
     {1012.26146164, 0},
     25.0292532206,
     -87.7100497866,
     {-1420.00769526, 2991.48824623, -1397.52409504, 2988.52855135, -1390.47139488, 2986.30878019,
      99.2431724156, -1779.17358825}},
    {O2,
     -1,
     {35, 10, 0},
     {0.0203229397838, 3.01536522112, -65.6056823968, -3.78648433628, 47.2104754641, 0, 0},
     {-394.483955647, -481.001520994},
     {-376.241206942, -412.113647935},
     {180.041206942, 0},
     -6.62227295871,
     -168.440762566,
     {-749.731850459, -1886.66386308, -721.920330016, -1880.92809871, -710.871689684,
      -1876.62627544, 222.688389442, 1242.25190787}},
    {O2,
     -1,
     {160, 10, 50},
     {-0.18483029383, -2.18049490091, -9.9167891981, 0.83264143492, -18.8867771216, 0, 0},
     {411.816548322, 689.059992139},
     {419.990500863, 701.664216038},
     {-616.190500863, 0},
     15.6532843208,
     -143.674814743,
     {92.8947711485, 980.731966481, 104.827945657, 988.850631018, 103.967826539, 994.939629421,
      261.224268343, -339.30816121}},
    {O2,
     -1,
     {285, -6, -20},
     {-0.50426792458, 0.149647107684, 5.20855153345, 0.642224184649, 19.6986356529, 0, 0},
     {1032.65126954, 1012.18694727},
     {1045.75328461, 1004.17103067},
     {-1241.95328461, 0},
     21.7034206134,
     -29.1293639499,
     {-467.618839795, 946.047245657, -445.13523958, 943.087550773, -438.082539418, 940.867779609,
      1401.0690632, 95.4027621302}},
    {O3,
     1,
     {35, 10, 0},
     {0, 0, 0, -1.56984853579, 15.0412153738, -0.847011820984, 44.9513285647},
     {-9.66238434848, 0.246363746528},
     {0.370055056144, -3.91516179246},
     {-7.86406718555, 94.603009347},
     0,
     0.827392197894,
     {-38.253512299, -12.7608039735, -34.9769041219, -18.3144982281, -2.0198963369, -28.444477667,
      -9.23159148886, 40.798211188}},
    {O3,
     1,
     {160, 10, 50},
     {0, 0, 0, 1.0818113792, 10.2314762412, 2.42576525588, 1.56932124946},
     {39.2219400223, 13.8012417781},
     {38.3296272756, 9.71300462779},
     {-38.0445277189, 81.0736852313},
     0,
     -5.27426841973,
     {45.2515846142, 43.5813623305, 42.1768544177, 38.9808281454, -6.31311572902, 15.4014626057,
      8.00166141059, -1.35819834114}},
    {O3,
     1,
     {285, -6, -20},
     {0, 0, 0, -0.216093333426, -6.73596432989, 1.12415056915, -5.17020747985},
     {43.523178207, 30.0399427558},
     {42.7750405703, 21.9164928947},
     {-41.9559223424, 70.2197248868},
     0,
     4.52356520266,
     {24.3337383553, 87.886390366, 25.4791784413, 78.8545124122, -16.6631222308, 25.2390472882,
      17.6492847886, -10.1891870115}},
    {O3,
     -1,
     {35, 10, 0},
     {0, 0, 0, -0.973216747883, 39.8445166623, -1.69605346269, 9.93440347142},
     {-20.5119577102, 78.3690923983},
     {-16.8385126792, 74.7340067672},
     {18.1169767431, 15.8547879542},
     0,
     5.52414850178,
     {-44.0241296367, 40.5353737204, -40.7475214596, 34.9816794658, 3.05905968713, -53.2710286248,
      -14.3105475129, 65.6247621458}},
    {O3,
     -1,
     {160, 10, 50},
     {0, 0, 0, 2.27301788301, 2.72551163563, 0.929064006319, 11.3876666274},
     {-42.7055600557, 67.4494260087},
     {-44.0987859972, 63.8668962124},
     {45.1203909009, 26.2753211803},
     0,
     -4.40998399656,
     {6.99135472504, 48.309424444, 3.91662452855, 43.7088902589, 37.3541544598, -33.5186595114,
      -35.6656087782, 47.5619237759}},
    {O3,
     -1,
     {285, -6, -20},
     {0, 0, 0, 0.954354168763, -5.15355438978, -0.38588973381, -6.71931123982},
     {-46.3786793822, 57.8269041412},
     {-46.0198353063, 49.2664885015},
     {45.2780023748, 43.3605576086},
     0,
     -0.384587062349,
     {-22.1908804852, 71.8821903964, -21.0454403992, 62.8503124426, 26.7141165178, -18.5521140668,
      -25.72795396, 33.6019743435}},
    {O5,
     1,
     {35, 10, 0},
     {0.224070765529, 0.264877061211, -5.44656834063, -2.53505043155, -11.0614513872, 0, 0},
     {992.952799496, 2319.7370822},
     {996.22724088, 2314.04387148},
     {251.866460201, -145.415168597},
     0,
     66.7052699298,
     {988.35127665, 2356.00898365, -7.05897897838, 5.12117213451, -3.22106599186, -1.98709855644, 0,
      8.85409855644}},
    {O5,
     1,
     {160, 10, 50},
     {0.164451597667, -0.46771056595, -0.116947571933, 0.501484893486, 30.8765215658, 0, 0},
     {1873.93363658, 1819.29201487},
     {1871.64513107, 1812.9289981},
     {-621.68606272, 358.930615663},
     0,
     -116.986916134,
     {1876.92124727, 1854.62734804, 5.29365833488, 3.46973381441, 2.09132748126, -2.92366682443, 0,
      9.79066682443}},
    {O5,
     1,
     {285, -6, -20},
     {0.141138286888, -0.169637581881, 0.697102190764, -1.20192462032, -10.9285751727, 0, 0},
     {818.568330188, 2431.0435628},
     {819.322844923, 2421.14554187},
     {430.921140843, -248.792436665},
     0,
     70.7014002784,
     {817.511239926, 2465.94387513, -1.91617032591, 6.35822079964, -0.739963182995, -3.35868766569,
      0, 10.2256876657}},
    {O5,
     -1,
     {35, 10, 0},
     {-0.133439986825, 0.15774120053, -3.61650952974, 2.53505043155, 11.0614513872, 0, 0},
     {1506.54961533, 2025.32499222},
     {1509.54954789, 2019.15631827},
     {-260.815326226, 150.581798805},
     0,
     39.9175050939,
     {1501.94809248, 2061.59689366, -7.05897897838, 5.12117213451, -3.22106599186, -1.98709855644,
      0, 8.85409855644}},
    {O5,
     -1,
     {160, 10, 50},
     {-0.181816415433, -0.517097187062, -3.07060941646, -0.501484893486, -30.8765215658, 0, 0},
     {637.541833145, 2529.71256048},
     {635.69637691, 2524.11692757},
     {613.228909794, -354.047876145},
     0,
     -129.222218261,
     {640.529443832, 2565.04789366, 5.29365833488, 3.46973381441, 2.09132748126, -2.92366682443, 0,
      9.79066682443}},
    {O5,
     -1,
     {285, -6, -20},
     {-0.211848965007, -0.254626486831, 0.434268659135, 1.20192462032, 10.9285751727, 0, 0},
     {1688.99528588, 1928.1988316},
     {1689.78922565, 1918.36909682},
     {-439.637231618, 253.82467402},
     0,
     106.23250444,
     {1687.93819562, 1963.09914393, -1.91617032591, 6.35822079964, -0.739963182995, -3.35868766569,
      0, 10.2256876657}},
    {O7,
     1,
     {50, 10, 0},
     {0, 0, 0, 6.0289344701, 86.7590809937, -1.61914050531, 68.6618829249},
     {-30.474940618, 6.32362611532},
     {-20.8412432047, -2.49589167935},
     {-5.87809826853, 62.7773772578},
     0,
     8.18202389062,
     {0, 0, 0, 0, 0, 0, 0, 0}},
    {O7,
     1,
     {130, 10, 40},
     {0, 0, 0, 12.4854946402, 102.418785059, 6.13937404338, 121.765919304},
     {-8.0573079493, -19.1376153428},
     {-2.87949875565, -17.6739359976},
     {-22.9073001718, 65.4671738108},
     0,
     6.15414448698,
     {0, 0, 0, 0, 0, 0, 0, 0}},
    {O7,
     1,
     {300, -5, 0},
     {0, 0, 0, 2.51476979342, -12.7403517978, -1.4268891041, -15.0970557615},
     {12.414432093, 55.1476480586},
     {10.7376456386, 47.8903084317},
     {-29.1454347417, 7.45073629503},
     0,
     -1.28212928578,
     {0, 0, 0, 0, 0, 0, 0, 0}},
    {O7,
     -1,
     {50, 10, 0},
     {0, 0, 0, -1.61914050531, 68.6618829249, 6.0289344701, 86.7590809937},
     {-7.63389580494, 55.5198933303},
     {-1.35142249273, 49.7165320364},
     {-22.5752322296, 8.05148979137},
     0,
     4.25792575329,
     {0, 0, 0, 0, 0, 0, 0, 0}},
    {O7,
     -1,
     {130, 10, 40},
     {0, 0, 0, 6.13937404338, 121.765919304, 12.4854946402, 102.418785059},
     {-15.8655271403, 49.8673264808},
     {-19.915833759, 44.8033783309},
     {1.81913134179, 8.42954906159},
     0,
     -1.77952893509,
     {0, 0, 0, 0, 0, 0, 0, 0}},
    {O7,
     -1,
     {300, -5, 0},
     {0, 0, 0, -1.4268891041, -15.0970557615, 2.51476979342, -12.7403517978},
     {-30.1423575562, 8.94720490151},
     {-31.2604437087, 1.88940306099},
     {12.3870710206, 53.285360177},
     0,
     2.32363144422,
     {0, 0, 0, 0, 0, 0, 0, 0}},
};

/* Groups by a slot: also the place of the block in a slot of the lever, m; the angle of a rocker, deg; or 0. */
static const struct slot_row {
    case_row row;
    double slide, theta;
} slot_rows[] = {
    {{O4,
      1,
      {35, 10, 0},
      {0.187683269579, 2.03994015203, -41.8372460229, 0, 0, 0, 0},
      {24.7200397253, 72.4413096566},
      {24.7200397253, 72.4413096566},
      {-171.870039725, 0},
      2.16382619313,
      -6.10023459287,
      {-69.5636274409, -102.753529182, -41.752106998, -97.0177648182, -31.9321947323,
       -93.5763062001, -27.3928106204, 30.7012692084}},
     0.581141127163,
     0},
    {{O4,
      1,
      {160, 10, 50},
      {0.054688339793, -1.55692823251, -8.66322798319, 0, 0, 0, 0},
      {56.6821354916, 570.051580252},
      {56.6821354916, 570.051580252},
      {-203.832135492, 0},
      12.116031605,
      -82.8116817976,
      {59.6474075579, 709.840960901, 71.5805820667, 717.959625439, 71.873486772, 722.830824161,
       -63.0340057135, -184.914412118}},
     0.552712234811,
     0},
    {{O4,
      1,
      {285, -6, -20},
      {-0.237044315096, 0.231886901225, 9.09274941695, 0, 0, 0, 0},
      {-360.475979882, 836.391241254},
      {-360.475979882, 836.391241254},
      {213.325979882, 0},
      17.4428248251,
      -35.3576491979,
      {-790.766120058, 1771.96898322, -768.282519843, 1769.00928833, -761.659359714, 1767.2334714,
       332.521712003, -907.525030456}},
     0.598907344519,
     0},
    {{O6,
      1,
      {35, 10, 0},
      {0.176981279707, 2.12758919564, -48.933382592, 0, 0, 0, 0},
      {-9.11047052511, -34.0007388806},
      {-9.11047052511, -34.0007388806},
      {-138.039529475, 0},
      -3.12731648104,
      -28.1117886849,
      {-169.967199579, -396.983083045, -142.155679136, -391.247318681, -132.33576687,
       -387.805860063, 39.180251267, 218.488774534}},
     0,
     0},
    {{O6,
      1,
      {160, 10, 50},
      {0.0300074677024, -1.77544782372, -10.0519495579, 0, 0, 0, 0},
      {147.163258206, 549.220756632},
      {147.163258206, 549.220756632},
      {-294.313258206, 0},
      80.5468463025,
      -91.5700215798,
      {67.1006809958, 784.798445556, 79.0338555046, 792.917110093, 79.3267602098, 797.788308816,
       19.9938435629, -280.702720393}},
     0,
     0},
    {{O6,
      1,
      {285, -6, -20},
      {-0.263980366533, 0.179068992317, 7.12684857912, 0, 0, 0, 0},
      {216.208934522, 806.902728687},
      {216.208934522, 806.902728687},
      {-363.358934522, 0},
      76.8468905903,
      -27.114830094,
      {-602.781561291, 1335.79945399, -580.297961076, 1332.8397591, -573.674800948, 1331.06394217,
       721.222067641, -500.844013795}},
     0,
     0},
    {{O8,
      1,
      {35, 10, 0},
      {0, 0, 0, 0, 0, 1.36911016978, -29.9693193985},
      {7.45815526306, 10.1338077258},
      {7.45815526306, 10.1338077258},
      {-15.4320413239, 0.892739537338},
      0,
      1.62526586041,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -36.3518682349},
    {{O8,
      -1,
      {35, 10, 0},
      {0, 0, 0, 0, 0, 1.45269461271, -27.5093400744},
      {-2.2765532282, -4.28380517307},
      {-2.2765532282, -4.28380517307},
      {8.26408952638, 36.4435883805},
      0,
      0.629363762673,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -207.987628039},
    {{O8,
      1,
      {160, 10, 50},
      {0, 0, 0, 0, 0, -2.93464981925, 0.11854709393},
      {21.6551996955, 14.596953534},
      {21.6551996955, 14.596953534},
      {-23.8885300723, 10.0526300965},
      0,
      -4.23390189984,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -56.017575793},
    {{O8,
      -1,
      {160, 10, 50},
      {0, 0, 0, 0, 0, -3.05669900009, -4.576818648},
      {4.65753487434, 4.55813858586},
      {4.65753487434, 4.55813858586},
      {-0.266340732399, 15.7099593317},
      0,
      -2.36409896582,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -225.617943663},
    {{O8,
      1,
      {285, -6, -20},
      {0, 0, 0, 0, 0, -0.944811135763, 3.70967802832},
      {18.46153584, 9.1048551851},
      {18.46153584, 9.1048551851},
      {-17.2250686131, 13.6158870104},
      0,
      2.46863154909,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -63.7484192227},
    {{O8,
      -1,
      {285, -6, -20},
      {0, 0, 0, 0, 0, -0.92317745681, 4.38997568958},
      {7.91507644965, 5.42284585314},
      {7.91507644965, 5.42284585314},
      {-9.22654881018, 14.6889921454},
      0,
      1.72664878081,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -235.58383888},
    {{O9,
      1,
      {160, 10, 50},
      {0, 0, 0, 0, 0, -3.76735739065, 112.750206987},
      {0.317194078168, 0.962082942947},
      {0.317194078168, 0.962082942947},
      {28.5666181938, 5.56504847354},
      0,
      -1.66704004852,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -125.844309034},
    {{O9,
      -1,
      {160, 10, 50},
      {0, 0, 0, 0, 0, 9.14313120369, -119.971311206},
      {-51.5512616833, -156.360389322},
      {-51.5512616833, -156.360389322},
      {16.3588478698, 192.670986612},
      0,
      -17.6356523197,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -90.6499651727},
    {{O9,
      1,
      {285, -6, -20},
      {0, 0, 0, 0, 0, -1.30415154951, 15.8329889367},
      {15.0660452472, 55.1778541996},
      {15.0660452472, 55.1778541996},
      {-11.1495949053, -39.3841942164},
      0,
      -0.657463554659,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -129.181714439},
    {{O9,
      -1,
      {285, -6, -20},
      {0, 0, 0, 0, 0, 4.15168299189, -24.1554826455},
      {-17.1109510124, -62.667113014},
      {-17.1109510124, -62.667113014},
      {9.48113427002, 82.9937558909},
      0,
      7.48238462396,
      {0, 0, 0, 0, 0, 0, 0, 0}},
     0,
     -81.3624240359},
};

static void set_link(fourlink_link *link, double length, double mass, double inertia, double x,
                     double y)
{
    link->length = length;
    link->mass = mass;
    link->inertia = inertia;
    link->cg.x = x;
    link->cg.y = y;
}

static void set_vector(fourlink_vector *v, double x, double y)
{
    v->x = x;
    v->y = y;
}

static void set_direction(fourlink_vector *v, double size, double degrees)
{
    v->x = size * cos(degrees * PI / 180);
    v->y = size * sin(degrees * PI / 180);
}

static void set_four_bar(fourlink_design *d)
{
    d->kind = FOURLINK_FOUR_BAR;
    d->link[1].length = 0.4;
    set_link(&d->link[2], 0.1, 0.8, 0.002, 0.05, 0);
    set_link(&d->link[3], 0.35, 2, 0.03, 0.17, 0.02);
    set_link(&d->link[4], 0.3, 1.5, 0.02, 0.15, 0);
}

/* The shaper with its ram by a slot instead of a rod. */
static void set_shaper(int number, fourlink_design *d, fourlink_group *g, fourlink_load *load)
{
    d->link[1].length = 0.3;
    d->link[2].length = 0.12;
    g->rod = 0;
    set_link(&g->body[0], 0, 0, 0, 0, 0);
    set_link(&g->body[1], 0, 15, 0.1, 0.1, -0.02);
    set_vector(&load->force, 0, -700);
    set_vector(&g->at, number == O4 ? 0.7 : 0.62, 0);
    set_vector(&g->pivot, number == O4 ? -0.25 : -0.2, 0);
    set_direction(&g->slot, 1, number == O4 ? 0 : 75);
}

/* The mechanism, its group and the load on that. */
static void set_case(int number, int side, fourlink_design *d, fourlink_group *g,
                     fourlink_load *load)
{
    memset(d, 0, sizeof *d);
    memset(g, 0, sizeof *g);
    memset(load, 0, sizeof *load);
    d->group = g;
    d->n_groups = 1;
    d->gravity.y = -9.81;
    load->link = 6;
    g->end = number == O3 || number >= O7 ? FOURLINK_GROUP_TURNS : FOURLINK_GROUP_SLIDES;
    g->hang = number == O4 || number == O9   ? FOURLINK_HANGS_IN_SLOT
              : number == O6 || number == O8 ? FOURLINK_HANGS_BY_OWN_SLOT
                                             : FOURLINK_HANGS_BY_ROD;
    g->side = side;
    g->rod = 0.45;
    if (number == O1 || number == O3 || number >= O8)
        set_four_bar(d);
    switch (number) {
    case O1:
        g->link = 4;
        set_vector(&g->at, 0.3, 0.08);
        set_vector(&g->pivot, 0.9, 0.35);
        set_direction(&g->direction, 1, -10);
        set_link(&g->body[0], 0, 0.9, 0.012, 0.2, 0.01);
        set_link(&g->body[1], 0, 2.5, 0.01, 0.03, 0.02);
        set_vector(&load->force, -200, 30);
        return;
    case O4:
    case O6:
    case O2:
        d->kind = FOURLINK_INVERTED_SLIDER_CRANK;
        d->link[1].length = 0.35;
        set_vector(&d->gravity, 9.81, 0);
        set_link(&d->link[2], 0.15, 2, 0.01, 0.05, 0);
        set_link(&d->link[3], 0, 0.5, 0.001, 0, 0);
        set_link(&d->link[4], 0, 6, 0.25, 0.3, 0);
        g->link = 4;
        g->rod = 0.3;
        set_vector(&g->at, 0.7, 0);
        set_vector(&g->pivot, -0.5, 0);
        set_direction(&g->direction, 1, 90);
        set_link(&g->body[0], 0, 1.1, 0.01, 0.15, 0);
        set_link(&g->body[1], 0, 20, 0.1, 0.1, -0.02);
        set_vector(&load->force, 0, -900);
        if (number != O2)
            set_shaper(number, d, g, load);
        return;
    case O3:
        g->link = 3;
        g->rod = 0.4;
        g->length = 0.35;
        set_vector(&g->at, 0.2, 0.12);
        set_vector(&g->pivot, 0.55, 0.05);
        set_link(&g->body[0], 0, 0.7, 0.01, 0.2, 0);
        set_link(&g->body[1], 0, 1.2, 0.015, 0.14, 0.01);
        set_vector(&load->force, 0, -80);
        set_vector(&load->at, 0.35, 0);
        return;
    case O5:
        d->kind = FOURLINK_SLIDER_CRANK;
        set_link(&d->link[2], 0.05, 3, 0.01, -0.01, 0);
        set_link(&d->link[3], 0.18, 0.9, 0.004, 0.06, 0);
        set_link(&d->link[4], 0, 0.7, 0, 0, 0);
        g->link = 2;
        g->rod = 0.18;
        set_vector(&g->at, 0.05, 0);
        set_direction(&g->direction, 1, 60);
        set_link(&g->body[0], 0, 0.9, 0.004, 0.06, 0);
        set_link(&g->body[1], 0, 0.7, 0, 0, 0);
        set_direction(&load->force, -2500, 60);
        return;
    case O8:
        g->link = 3;
        set_vector(&g->at, 0.2, 0.12);
        set_vector(&g->pivot, -0.2, 0.5);
        g->offset = 0.03;
        set_link(&g->body[1], 0, 2.2, 0.06, 0.2, 0.01);
        load->torque = -6;
        return;
    case O9:
        g->link = 4;
        g->length = 0.35;
        set_vector(&g->at, 0.2, 0.1);
        set_direction(&g->slot, 1, 30);
        set_vector(&g->pivot, 0.75, 0.25);
        set_link(&g->body[1], 0, 1.8, 0.04, 0.15, 0.02);
        load->torque = 8;
        return;
    case O7:
        d->kind = FOURLINK_FOUR_BAR;
        d->link[1].length = 0.132;
        set_link(&d->link[2], 0.084, 0.5, 0.001, 0.042, 0);
        set_link(&d->link[3], 0.12, 1.2, 0.01, 0.08, 0.03);
        set_link(&d->link[4], 0.108, 1, 0.01, 0.07, -0.04);
        g->link = 3;
        g->to = 4;
        g->rod = g->length = 0.12;
        set_direction(&g->at, 0.18, 30);
        set_direction(&g->pivot, 0.18, -50);
        set_link(&g->body[0], 0, 0.6, 0.002, 0.06, 0);
        set_link(&g->body[1], 0, 0.5, 0.002, 0.06, 0);
        set_vector(&load->force, 20, -50);
        set_vector(&load->at, 0.12, 0);
        return;
    }
}

#define CLOSE 1e-10 /* the values have twelve digits */

static void check_vector(fourlink_vector v, const double wanted[2])
{
    double close = CLOSE * (fabs(wanted[0]) + fabs(wanted[1]));

    assert_near(v.x, wanted[0], close);
    assert_near(v.y, wanted[1], close);
}

static void check_pins(const fourlink_forces *f, const case_row *row)
{
    const double *pins[8], *p = row->pin;
    int i;

    pins[0] = &f->F12x, pins[1] = &f->F12y, pins[2] = &f->F23x, pins[3] = &f->F23y;
    pins[4] = &f->F34x, pins[5] = &f->F34y, pins[6] = &f->F14x, pins[7] = &f->F14y;
    for (i = 0; i < 8 && (p[0] != 0 || p[1] != 0); i++)
        assert_near(*pins[i], p[i], 20 * CLOSE * (fabs(p[0]) + fabs(p[1])));
}

static void check_motion(const fourlink_group *g, const fourlink_state *s, const double motion[7])
{
    const fourlink_link_state *rod = &s->link[5], *end = &s->link[6];
    double close = CLOSE * (fabs(motion[4]) + fabs(motion[6]) + fabs(motion[2]) + 1),
           found[7] = {0, 0, 0, 0, 0, 0, 0};
    fourlink_vector u = g->direction;
    int i;

    if (g->end == FOURLINK_GROUP_SLIDES) {
        found[0] = u.x * (end->origin.x - g->pivot.x) + u.y * (end->origin.y - g->pivot.y);
        found[1] = u.x * end->velocity.x + u.y * end->velocity.y;
        found[2] = u.x * end->acceleration.x + u.y * end->acceleration.y;
    }
    if (g->hang == FOURLINK_HANGS_BY_ROD) {
        found[3] = rod->omega;
        found[4] = rod->alpha;
    }
    found[5] = end->omega;
    found[6] = end->alpha;
    for (i = 0; i < 7; i++)
        assert_near(found[i], motion[i], close);
}

/* Of a group by a slot. */
static void check_block(const fourlink_mechanism *m, const fourlink_state *s,
                        const struct slot_row *row)
{
    double slide, rate;

    if (row->theta != 0)
        assert_near(remainder(s->link[6].theta - row->theta * DEG, 2 * PI), 0, CLOSE);
    flk_group_slide(m, s, 0, &slide, &rate);
    if (row->slide != 0)
        assert_near(0.7 + slide, row->slide, CLOSE);
}

#define N_ROWS (sizeof rows / sizeof rows[0])
#define N_SLOT_ROWS (sizeof slot_rows / sizeof slot_rows[0])

TEST(test_values)
{
    size_t i;
    int closed;

    for (i = 0; i < N_ROWS + N_SLOT_ROWS; i++)
        for (closed = 0; closed < 2; closed++) {
            const case_row *row = i < N_ROWS ? &rows[i] : &slot_rows[i - N_ROWS].row;
            fourlink_design d;
            fourlink_group g;
            fourlink_load load;
            fourlink_mechanism m;
            fourlink_crank crank;
            fourlink_state s;
            fourlink_forces f;
            flk_group_forces of;

            set_case(row->mechanism, row->side, &d, &g, &load);
            crank.theta2 = row->crank[0] * PI / 180;
            crank.omega2 = row->crank[1];
            crank.alpha2 = row->crank[2];
            assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
            assert_int_equal((closed ? fourlink_analyse_dyad : fourlink_analyse)(
                                 &m, FOURLINK_OPEN, &crank, &load, 1, &s, &f),
                             FOURLINK_OK);
            flk_groups_forces(&m, &s, &load, 1, 0, closed, &of);
            check_motion(&g, &s, row->motion);
            if (i >= N_ROWS)
                check_block(&m, &s, &slot_rows[i - N_ROWS]);
            check_vector(of.FP, row->FP);
            check_vector(of.FQ, row->FQ);
            check_vector(of.FD, row->FD);
            assert_near(of.M, row->M, CLOSE * 100);
            assert_near(f.Ts, row->Ts, CLOSE * (fabs(row->Ts) + fabs(row->FP[0])));
            assert_near(f.Ts_work, row->Ts, CLOSE * (fabs(row->Ts) + fabs(row->FP[0])));
            assert_true(fabs(f.residual) < 1e-12);
            check_pins(&f, row);
        }
}

/* ------------------------------------------------------------------------------------- random machines */

#define MACHINES 4000
#define MOST 3 /* groups of a machine */

typedef struct machine {
    fourlink_design design;
    fourlink_group group[MOST];
    fourlink_load load[MOST + 1];
    fourlink_mechanism mechanism;
    fourlink_branch branch;
    fourlink_crank crank;
    fourlink_state state;
} machine;

static void random_vector(fourlink_vector *v, double size, uint64_t *seed)
{
    set_vector(v, uniform(seed, -size, size), uniform(seed, -size, size));
}

static void random_link(fourlink_link *link, uint64_t *seed)
{
    set_link(link, link->length, uniform(seed, 0.1, 3), uniform(seed, 0.001, 0.1),
             uniform(seed, -0.2, 0.3), uniform(seed, -0.1, 0.1));
}

/* 1 if a link is the block of one of these groups. */
static int is_block(const fourlink_group *groups, int link)
{
    return link > 4 && link % 2 && groups[(link - 5) / 2].hang != FOURLINK_HANGS_BY_ROD;
}

static void random_group(fourlink_group *g, int i, uint64_t *seed)
{
    g->end = uniform(seed, 0, 1) < 0.5 ? FOURLINK_GROUP_SLIDES : FOURLINK_GROUP_TURNS;
    g->link = (int)uniform(seed, 2, 5 + 2 * i);
    g->to = (int)uniform(seed, 0, 5 + 2 * i);
    g->hang = (fourlink_group_hang)uniform(seed, 0, 3);
    if (is_block(g - i, g->link))
        g->link++;
    if (g->end == FOURLINK_GROUP_SLIDES || g->to == g->link || is_block(g - i, g->to) ||
        g->hang != FOURLINK_HANGS_BY_ROD)
        g->to = i % 2;
    g->side = uniform(seed, 0, 1) < 0.5 ? 1 : -1;
    random_vector(&g->at, 0.4, seed);
    random_vector(&g->pivot, 0.8, seed);
    set_direction(&g->direction, 1, uniform(seed, 0, 360));
    g->rod = uniform(seed, 0.2, 1.2);
    g->length = uniform(seed, 0.2, 1.2);
    random_link(&g->body[1], seed);
    g->offset = uniform(seed, -0.1, 0.1);
    set_direction(&g->slot, 1, uniform(seed, 10, 170));
    if (g->hang == FOURLINK_HANGS_BY_ROD)
        random_link(&g->body[0], seed);
    else if (g->end == FOURLINK_GROUP_SLIDES)
        g->side = 1;
}

/* 1 if no P of a slotted rocker is close to its pin, where this is fast. */
static int are_arms_long(const machine *m)
{
    double slide, rate;
    int i, are_long = 1;

    for (i = 0; i < m->design.n_groups; i++)
        if (m->group[i].hang == FOURLINK_HANGS_BY_OWN_SLOT &&
            m->group[i].end == FOURLINK_GROUP_TURNS) {
            flk_group_slide(&m->mechanism, &m->state, i, &slide, &rate);
            are_long &= fabs(slide) > 0.2;
        }
    return are_long;
}

/* 0 if this machine cannot be assembled at this angle. */
static int random_machine(machine *m, uint64_t *seed)
{
    static const fourlink_kind kinds[] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                          FOURLINK_INVERTED_SLIDER_CRANK, FOURLINK_SCOTCH_YOKE};
    fourlink_design *d = &m->design;
    int i;

    memset(m, 0, sizeof *m);
    d->kind = kinds[(int)uniform(seed, 0, 4)];
    d->link[1].length = uniform(seed, 0.75, 0.85);
    d->link[2].length = uniform(seed, 0.1, 0.25);
    d->link[3].length = uniform(seed, 0.6, 0.7);
    d->link[4].length = d->kind == FOURLINK_FOUR_BAR ? uniform(seed, 0.5, 0.6) : 0;
    d->offset = uniform(seed, -0.05, 0.05);
    d->angle = d->kind == FOURLINK_SCOTCH_YOKE ? uniform(seed, 0.6, 2.5) : 0;
    random_vector(&d->gravity, 10, seed);
    for (i = 2; i <= 4; i++)
        random_link(&d->link[i], seed);
    d->group = m->group;
    d->n_groups = 1 + (int)uniform(seed, 0, MOST);
    for (i = 0; i < d->n_groups; i++)
        random_group(&m->group[i], i, seed);
    for (i = 0; i <= MOST; i++) {
        m->load[i].link = (int)uniform(seed, 2, 5 + 2 * d->n_groups);
        m->load[i].link += is_block(m->group, m->load[i].link);
        m->load[i].frame = uniform(seed, 0, 1) < 0.5 ? FOURLINK_FRAME_GROUND : FOURLINK_FRAME_LINK;
        random_vector(&m->load[i].force, 200, seed);
        random_vector(&m->load[i].at, 0.3, seed);
        m->load[i].torque = uniform(seed, -20, 20);
    }
    assert_int_equal(fourlink_prepare(d, &m->mechanism), FOURLINK_OK);
    m->branch = d->kind == FOURLINK_SCOTCH_YOKE || uniform(seed, 0, 1) < 0.5 ? FOURLINK_OPEN
                                                                             : FOURLINK_CROSSED;
    m->crank.theta2 = uniform(seed, -7, 7);
    m->crank.omega2 = uniform(seed, -20, 20);
    m->crank.alpha2 = uniform(seed, -100, 100);
    return fourlink_analyse(&m->mechanism, m->branch, &m->crank, NULL, 0, &m->state, NULL) ==
               FOURLINK_OK &&
           m->state.group_sine > 0.15 && are_arms_long(m);
}

/* The state a little later. */
static void later(const machine *m, double t, fourlink_state *s)
{
    fourlink_crank c = m->crank;

    c.theta2 += c.omega2 * t + c.alpha2 * t * t / 2;
    c.omega2 += c.alpha2 * t;
    assert_int_equal(fourlink_analyse(&m->mechanism, m->branch, &c, NULL, 0, s, NULL), FOURLINK_OK);
}

static double kinetic(const machine *m, const fourlink_state *s)
{
    double energy = 0;
    int i;

    for (i = 2; i <= s->last; i++) {
        const fourlink_link *link =
            i < 5 ? &m->design.link[i] : &m->group[(i - 5) / 2].body[(i - 5) % 2];
        fourlink_vector v;

        fourlink_point(s, i, &link->cg, NULL, &v, NULL);
        energy += link->mass * (v.x * v.x + v.y * v.y) / 2 +
                  link->inertia * s->link[i].omega * s->link[i].omega / 2;
    }
    return energy;
}

/* The power of weights and loads. */
static double power(const machine *m, const fourlink_state *s)
{
    double P = 0;
    int i;

    for (i = 2; i <= s->last; i++) {
        const fourlink_link *link =
            i < 5 ? &m->design.link[i] : &m->group[(i - 5) / 2].body[(i - 5) % 2];
        fourlink_vector v;

        fourlink_point(s, i, &link->cg, NULL, &v, NULL);
        P += link->mass * (v.x * m->design.gravity.x + v.y * m->design.gravity.y);
    }
    for (i = 0; i <= MOST; i++) {
        const fourlink_load *l = &m->load[i];
        const fourlink_link_state *link = &s->link[l->link];
        fourlink_vector v, F = l->force;

        if (l->frame == FOURLINK_FRAME_LINK)
            set_vector(&F, F.x * link->axis.x - F.y * link->axis.y,
                       l->force.x * link->axis.y + l->force.y * link->axis.x);
        fourlink_point(s, l->link, &l->at, NULL, &v, NULL);
        P += F.x * v.x + F.y * v.y + l->torque * link->omega;
    }
    return P;
}

/* Velocities and accelerations are the derivatives of places and of velocities. */
static void check_differences(const machine *m, double step)
{
    fourlink_state a, b;
    const fourlink_state *s = &m->state;
    int i;

    later(m, -step, &a);
    later(m, step, &b);
    for (i = 5; i <= s->last; i++) {
        const fourlink_link_state *x = &a.link[i], *y = &b.link[i], *at = &s->link[i];
        double size = 1 + fabs(at->alpha) + at->omega * at->omega + fabs(at->acceleration.x) +
                      fabs(at->acceleration.y),
               close = 1e-6 * size / pow(m->state.group_sine, 3);
        double turned = x->axis.x * y->axis.y - x->axis.y * y->axis.x;

        assert_near(turned / (2 * step), at->omega, close);
        assert_near((y->omega - x->omega) / (2 * step), at->alpha, 200 * close);
        assert_near((y->origin.x - x->origin.x) / (2 * step), at->velocity.x, close);
        assert_near((y->origin.y - x->origin.y) / (2 * step), at->velocity.y, close);
        assert_near((y->velocity.x - x->velocity.x) / (2 * step), at->acceleration.x, 200 * close);
        assert_near((y->velocity.y - x->velocity.y) / (2 * step), at->acceleration.y, 200 * close);
        assert_near(at->theta, atan2(at->axis.y, at->axis.x), 1e-14);
        assert_near(at->k * m->crank.omega2, at->omega, 1e-13 * size);
    }
}

/* The block is on its pin and on the line of its slot, so far along it as it says, and moves along it so fast. */
static void check_slot(const machine *m, int i)
{
    const fourlink_state *s = &m->state;
    const fourlink_group *g = &m->group[i];
    const fourlink_link_state *block = &s->link[5 + 2 * i], *end = block + 1;
    int is_own = g->hang == FOURLINK_HANGS_BY_OWN_SLOT, slides = g->end == FOURLINK_GROUP_SLIDES;
    int with_slot = is_own ? 6 + 2 * i : g->link, with_pin = is_own ? g->link : 6 + 2 * i;
    fourlink_vector at = {0, 0}, slot = g->slot, place, velocity, P, Q = {0, 0}, v, e, moved;
    double slide, rate, later_slide, h = 1e-6;
    fourlink_state next;

    flk_group_slide(&m->mechanism, s, i, &slide, &rate);
    if (is_own && !slides)
        set_vector(&slot, 1, 0);
    if (is_own)
        set_vector(&at, 0, slides ? 0 : g->offset);
    else
        at = g->at;
    e.x = s->link[with_slot].axis.x * slot.x - s->link[with_slot].axis.y * slot.y;
    e.y = s->link[with_slot].axis.y * slot.x + s->link[with_slot].axis.x * slot.y;
    assert_near(block->axis.x, e.x, 1e-14);
    assert_near(block->axis.y, e.y, 1e-14);
    set_vector(&moved, at.x + slide * slot.x, at.y + slide * slot.y);
    fourlink_point(s, with_slot, &moved, &place, &v, NULL);
    Q.x = is_own ? 0 : slides ? 0 : g->length;
    fourlink_point(s, with_pin, is_own ? &g->at : &Q, &P, &velocity, NULL);
    assert_near(place.x, P.x, 1e-13 * (1 + fabs(slide)));
    assert_near(place.y, P.y, 1e-13 * (1 + fabs(slide)));
    assert_near(block->origin.x, P.x, 1e-14 * (1 + fabs(P.x)));
    assert_near(block->origin.y, P.y, 1e-14 * (1 + fabs(P.y)));
    assert_near(velocity.x - v.x, rate * e.x, 1e-12 * (fabs(v.x) + fabs(v.y) + fabs(rate)));
    assert_near(velocity.y - v.y, rate * e.y, 1e-12 * (fabs(v.x) + fabs(v.y) + fabs(rate)));
    if (slides)
        assert_near(g->direction.x * (end->origin.y - g->pivot.y) -
                        g->direction.y * (end->origin.x - g->pivot.x),
                    0, 1e-13 * (1 + fabs(slide)));
    else {
        assert_near(end->origin.x, g->pivot.x, 0);
        assert_near(end->origin.y, g->pivot.y, 0);
        assert_true(g->side * (e.x * (P.x - g->pivot.x) + e.y * (P.y - g->pivot.y)) > 0);
    }
    later(m, h, &next);
    flk_group_slide(&m->mechanism, &next, i, &later_slide, &rate);
    flk_group_slide(&m->mechanism, s, i, &slide, &rate);
    assert_near((later_slide - slide) / h, rate,
                3e-5 * (1 + fabs(rate) + pow(m->crank.omega2, 2) + fabs(m->crank.alpha2)) /
                    pow(s->group_sine, 3));
}

/* Joints hold: P is on the carrying link, Q on both links, D where it is fixed. */
static void check_joints(const machine *m)
{
    const fourlink_state *s = &m->state;
    int i;

    for (i = 0; i < m->design.n_groups; i++) {
        const fourlink_group *g = &m->group[i];
        const fourlink_link_state *rod = &s->link[5 + 2 * i], *end = rod + 1;
        double r = g->end == FOURLINK_GROUP_TURNS ? g->length : 0, side;
        fourlink_vector P, D = g->pivot, Q;

        if (g->hang != FOURLINK_HANGS_BY_ROD) {
            check_slot(m, i);
            continue;
        }
        fourlink_point(s, g->link, &g->at, &P, NULL, NULL);
        if (g->to > 1)
            fourlink_point(s, g->to, &g->pivot, &D, NULL, NULL);
        set_vector(&Q, rod->origin.x + g->rod * rod->axis.x, rod->origin.y + g->rod * rod->axis.y);
        assert_near(P.x, rod->origin.x, 1e-14);
        assert_near(P.y, rod->origin.y, 1e-14);
        assert_near(Q.x, end->origin.x + r * end->axis.x, 1e-13);
        assert_near(Q.y, end->origin.y + r * end->axis.y, 1e-13);
        side = r > 0 ? (D.x - P.x) * (Q.y - P.y) - (D.y - P.y) * (Q.x - P.x)
                     : g->direction.x * (Q.x - P.x) + g->direction.y * (Q.y - P.y);
        assert_true(side * g->side > 0);
        if (r > 0)
            assert_near(hypot(D.x - end->origin.x, D.y - end->origin.y), 0, 1e-13);
        else
            assert_near(g->direction.x * (Q.y - D.y) - g->direction.y * (Q.x - D.x), 0, 1e-13);
    }
}

/* Newton's and Euler's equations of each link of a group, about its origin, for the forces that are found. */
static void check_forces(const machine *m, const fourlink_forces *F)
{
    flk_group_forces of[2][MOST];
    double size = fabs(F->F12x) + fabs(F->F12y) + fabs(F->F34x) + fabs(F->F34y);
    int i, k, j;

    for (k = 0; k < 2; k++)
        flk_groups_forces(&m->mechanism, &m->state, m->load, MOST + 1, 0, k, of[k]);
    for (i = 0; i < m->design.n_groups; i++) {
        const double *x = (const double *)&of[0][i], *y = (const double *)&of[1][i];

        for (j = 0; j < 7; j++)
            size += fabs(x[j]);
        for (j = 0; j < 7; j++)
            assert_near(x[j], y[j], 1e-12 * size / m->state.group_sine);
    }
}

/* The six equations as they are given hold for the forces that are found, by the names of their unknowns. */
static void check_equations(const machine *m)
{
    flk_group_forces of[MOST];
    int i, k, j;

    flk_groups_forces(&m->mechanism, &m->state, m->load, MOST + 1, 0, 1, of);
    for (i = 0; i < m->design.n_groups; i++) {
        const fourlink_group *g = &m->group[i];
        fourlink_vector e = m->state.link[5 + 2 * i].axis, u = g->direction;
        double A[6][6], b[6], x[6], size = 0, wanted;

        assert_int_equal(
            fourlink_group_system(&m->mechanism, &m->state, m->load, MOST + 1, i, A, b, x),
            FOURLINK_OK);
        for (k = 0; k < 6; k++)
            size += fabs(x[k]) + fabs(b[k]);
        for (k = 0; k < 6; k++) {
            double sum = -b[k];

            for (j = 0; j < 6; j++)
                sum += A[k][j] * x[j];
            assert_near(sum, 0, 1e-12 * size);
        }
        for (k = 0; k < 6; k++) {
            const char *name = fourlink_group_unknown_text(g, k);
            fourlink_vector F = k < 2 ? of[i].FP : k < 4 ? of[i].FQ : of[i].FD;

            wanted = strcmp(name, "S") == 0   ? e.x * F.y - e.y * F.x
                     : strcmp(name, "C") == 0 ? 0
                     : strcmp(name, "N") == 0 ? u.x * F.y - u.y * F.x
                     : strcmp(name, "M") == 0 ? of[i].M
                     : strchr(name, 'x')      ? F.x
                                              : F.y;
            assert_near(x[k], wanted, 1e-11 * size / m->state.group_sine);
        }
    }
}

TEST(test_random_machines)
{
    uint64_t seed = 72;
    int i, n = 0, most = some_of(MACHINES);

    for (i = 0; i < most; i++) {
        machine m;
        fourlink_forces F[2];
        fourlink_state a, b;
        double step = 1e-5, T, Q, size;

        if (!random_machine(&m, &seed))
            continue;
        n++;
        check_joints(&m);
        check_differences(&m, step);
        assert_int_equal(fourlink_solve(&m.mechanism, &m.state, m.load, MOST + 1, &F[0]),
                         FOURLINK_OK);
        assert_int_equal(fourlink_solve_dyad(&m.mechanism, &m.state, m.load, MOST + 1, &F[1]),
                         FOURLINK_OK);
        check_forces(&m, &F[0]);
        check_equations(&m);
        size = fabs(F[0].F12x) + fabs(F[0].F12y) + fabs(F[0].F34x) + fabs(F[0].F34y);
        assert_near(F[0].Ts, F[1].Ts, 1e-12 * (size + fabs(F[0].Ts)) / m.state.group_sine);
        assert_near(F[0].F34x, F[1].F34x, 1e-12 * size / m.state.group_sine);
        assert_true(fabs(F[0].residual) < 1e-11 && fabs(F[1].residual) < 1e-11);
        later(&m, -step, &a);
        later(&m, step, &b);
        T = (kinetic(&m, &b) - kinetic(&m, &a)) / (2 * step);
        Q = power(&m, &m.state);
        assert_near(F[0].Ts * m.crank.omega2, T - Q,
                    1e-4 * (fabs(T) + fabs(Q) + fabs(F[0].Ts * m.crank.omega2)) /
                        m.state.group_sine);
    }
    assert_true(n > most / 8);
}

/* The mechanism with group and load is the mechanism with -FP as a load. */
TEST(test_load_at_P)
{
    uint64_t seed = 5;
    int i;

    for (i = 0; i < some_of(2000); i++) {
        machine m;
        fourlink_forces F, G;
        fourlink_mechanism bare;
        fourlink_load loads[2 * MOST];
        flk_group_forces of[MOST];
        int k, n = 0;

        if (!random_machine(&m, &seed))
            continue;
        for (k = 0; k < m.design.n_groups; k++)
            n += m.group[k].link > 4 || m.group[k].to > 4;
        if (n)
            continue;
        for (k = 0; k <= MOST; k++)
            m.load[k].link = 4 + 2 * m.design.n_groups -
                             (k % 2 && !is_block(m.group, 3 + 2 * m.design.n_groups));
        assert_int_equal(fourlink_solve(&m.mechanism, &m.state, m.load, MOST + 1, &F), FOURLINK_OK);
        flk_groups_forces(&m.mechanism, &m.state, m.load, MOST + 1, 0, 1, of);
        memset(loads, 0, sizeof loads);
        for (k = 0; k < m.design.n_groups; k++) {
            loads[n].link = m.group[k].link;
            loads[n].at = m.group[k].at;
            if (m.group[k].hang == FOURLINK_HANGS_IN_SLOT) {
                double slide, rate;

                flk_group_slide(&m.mechanism, &m.state, k, &slide, &rate);
                loads[n].at.x += slide * m.group[k].slot.x;
                loads[n].at.y += slide * m.group[k].slot.y;
            }
            set_vector(&loads[n++].force, -of[k].FP.x, -of[k].FP.y);
            if (m.group[k].to > 1) {
                loads[n].link = m.group[k].to;
                loads[n].at = m.group[k].pivot;
                set_vector(&loads[n++].force, -of[k].FD.x, -of[k].FD.y);
            }
        }
        m.design.n_groups = 0;
        assert_int_equal(fourlink_prepare(&m.design, &bare), FOURLINK_OK);
        assert_int_equal(
            fourlink_analyse(&bare, m.branch, &m.crank, loads, (unsigned long)n, &m.state, &G),
            FOURLINK_OK);
        assert_near(F.Ts, G.Ts, 1e-11 * (fabs(F.F12x) + fabs(F.F12y) + fabs(F.Ts)));
        assert_near(F.F14x, G.F14x,
                    1e-11 * (fabs(F.F12x) + fabs(F.F12y) + fabs(F.F34x) + fabs(F.F34y)));
    }
}

/* Where a group cannot be assembled nothing is written; its margin changes sign there. */
TEST(test_apart)
{
    fourlink_design d;
    fourlink_group g;
    fourlink_load load;
    fourlink_mechanism m, bare;
    fourlink_state s, untouched;
    fourlink_crank crank = {0.3, 1, 0};
    int i, n_apart = 0, n_there = 0;

    set_case(O3, 1, &d, &g, &load);
    g.length = 0.22;
    g.rod = 0.3;
    assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
    d.n_groups = 0;
    assert_int_equal(fourlink_prepare(&d, &bare), FOURLINK_OK);
    memset(&untouched, 0x5a, sizeof untouched);
    for (i = 0; i < 360; i++) {
        double margin;
        int status;

        crank.theta2 = i * DEG;
        assert_int_equal(fourlink_position(&bare, FOURLINK_OPEN, crank.theta2, &s), FOURLINK_OK);
        margin = flk_groups_margin(&m, &s);
        s = untouched;
        status = fourlink_analyse(&m, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL);
        assert_int_equal(status, margin > 0 ? FOURLINK_OK : FOURLINK_GROUP_APART);
        if (status != FOURLINK_OK) {
            assert_memory_equal(&s, &untouched, sizeof s);
            assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, crank.theta2, &s), status);
            assert_memory_equal(&s, &untouched, sizeof s);
        } else {
            assert_near(s.group_sine * s.group_sine, margin, 1e-14);
        }
        n_apart += status != FOURLINK_OK;
        n_there += status == FOURLINK_OK;
    }
    assert_true(n_apart > 20 && n_there > 20);
}

TEST(test_mistakes)
{
    fourlink_design d;
    fourlink_group g;
    fourlink_load load;
    fourlink_mechanism m;
    fourlink_state s;
    fourlink_forces F;
    fourlink_crank crank = {0.6, 10, 0};

    set_case(O7, 1, &d, &g, &load);
    assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
    assert_int_equal(fourlink_analyse(&m, FOURLINK_OPEN, &crank, &load, 1, &s, &F), FOURLINK_OK);
    load.link = 7;
    assert_int_equal(fourlink_solve(&m, &s, &load, 1, &F), FOURLINK_BAD_LINK);
    assert_int_equal(fourlink_point(&s, 7, &load.at, NULL, NULL, NULL), FOURLINK_BAD_LINK);
    s.last = 4;
    assert_int_equal(fourlink_solve(&m, &s, NULL, 0, &F), FOURLINK_SINGULAR);
    assert_int_equal(fourlink_solve_dyad(&m, &s, NULL, 0, &F), FOURLINK_SINGULAR);
#define REFUSED(change, status)                             \
    do {                                                    \
        set_case(O7, 1, &d, &g, &load);                     \
        change;                                             \
        assert_int_equal(fourlink_prepare(&d, &m), status); \
    } while (0)
    REFUSED(g.link = 1, FOURLINK_BAD_GROUP);
    REFUSED(g.link = 5, FOURLINK_BAD_GROUP);
    REFUSED(g.to = 3, FOURLINK_BAD_GROUP);
    REFUSED(g.to = 6, FOURLINK_BAD_GROUP);
    REFUSED(g.side = 0, FOURLINK_BAD_GROUP);
    REFUSED(g.end = (fourlink_group_end)3, FOURLINK_BAD_GROUP);
    REFUSED(g.end = (fourlink_group_end)0, FOURLINK_BAD_GROUP);
    REFUSED(d.n_groups = 9, FOURLINK_BAD_GROUP);
    REFUSED(d.n_groups = -1, FOURLINK_BAD_GROUP);
    REFUSED(d.group = NULL, FOURLINK_NULL);
    REFUSED(g.rod = 0, FOURLINK_BAD_LENGTH);
    REFUSED(g.length = -1, FOURLINK_BAD_LENGTH);
    REFUSED(g.length = NAN, FOURLINK_BAD_NUMBER);
    REFUSED(g.at.x = 1e300, FOURLINK_BAD_NUMBER);
    REFUSED(g.body[1].mass = -1, FOURLINK_BAD_MASS);
    REFUSED(g.hang = (fourlink_group_hang)3, FOURLINK_BAD_GROUP);
    REFUSED(g.hang = FOURLINK_HANGS_IN_SLOT, FOURLINK_BAD_GROUP);
    REFUSED((g.end = FOURLINK_GROUP_SLIDES, g.to = 0, g.direction.x = 2), FOURLINK_BAD_NUMBER);
}

TEST(test_mistakes_of_slots)
{
    fourlink_design d;
    fourlink_group g[2];
    fourlink_load load;
    fourlink_mechanism m;
    fourlink_state s;
    fourlink_forces F;
    fourlink_crank crank = {0.6, 10, 0};
    double A[6][6], x[6];

#define SLOT_REFUSED(number, change, status)                \
    do {                                                    \
        set_case(number, 1, &d, g, &load);                  \
        change;                                             \
        assert_int_equal(fourlink_prepare(&d, &m), status); \
    } while (0)
    SLOT_REFUSED(O4, g[0].side = -1, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O4, g[0].slot.x = 1.1, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O4, g[0].slot.x = NAN, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O4, g[0].body[0].mass = 1, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O4, g[0].body[0].inertia = 1, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O6, set_vector(&g[0].slot, 1, 0), FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O6, set_vector(&g[0].slot, 0, -1), FOURLINK_OK);
    SLOT_REFUSED(O8, g[0].to = 4, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O8, g[0].offset = NAN, FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O9, g[0].length = 0, FOURLINK_BAD_LENGTH);
    SLOT_REFUSED(O9, (g[1] = g[0], g[1].link = 5, d.n_groups = 2), FOURLINK_BAD_GROUP);
    SLOT_REFUSED(O9, (g[1] = g[0], g[1].link = 6, d.n_groups = 2), FOURLINK_OK);
    SLOT_REFUSED(O4, load.link = 5, FOURLINK_OK);
    assert_int_equal(fourlink_group_system(&m, NULL, NULL, 0, 0, A, x, x), FOURLINK_NULL);
    assert_int_equal(fourlink_analyse(&m, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_group_system(&m, &s, NULL, 0, 1, A, x, x), FOURLINK_BAD_GROUP);
    assert_int_equal(fourlink_group_system(&m, &s, NULL, 0, -1, A, x, x), FOURLINK_BAD_GROUP);
    assert_int_equal(fourlink_group_system(&m, &s, &load, 1, 0, A, x, x), FOURLINK_BAD_LINK);
    assert_string_equal(fourlink_group_unknown_text(g, 6), "unknown");
    assert_string_equal(fourlink_group_unknown_text(NULL, 0), "unknown");
    assert_int_equal(fourlink_analyse(&m, FOURLINK_OPEN, &crank, &load, 1, &s, &F),
                     FOURLINK_BAD_LINK);
}

/* Where the theory says that its pin does not reach the slot. */
TEST(test_short_rocker)
{
    fourlink_design d;
    fourlink_group g;
    fourlink_load load;
    fourlink_mechanism m;
    fourlink_state s;
    int side;

    for (side = -1; side <= 1; side += 2) {
        set_case(O9, side, &d, &g, &load);
        assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
        assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 35 * DEG, &s), FOURLINK_GROUP_APART);
        assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 160 * DEG, &s), FOURLINK_OK);
    }
}

/* A slot of a link turns through the line of its slider twice in a turn: there the slider has no place, and a range ends.
** That of a slotted rocker with an offset ends where P comes as near to its pin. */
TEST(test_ends)
{
    fourlink_design d;
    fourlink_group g;
    fourlink_load load;
    fourlink_mechanism m;
    fourlink_state s;
    double ends[4], slide, rate;
    flk_range ranges[4];
    size_t i, n;

    set_case(O4, 1, &d, &g, &load);
    g.link = 2;
    set_direction(&g.slot, 1, 20);
    assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
    n = flk_groups_ends(&m, FOURLINK_OPEN, 2 * PI, ends, 4);
    assert_int_equal(n, 2);
    assert_near(ends[0], 70 * DEG, 1e-12);
    assert_near(ends[1], 250 * DEG, 1e-12);
    assert_int_equal(flk_groups_ranges(&m, FOURLINK_OPEN, ranges, 4), 2);
    assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 70 * DEG, &s), FOURLINK_DEAD_POSITION);
    assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 70.001 * DEG, &s), FOURLINK_OK);
    set_case(O8, 1, &d, &g, &load);
    g.offset = 0.4;
    assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
    n = flk_groups_ends(&m, FOURLINK_OPEN, 2 * PI, ends, 4);
    assert_int_equal(n, 2);
    for (i = 0; i < n; i++) {
        int ahead = fourlink_position(&m, FOURLINK_OPEN, ends[i] + 1e-6, &s) == FOURLINK_OK;

        assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, ends[i] - (ahead ? 1e-6 : -1e-6), &s),
                         FOURLINK_GROUP_APART);
        assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, ends[i] + (ahead ? 1e-6 : -1e-6), &s),
                         FOURLINK_OK);
        flk_group_slide(&m, &s, 0, &slide, &rate);
        assert_true(fabs(slide) < 0.002);
    }
}

/* Where a slot of a link passes through the line, the margin touches 0 and may be found there, too: an end stands once, of
** the same linkage in 600 sizes. */
TEST(test_ends_once)
{
    static const double lengths[] = {0.10938, 0.08375142, 0.096485, 0.133093};
    fourlink_design d;
    fourlink_group g;
    fourlink_load load;
    fourlink_mechanism m;
    flk_range ranges[4];
    int k, i;

    for (k = 0; k < 600; k++) {
        double size = 0.5 + 0.00137 * k;

        set_case(O4, 1, &d, &g, &load);
        d.kind = FOURLINK_FOUR_BAR;
        d.offset = 0;
        for (i = 0; i < 4; i++)
            d.link[FOURLINK_GROUND + i].length = size * lengths[i];
        g.link = FOURLINK_FOLLOWER;
        g.at.x = 0.009 * size;
        g.at.y = 0.004 * size;
        g.pivot.x = 0.02 * size;
        g.pivot.y = 0.01 * size;
        set_direction(&g.direction, 1, 15);
        set_direction(&g.slot, 1, 25);
        assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
        assert_int_equal(flk_groups_ranges(&m, FOURLINK_CROSSED, ranges, 4), 2);
    }
}

/* A slot that turns through the line close to a dead position of the four links, 0.06 to 6e-6 deg from it: of 2,000 rockers on the
** coupler. */
TEST(test_ends_beside_dead_positions)
{
    uint64_t seed = 68;
    int tried = 0, k;

    while (tried < 2000) {
        fourlink_design d;
        fourlink_group g;
        fourlink_load load;
        fourlink_mechanism m;
        fourlink_reach reach;
        fourlink_state s;
        double ends[8], at, apart = INFINITY;
        size_t n, i;

        set_case(O4, 1, &d, &g, &load);
        d.kind = FOURLINK_FOUR_BAR;
        d.offset = 0;
        for (k = 0; k < 4; k++)
            d.link[FOURLINK_GROUND + k].length = uniform(&seed, 0.05, 0.15);
        d.n_groups = 0;
        if (fourlink_prepare(&d, &m) != FOURLINK_OK ||
            fourlink_reach_of(&m, &reach) != FOURLINK_OK || reach.to[0] - reach.from[0] > 6)
            continue;
        at = reach.to[0] - pow(10, uniform(&seed, -7, -3));
        assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, at, &s), FOURLINK_OK);
        g.link = FOURLINK_COUPLER;
        g.at.x = g.at.y = 0.01;
        g.pivot.x = 0.02;
        g.pivot.y = 0.01;
        set_direction(&g.direction, 1, 15);
        /* the slot in the coupler's axes: the line, turned back by theta3 */
        g.slot.x = g.direction.x * s.link[3].axis.x + g.direction.y * s.link[3].axis.y;
        g.slot.y = g.direction.y * s.link[3].axis.x - g.direction.x * s.link[3].axis.y;
        d.n_groups = 1;
        assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
        n = flk_groups_ends(&m, FOURLINK_OPEN, 2 * PI, ends, 8);
        for (i = 0; i < n; i++)
            apart = fmin(apart, fabs(remainder(ends[i] - at, 2 * PI)));
        if (!(apart < 1e-12))
            fail_msg("deck %d: the end at %.12g is missed by %g", tried, at, apart);
        tried++;
    }
}

/* Strokes and swings of the theory, and its greatest angles. */
TEST(test_limits)
{
    static const struct {
        int number, side;
        double least, least_at, most, most_at, ratio;
    } wanted[] = {
        {O4, 1, -0.24003967926, 293.578178478, 0.24003967926, 66.4218215218, 1.70995278172},
        {O6, 1, -0.266284688417, 293.578178478, 0.229715311583, 66.4218215218, 1.70995278172},
        {O8, 1, -67.5350199466 * DEG, 237.288296566, -34.5739618593 * DEG, 60.9103893126,
         1.04107195514},
        {O8, -1, 121.114495083 * DEG, 242.247526484, 154.200413764 * DEG, 64.9960381882,
         1.0310125656}};
    size_t i;

    for (i = 0; i < sizeof wanted / sizeof wanted[0]; i++) {
        fourlink_design d;
        fourlink_group g;
        fourlink_load load;
        fourlink_mechanism m;
        flk_group_limits found;

        set_case(wanted[i].number, wanted[i].side, &d, &g, &load);
        assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
        assert_int_equal(flk_group_limits_find(&m, FOURLINK_OPEN, 0, &found), 1);
        assert_near(found.least, wanted[i].least, CLOSE);
        assert_near(found.most, wanted[i].most, CLOSE);
        assert_near(found.least_at, wanted[i].least_at * DEG, 1e-8);
        assert_near(found.most_at, wanted[i].most_at * DEG, 1e-8);
        assert_near(found.time_ratio, wanted[i].ratio, 1e-8);
    }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
