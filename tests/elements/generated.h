/* Written by generate.py with SymPy. */

static void shapes(double s, double *to) {
    const double x0 = pow(s, 2);
    const double x1 = E(315, s*(x0 - 3), s*(x0 + 3));
    const double x2 = 1.0/F(314, 2);
    const double x3 = (1.0/4.0)*x2;
    const double x4 = x0 - 1;
    const double x5 = 3*s;
    const double x6 = (3.0/2.0)*s;
    to[0] = (1.0/4.0)*x1 + 1.0/2.0;
    to[1] = x3*(s*(s*(s - 1) - 1) + 1);
    to[2] = 1.0/2.0 - 1.0/4.0*x1;
    to[3] = (1.0/4.0)*(s*(s*(s + 1) - 1) - 1);
    to[4] = (3.0/4.0)*x4;
    to[5] = x3*(s*(x5 - 2) - 1);
    to[6] = -3.0/4.0*x4;
    to[7] = (1.0/4.0)*s*(x5 + 2) - 1.0/4.0;
    to[8] = x6;
    to[9] = (1.0/2.0)*x2*(x5 - 1);
    to[10] = -x6;
    to[11] = (1.0/2.0)*x5 + 1.0/2.0;
    to[12] = 3.0/2.0;
    to[13] = (3.0/2.0)*x2;
    to[14] = -3.0/2.0;
    to[15] = 3.0/2.0;
}

static void matrix(const double *g, double *to) {
    const double x0 = -F(307, -1)*(g[12]*g[3] + g[13]*g[4] + E(317, g[14]*g[5], g[14]*g[4]));
    to[0] = F(301, 2)*g[0]*g[6] + E(316, F(301, 2)*g[1]*g[7], F(301, 2)*g[1]*g[6]) + F(301, 2)*g[2]*g[8] + pow(g[3], 2) + pow(g[4], 2) + pow(g[5], 2);
    to[1] = x0;
    to[2] = x0;
    to[3] = F(307, -1)*(-F(304, 0)*g[0]*g[15] - F(304, 0)*g[16]*g[1] - F(304, 0)*g[17]*g[2] + F(307, -1)*pow(g[12], 2) + F(307, -1)*pow(g[13], 2) + F(307, -1)*pow(g[14], 2));
}

static void first_right(const double *g, const double *u, double *to) {
    const double x0 = F(307, -1)*u[9] - u[0];
    const double x1 = F(307, -1)*u[10] - u[1];
    const double x2 = F(307, -1)*u[11] - u[2];
    to[0] = -g[0]*u[3] - E(318, g[1]*u[4], g[1]*u[3]) - g[2]*u[5] + g[3]*x0 + g[4]*x1 + g[5]*x2;
    to[1] = (F(307, -1)*F(308, 0) - F(308, 0) + 1)*(F(306, 0)*g[0]*u[12] + F(306, 0)*g[1]*u[13] + F(306, 0)*g[2]*u[14] - g[12]*x0 - g[13]*x1 - E(319, g[14]*x2, g[13]*x2));
}

static void first(const double *g, const double *u, double p, double r, double moved, double moved_bar, double *to) {
    const double x0 = sqrt(pow(g[3], 2) + pow(g[4], 2) + pow(g[5], 2));
    const double x1 = F(301, 2)*F(310, 0)*p;
    const double x2 = (g[3]*(g[6]*x1 + u[3]) + g[4]*(E(320, g[7]*x1 + u[4], g[7]*x1 - u[4])) + g[5]*(g[8]*x1 + u[5]))/x0;
    const double x3 = sqrt(pow(g[12], 2) + pow(g[13], 2) + pow(g[14], 2));
    const double x4 = F(304, 0)*r;
    const double x5 = (g[12]*(F(306, 0)*u[12] + g[15]*x4) + g[13]*(F(306, 0)*u[13] + g[16]*x4) + g[14]*(F(306, 0)*u[14] + g[17]*x4))/x3;
    const double x6 = F(312, 0) - 1;
    to[0] = (F(313, 0)*g[2]*(-F(307, -1)*(g[14]*r + u[11]) + g[5]*p + u[2]) + g[0]*(-F(307, -1)*(g[12]*r + u[9]) + g[3]*p + u[0]) + g[1]*(-F(307, -1)*(g[13]*r + u[10]) + g[4]*p + u[1]))/sqrt(F(313, 0)*pow(g[2], 2) + pow(g[0], 2) + pow(g[1], 2));
    to[1] = x2;
    to[2] = x5;
    to[3] = F(311, 0)*p*x0 + E(321, moved*x2, moved*x0);
    to[4] = moved_bar*(F(312, 0)*x5 - x2*x6) + r*(F(312, 0)*x3 - x0*x6);
}

static void second_right(const double *g, const double *u, const double *w, double p, double q, double r, double t, double *to) {
    const double x0 = F(303, 0)*p;
    const double x1 = F(309, 0)*q;
    const double x2 = F(303, 0)*x1;
    const double x3 = F(302, 0)*p*x1;
    const double x4 = F(301, 2)*p;
    const double x5 = g[6]*x4;
    const double x6 = -F(307, -1)*(g[12]*t + w[9]) + g[3]*x1 + w[0];
    const double x7 = g[7]*x4;
    const double x8 = -F(307, -1)*(g[13]*t + w[10]) + g[4]*x1 + w[1];
    const double x9 = g[8]*x4;
    const double x10 = -F(307, -1)*(g[14]*t + w[11]) + g[5]*x1 + w[2];
    const double x11 = F(301, 2)*x1;
    const double x12 = -F(307, -1)*(g[12]*r + u[9]) + g[3]*p + u[0];
    const double x13 = -F(307, -1)*(g[13]*r + u[10]) + g[4]*p + u[1];
    const double x14 = -F(307, -1)*(g[14]*r + u[11]) + g[5]*p + u[2];
    const double x15 = F(306, 0)*w[12];
    const double x16 = F(306, 0)*u[12];
    const double x17 = F(304, 0)*r;
    const double x18 = g[15]*x17;
    const double x19 = -F(307, -1)*(r*x15 + t*x16 + t*x18) + p*w[3] + u[3]*x1 + x1*x5;
    const double x20 = F(306, 0)*w[13];
    const double x21 = F(306, 0)*u[13];
    const double x22 = g[16]*x17;
    const double x23 = -F(307, -1)*(r*x20 + t*x21 + t*x22) + E(322, p*w[4] + u[4]*x1, p*w[4]) + x1*x7;
    const double x24 = F(306, 0)*w[14];
    const double x25 = F(306, 0)*u[14];
    const double x26 = g[17]*x17;
    const double x27 = -F(307, -1)*(r*x24 + t*x25 + t*x26) + p*w[5] + u[5]*x1 + x1*x9;
    const double x28 = g[12]*x19 + g[13]*x23 + g[14]*x27;
    const double x29 = F(305, -1)*r*t;
    const double x30 = F(304, 0)*t;
    to[0] = -g[0]*(g[9]*x3 + u[6]*x2 + w[6]*x0) - g[1]*(g[10]*x3 + u[7]*x2 + w[7]*x0) - g[2]*(E(324, g[11]*x3, g[10]*x3) + u[8]*x2 + w[8]*x0) - g[3]*x19 - g[4]*x23 - g[5]*x27 - x10*(u[5] + x9) - E(325, x12*(g[6]*x11 + w[3]), x6*(g[6]*x11 + w[3])) - x13*(g[7]*x11 + w[4]) - x14*(g[8]*x11 + w[5]) - x6*(u[3] + x5) - x8*(u[4] + x7);
    to[1] = F(307, -1)*F(308, 0)*(g[0]*(E(323, g[18]*x29, g[19]*x29) + r*w[15] + t*u[15]) + g[1]*(g[19]*x29 + r*w[16] + t*u[16]) + g[2]*(g[20]*x29 + r*w[17] + t*u[17]) + x10*(x25 + x26) + x12*(g[15]*x30 + x15) + x13*(g[16]*x30 + x20) + x14*(g[17]*x30 + x24) + x28 + x6*(x16 + x18) + x8*(x21 + x22)) - (F(308, 0) - 1)*(x10*x25 + x12*x15 + x13*x20 + x14*x24 + x16*x6 + x21*x8 + x28);
}

static void second(const double *g, const double *u, const double *w, double p, double q, double pq, double r, double t, double rt, double moved, double moved_bar, double *to) {
    const double x0 = F(313, 0)*pow(g[2], 2) + pow(g[0], 2) + pow(g[1], 2);
    const double x1 = -F(307, -1)*(g[12]*r + u[9]) + g[3]*p + u[0];
    const double x2 = -F(307, -1)*(g[12]*t + w[9]) + g[3]*q + w[0];
    const double x3 = -F(307, -1)*(g[13]*r + u[10]) + g[4]*p + u[1];
    const double x4 = -F(307, -1)*(g[13]*t + w[10]) + g[4]*q + w[1];
    const double x5 = -F(307, -1)*(g[14]*r + u[11]) + g[5]*p + u[2];
    const double x6 = -F(307, -1)*(g[14]*t + w[11]) + g[5]*q + w[2];
    const double x7 = F(301, 2)*p;
    const double x8 = q*x7;
    const double x9 = F(306, 0)*w[12];
    const double x10 = F(306, 0)*u[12];
    const double x11 = F(304, 0)*g[15];
    const double x12 = r*x11;
    const double x13 = F(306, 0)*w[13];
    const double x14 = F(306, 0)*u[13];
    const double x15 = F(304, 0)*g[16];
    const double x16 = r*x15;
    const double x17 = F(306, 0)*w[14];
    const double x18 = F(306, 0)*u[14];
    const double x19 = F(304, 0)*g[17];
    const double x20 = r*x19;
    const double x21 = F(313, 0)*g[2];
    const double x22 = pow(g[3], 2) + pow(g[4], 2) + pow(g[5], 2);
    const double x23 = sqrt(x22);
    const double x24 = 1.0/x23;
    const double x25 = F(310, 0)*g[6];
    const double x26 = u[3] + x25*x7;
    const double x27 = F(310, 0)*g[7];
    const double x28 = u[4] + x27*x7;
    const double x29 = F(310, 0)*g[8];
    const double x30 = u[5] + x29*x7;
    const double x31 = g[3]*x26 + g[4]*x28 + g[5]*x30;
    const double x32 = F(301, 2)*q;
    const double x33 = w[3] + x25*x32;
    const double x34 = w[4] + x27*x32;
    const double x35 = w[5] + x29*x32;
    const double x36 = g[3]*x33 + g[4]*x34 + g[5]*x35;
    const double x37 = E(326, x31*x36, x31*x31);
    const double x38 = F(301, 2)*pq;
    const double x39 = F(303, 0)*p;
    const double x40 = F(303, 0)*q;
    const double x41 = F(302, 0)*F(310, 0)*p*q;
    const double x42 = F(310, 0)*g[3]*(g[6]*x38 + g[9]*x41 + u[6]*x40 + w[6]*x39) + F(310, 0)*g[4]*(g[10]*x41 + g[7]*x38 + u[7]*x40 + w[7]*x39) + F(310, 0)*g[5]*(g[11]*x41 + g[8]*x38 + u[8]*x40 + w[8]*x39) + x26*x33 + x28*x34 + x30*x35;
    const double x43 = pow(g[12], 2) + pow(g[13], 2) + pow(g[14], 2);
    const double x44 = sqrt(x43);
    const double x45 = 1.0/x44;
    const double x46 = x10 + x12;
    const double x47 = x14 + x16;
    const double x48 = x18 + x20;
    const double x49 = g[12]*x46 + g[13]*x47 + g[14]*x48;
    const double x50 = t*x11 + x9;
    const double x51 = t*x15 + x13;
    const double x52 = t*x19 + x17;
    const double x53 = g[12]*x50 + g[13]*x51 + g[14]*x52;
    const double x54 = x49*x53;
    const double x55 = F(304, 0)*rt;
    const double x56 = F(305, -1)*r*t;
    const double x57 = g[12]*(g[15]*x55 + g[18]*x56 + r*w[15] + t*u[15]) + g[13]*(g[16]*x55 + g[19]*x56 + r*w[16] + t*u[16]) + g[14]*(g[17]*x55 + g[20]*x56 + r*w[17] + t*u[17]) + E(329, x46*x50, x46*x46) + x47*x51 + x48*x52;
    const double x58 = F(311, 0)*x24;
    const double x59 = x37/pow(x22, 3.0/2.0);
    const double x60 = x24*x42;
    const double x61 = F(312, 0) - 1;
    const double x62 = F(312, 0)*x45;
    const double x63 = x24*x61;
    to[0] = (F(313, 0)*x5*x6 + g[0]*(-F(307, -1)*(g[12]*rt + r*x9 + t*x10 + t*x12) + g[3]*pq + g[6]*x8 + p*w[3] + q*u[3]) + g[1]*(-F(307, -1)*(g[13]*rt + r*x13 + t*x14 + t*x16) + g[4]*pq + g[7]*x8 + p*w[4] + q*u[4]) + x1*x2 + x21*(-F(307, -1)*(g[14]*rt + r*x17 + t*x18 + t*x20) + g[5]*pq + g[8]*x8 + p*w[5] + q*u[5]) + x3*x4 - (g[0]*x1 + g[1]*x3 + x21*x5)*(g[0]*x2 + g[1]*x4 + x21*x6)/x0)/sqrt(x0);
    to[1] = x24*(E(328, x42 - x37/x22, x42 - x37));
    to[2] = x45*(E(327, x57 - x54/x43, x57 + x54/x43));
    to[3] = F(311, 0)*pq*x23 - moved*x59 + moved*x60 + E(330, p*x36*x58, q*x36*x58) + q*x31*x58;
    to[4] = moved_bar*(-F(312, 0)*x54/pow(x43, 3.0/2.0) + x57*x62 + x59*x61 - x60*x61) + r*(-x36*x63 + x53*x62) + rt*(F(312, 0)*x44 - x23*x61) + t*(-x31*x63 + x49*x62);
}
